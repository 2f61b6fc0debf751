"""What a run or a re-timing tells."""

import io
import json
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Callable

import numpy


def table(csv: str) -> numpy.ndarray:
    """A structured array with the columns of a table, each of the type that its cells have."""
    return numpy.atleast_1d(numpy.genfromtxt(io.StringIO(csv), delimiter=",", names=True, dtype=None, encoding="utf-8",
                                             deletechars="", replace_space=" ", comments=None))


def to_pandas(array: numpy.ndarray) -> Any:
    """The same table as a pandas.DataFrame. ImportError without pandas, which nothing else needs."""
    import pandas

    return pandas.DataFrame.from_records(array)


@dataclass(frozen=True)
class Result:
    """Figures of a run, or of a re-timing, which are the same (docs/formats.md has the columns)."""

    total_cycles: int
    """0 if it deadlocked."""
    milliseconds: float
    deadlock_report: str = field(repr=False)
    """Who waits for whom; empty if the run ended."""
    _text: Callable[[str], str] = field(repr=False)
    """Of "summary", "samples", "fifos" or "loops", as the files have it."""

    @property
    def deadlocked(self) -> bool:
        return bool(self.deadlock_report)

    @cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json: configuration, totals, modules, FIFOs, block RAMs, loops."""
        return json.loads(self._text("summary"))

    @cached_property
    def samples(self) -> numpy.ndarray:
        """samples.csv: a row per pose sample."""
        return table(self._text("samples"))

    @cached_property
    def fifos(self) -> numpy.ndarray:
        """fifos.csv: a row per FIFO of each core."""
        return table(self._text("fifos"))

    @cached_property
    def loops(self) -> numpy.ndarray:
        """loops.csv: a row per loop of each core."""
        return table(self._text("loops"))
