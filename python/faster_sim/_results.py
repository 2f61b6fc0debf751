"""What a run, a re-timing or another command tells."""

import html
import json
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Callable, Mapping

from faster_sim import _plots, _tables
from faster_sim._tables import Table


@dataclass(frozen=True, eq=False)
class Result:
    """Figures of a run, or of a re-timing, which are the same (docs/formats.md has the columns)."""

    total_cycles: int
    milliseconds: float
    _text: Callable[[str], str] = field(repr=False)
    """Of "summary", "samples", "fifos" or "loops", as the files have it."""
    text: str = field(repr=False, default="")
    """The report that the program printed; empty of what was re-timed in this process."""

    def __reduce__(self) -> Any:
        names = ("summary", "samples", "fifos", "loops")
        return (_unpickled, (self.total_cycles, self.milliseconds, {name: self._text(name) for name in names}, self.text))

    @cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json: configuration, totals, modules, FIFOs, block RAMs, loops."""
        return dict(json.loads(self._text("summary")))

    @cached_property
    def samples(self) -> Table:
        """samples.csv: a row per sample."""
        return _tables.of_csv(self._text("samples"))

    @cached_property
    def fifos(self) -> Table:
        """fifos.csv: a row per FIFO of each core."""
        return _tables.of_csv(self._text("fifos"))

    @cached_property
    def loops(self) -> Table:
        """loops.csv: a row per loop of each core."""
        return _tables.of_csv(self._text("loops"))

    @cached_property
    def modules(self) -> Table:
        """A row per module of each core: where its cycles went."""
        return _tables.of_rows(self.summary["modules"])

    @property
    def bound_by(self) -> list[str]:
        """In sentences, what the run is bound by."""
        return list(self.summary["bound_by"])

    @cached_property
    def critical_path(self) -> Table:
        """Where the cycles of the total passed, the most first. Of run(..., critical_path=True), and whatif likewise."""
        return _tables.of_rows(self._asked("critical_path")["rows"])

    @cached_property
    def hazards(self) -> Table:
        """Where iterations read what others have yet to write. Of run(..., hazards=True)."""
        return _tables.of_rows(self._asked("hazards"))

    def plot_stalls(self, axes: Any = None) -> Any:
        """Where the cycles of each module went, of all cores together, with matplotlib. Returns the axes."""
        return _plots.stalls(self.summary, axes)

    def plot_dataflow(self, axes: Any = None) -> Any:
        """Modules and the FIFOs between them, wide where they stall, with matplotlib. Returns the axes."""
        return _plots.dataflow(self.summary, axes)

    def _repr_html_(self) -> str:
        total = f"<p><b>{self.total_cycles:,} cycles</b>, {self.milliseconds:.3f} ms</p>"
        bound = "".join(f"<li>{html.escape(sentence)}</li>" for sentence in self.bound_by)
        return f"{total}<ul>{bound}</ul>{self.modules._repr_html_()}"

    def _asked(self, name: str) -> Any:
        if name not in self.summary:
            raise KeyError(f"{name} was not asked for: run(..., {name}=True)")
        return self.summary[name]


def _unpickled(total_cycles: int, milliseconds: float, texts: Mapping[str, str], text: str) -> Result:
    return Result(total_cycles, milliseconds, texts.__getitem__, text)


@dataclass(frozen=True, eq=False)
class Answer:
    """What a command found: its JSON, its tables by name (answer["scores"]), and what it printed."""

    summary: dict[str, Any]
    tables: Mapping[str, Table] = field(repr=False)
    text: str = field(repr=False)

    def __getitem__(self, name: str) -> Table:
        return self.tables[name]

    def _repr_html_(self) -> str:
        return next((table._repr_html_() for table in self.tables.values()), f"<pre>{html.escape(self.text)}</pre>")


@dataclass(frozen=True, eq=False)
class Check(Answer):
    """Whether budgets are kept: true if all are."""

    @property
    def passed(self) -> bool:
        return bool(self.summary["passed"])

    def __bool__(self) -> bool:
        return self.passed
