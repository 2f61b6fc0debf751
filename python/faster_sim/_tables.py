"""Tables: CSV and JSON rows as NumPy arrays that say where there is no figure."""

import csv
import html
import io
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence

import numpy

# Columns that are text whatever their cells look like. Cells of all others tell: whole numbers, numbers, booleans, text.
_TEXT = {"fifo", "kind", "module", "loop", "limited_by", "status", "message", "key", "value", "changed_value", "bram", "cause",
         "item", "budget", "figure", "limit", "method", "object"}
_ROWS_SHOWN = 20


class Table(numpy.ma.MaskedArray):
    """A structured array with a name per column. A cell without a figure is masked: it is None in `.tolist()`, NaN or NA in
    a data frame, and no minimum or mean counts it. A notebook shows it as a table."""

    def _repr_html_(self) -> str:
        if self.dtype.names is None:
            return f"<pre>{html.escape(repr(self))}</pre>"
        rows = numpy.atleast_1d(self)
        head = "".join(f"<th>{html.escape(name)}</th>" for name in self.dtype.names)
        body = "".join("<tr>" + "".join(f"<td>{_shown(cell)}</td>" for cell in row) + "</tr>"
                       for row in rows[:_ROWS_SHOWN].tolist())
        more = f"<p>{len(rows) - _ROWS_SHOWN} more rows</p>" if len(rows) > _ROWS_SHOWN else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"


def of_csv(text: str) -> Table:
    """A table as the program writes it, header first; quoted cells and empty ones are known."""
    lines = list(csv.reader(io.StringIO(text, newline="")))
    names, rows = lines[0], lines[1:]
    return of_columns({name: _column(name, [row[i] for row in rows]) for i, name in enumerate(names)})


def of_rows(rows: Sequence[Mapping[str, Any]], names: Optional[Iterable[str]] = None) -> Table:
    """Rows of JSON; null is no figure, what is no cell (a list, an object) is left out."""
    columns = list(names) if names is not None else list(dict.fromkeys(
        name for row in rows for name, cell in row.items() if not isinstance(cell, (list, dict))))
    return of_columns({name: of_cells([row.get(name) for row in rows]) for name in columns})


def of_columns(columns: Mapping[str, numpy.ma.MaskedArray]) -> Table:
    size = len(next(iter(columns.values()))) if columns else 0
    table = numpy.ma.empty(size, dtype=[(name, column.dtype) for name, column in columns.items()]).view(Table)
    for name, column in columns.items():
        table[name] = column
    return table


def of_cells(cells: Sequence[Any], if_empty: Any = float) -> numpy.ma.MaskedArray:
    """Values of one column, None where there is none."""
    mask = [cell is None for cell in cells]
    there = [cell for cell in cells if cell is not None]
    array = numpy.array(there) if there else numpy.empty(0, dtype=if_empty)
    if array.ndim != 1 or array.dtype.hasobject or (array.dtype.kind == "U" and not all(isinstance(cell, str) for cell in there)):
        array = numpy.array([str(cell) for cell in there])
    values = numpy.zeros(len(cells), dtype=array.dtype)
    if array.dtype.kind in "if":  # what lies under the mask is nothing that a search for the least would pick
        values[:] = numpy.nan if array.dtype.kind == "f" else numpy.iinfo(array.dtype).max
    values[[not masked for masked in mask]] = array
    return numpy.ma.array(values, mask=mask)


def to_pandas(table: numpy.ndarray) -> Any:
    """The table as a pandas.DataFrame, NA or NaN where there is no figure. ImportError without pandas, which nothing else
    needs."""
    import pandas

    return pandas.DataFrame({name: _series(pandas, numpy.ma.asarray(table[name])) for name in table.dtype.names or ()})


def _series(pandas: Any, column: numpy.ma.MaskedArray) -> Any:
    if not numpy.ma.is_masked(column):
        return pandas.Series(column.data)
    kinds = {"i": "Int64", "u": "UInt64", "b": "boolean", "f": "float64"}
    return pandas.Series([numpy.nan if column.dtype.kind == "f" and cell is None else cell for cell in column.tolist()],
                         dtype=kinds.get(column.dtype.kind, "object"))


def _column(name: str, cells: list[str]) -> numpy.ma.MaskedArray:
    if name in _TEXT:
        return numpy.ma.array(numpy.array(cells, dtype=str if cells else "U1"), mask=False)
    for read in (_integer, _number, _boolean):
        values = [None if cell == "" else read(cell) for cell in cells]
        if all(value is not None for value, cell in zip(values, cells) if cell != ""):
            return of_cells(values, numpy.int64 if name.endswith("_cycles") else float)
    return numpy.ma.array(numpy.array(cells), mask=[cell == "" for cell in cells])


def _integer(cell: str) -> Optional[int]:
    digits = cell[1:] if cell[0] in "+-" else cell
    return int(cell) if digits.isascii() and digits.isdigit() else None


def _number(cell: str) -> Optional[float]:
    return _or_none(float, cell)


def _boolean(cell: str) -> Optional[bool]:
    return {"true": True, "false": False}.get(cell)


def _or_none(read: Callable[[str], float], cell: str) -> Optional[float]:
    try:
        return read(cell)
    except ValueError:
        return None


def _shown(cell: Any) -> str:
    if cell is None:
        return "-"
    return f"{cell:,}" if isinstance(cell, int) and not isinstance(cell, bool) else html.escape(str(cell))
