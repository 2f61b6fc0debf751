"""Recorded runs, re-timed in this process."""

import json
import os
from typing import Any, Mapping, Optional, Sequence

import numpy

from faster_sim import _core, _program
from faster_sim._program import Progress
from faster_sim._results import Result, table
from faster_sim._run import Path_


class Events:
    """An event file: all that a run did, without the time it took. Gives the cycles of any timing without running again.

    Values are those of the keys that decide about time alone; InputError for any other, saying why.
    """

    def __init__(self, path: Path_) -> None:
        self._core = _core.Events(os.fspath(path))

    def __repr__(self) -> str:
        return f"Events({self._core.path!r})"

    @property
    def config(self) -> dict[str, Any]:
        """Every key with its value, of the recorded run."""
        return json.loads(self._core.config)

    @property
    def summary(self) -> dict[str, Any]:
        """summary.json of the recorded run."""
        return json.loads(self._core.recorded_summary)

    def whatif(self, values: Mapping[str, object] = {}, /, **more: object) -> Result:
        """What the run would have taken with other values of some keys. A deadlock is a result."""
        retimed = self._core.retime(_program.overrides({**values, **more}))
        return Result(retimed.total_cycles, retimed.milliseconds, retimed.deadlock_report,
                      lambda name: getattr(retimed, name))

    def whatif_matrix(self, configurations: Sequence[Mapping[str, object]], *,
                      progress: Optional[Progress] = None) -> numpy.ndarray:
        """A row for each configuration, on all host cores: the keys that any of them names, deadlocked, total_cycles
        (0 if deadlocked) and milliseconds."""
        rows = [dict(values) for values in configurations]
        found = self._core.retime_many([_program.overrides(row) for row in rows], progress)
        keys = list(dict.fromkeys(key for row in rows for key in row))
        recorded = self.config
        columns = {key: numpy.array([row.get(key, recorded.get(key)) for row in rows]) for key in keys}
        columns["deadlocked"] = numpy.array([cycles is None for cycles, _ in found], dtype=bool)
        columns["total_cycles"] = numpy.array([cycles or 0 for cycles, _ in found], dtype=numpy.int64)
        columns["milliseconds"] = numpy.array([(cycles or 0) / (mhz * 1e3) for cycles, mhz in found], dtype=float)
        array = numpy.empty(len(rows), dtype=[(name, column.dtype) for name, column in columns.items()])
        for name, column in columns.items():
            array[name] = column
        return array

    def sensitivities(self, values: Mapping[str, object] = {}, /, *,
                      progress: Optional[Progress] = None) -> numpy.ndarray:
        """How many cycles one step of each timing key changes (sensitivities.csv)."""
        return table(self._core.sensitivities(_program.overrides(values), progress))

    def size_fifos(self, within_percent: float, values: Mapping[str, object] = {}, /, *, front_points: int = 0,
                   jobs: int = 0, progress: Optional[Progress] = None) -> dict[str, Any]:
        """The cheapest FIFO depths with which the run takes at most so much longer than with unbounded ones
        (sizing.json)."""
        return json.loads(self._core.size_fifos(_program.overrides(values), within_percent, front_points, jobs, progress))


def load_events(path: Path_) -> Events:
    """The events of `faster-sim run --events`. InputError for any other file."""
    return Events(path)


def record(config: Path_, path: Path_, *, progress: Optional[Progress] = None, **values: object) -> Events:
    """Runs a configuration and keeps its events in a file."""
    _program.call(["run", os.fspath(config), "--events", os.fspath(path), *_program.settings(values)], progress)
    return Events(path)
