"""Recorded runs, re-timed."""

import json
import os
import re
import tempfile
from functools import cached_property
from pathlib import Path
from typing import Any, Iterable, Mapping, NamedTuple, Optional, Protocol, Sequence

import numpy

from faster_sim import _core, _program, _tables, _values
from faster_sim._errors import DeadlockError, InputError, ProgramError
from faster_sim._folders import result_in
from faster_sim._program import DEFAULT, EXIT_DONE, Path_, Progress
from faster_sim._results import Result
from faster_sim._tables import Table


class Retimed(NamedTuple):
    """A row of a matrix; None where it is not done."""

    status: str
    total_cycles: Optional[int]
    milliseconds: Optional[float]


class Retimer(Protocol):
    """What re-times an event file: this process, or the program that knows its design."""

    def config(self) -> dict[str, Any]: ...
    def summary(self) -> dict[str, Any]: ...
    def retime(self, overrides: list[str], critical_path: bool = False) -> Result: ...
    def retime_many(self, rows: list[list[str]], progress: Optional[Progress]) -> list[Retimed]: ...
    def sensitivities(self, overrides: list[str], progress: Optional[Progress]) -> str: ...
    def size_fifos(self, overrides: list[str], within_percent: float, front_points: int, jobs: int,
                   progress: Optional[Progress]) -> str: ...


class Events:
    """An event file: all that a run did, without the time it took. Gives the cycles of any timing without running again.

    Values are those of the keys that decide about time alone; InputError for any other, saying why. May be pickled: what
    is sent to another process is the file's path.
    """

    def __init__(self, path: Path_, program: Optional[Path_] = None) -> None:
        """program: that re-times it; without, the one that recorded it, and of faster-sim this process."""
        self.path = os.path.abspath(path)
        self._given = None if program is None else os.fspath(program)
        name = _core.recording_program(os.fsencode(path))
        self._retimer: Retimer
        if name == DEFAULT:
            self._retimer = _InProcess(os.fsencode(path))
        else:
            self._retimer = _ByProgram(self.path, _program_of(self.path, name, self._given))

    def __repr__(self) -> str:
        return f"Events({self.path!r})"

    def __reduce__(self) -> Any:
        return (Events, (self.path, self._given))

    @cached_property
    def config(self) -> dict[str, Any]:
        """Every key with its value, of the recorded run."""
        return self._retimer.config()

    @cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json of the recorded run."""
        return self._retimer.summary()

    def whatif(self, values: Mapping[str, object] = {}, /, *, critical_path: bool = False, **more: object) -> Result:
        """What the run would have taken with other values of some keys. DeadlockError if it would have got stuck."""
        return self._retimer.retime(_values.overrides({**values, **more}), critical_path)

    def whatif_matrix(self, configurations: Sequence[Mapping[str, object]], *, progress: Optional[Progress] = None) -> Table:
        """A row for each configuration, on all host cores: the keys that any of them names, `status` (done, deadlock, or
        unknown: a non-blocking access might find something else, and only a run can tell), `total_cycles` and
        `milliseconds`, which are masked unless it is done."""
        rows = _rows_of(configurations)
        found = self._retimer.retime_many([_values.overrides(row) for row in rows], progress)
        keys = list(dict.fromkeys(key for row in rows for key in row))
        columns = {key: _tables.of_cells([_cell(row.get(key, self.config.get(key.replace("__", ".")))) for row in rows])
                   for key in keys}
        columns["status"] = numpy.ma.array([one.status for one in found], dtype="U8")
        columns["total_cycles"] = _tables.of_cells([one.total_cycles for one in found], numpy.int64)
        columns["milliseconds"] = _tables.of_cells([one.milliseconds for one in found], float)
        return _tables.of_columns(columns)

    def sensitivities(self, values: Mapping[str, object] = {}, /, *, progress: Optional[Progress] = None) -> Table:
        """How many cycles one step of each timing key changes: sensitivities.csv, but for `status` (done, deadlock, invalid,
        unknown) instead of `outcome`. Figures are masked unless done."""
        table = self._retimer.sensitivities(_values.overrides(values), progress)
        header, newline, rows = table.partition("\n")
        steps = _tables.of_csv(header.replace("outcome", "status") + newline + rows)
        steps["status"][steps["status"] == "finished"] = "done"
        return _tables.of_columns({name: steps[name] for name in steps.dtype.names if not name.startswith("slack")})

    def size_fifos(self, within_percent: float, values: Mapping[str, object] = {}, /, *, front_points: int = 0,
                   jobs: int = 0, progress: Optional[Progress] = None) -> dict[str, Any]:
        """The cheapest FIFO depths with which the run takes at most so much longer than with unbounded ones
        (sizing.json)."""
        within = _values.number("within_percent", within_percent, 1_000_000)
        points = int(_values.number("front_points", front_points, 1000, whole=True))
        processes = int(_values.number("jobs", jobs, 1024, whole=True))
        return dict(json.loads(self._retimer.size_fifos(_values.overrides(values), within, points, processes, progress)))


class _InProcess:
    def __init__(self, path: bytes) -> None:
        self._core = _core.Events(path)

    def config(self) -> dict[str, Any]:
        return dict(json.loads(self._core.config))

    def summary(self) -> dict[str, Any]:
        return dict(json.loads(self._core.recorded_summary))

    def retime(self, overrides: list[str], critical_path: bool = False) -> Result:
        retimed = self._core.retime(overrides, critical_path)
        if retimed.deadlock_report:
            raise DeadlockError(retimed.deadlock_report, json.loads(retimed.summary))
        return Result(retimed.total_cycles, retimed.milliseconds, lambda name: str(getattr(retimed, name)))

    def retime_many(self, rows: list[list[str]], progress: Optional[Progress]) -> list[Retimed]:
        return [Retimed("deadlock", None, None) if cycles is None else Retimed("done", cycles, cycles / (mhz * 1e3))
                for cycles, mhz in self._core.retime_many(rows, progress)]

    def sensitivities(self, overrides: list[str], progress: Optional[Progress]) -> str:
        return self._core.sensitivities(overrides, progress)

    def size_fifos(self, overrides: list[str], within_percent: float, front_points: int, jobs: int,
                   progress: Optional[Progress]) -> str:
        return self._core.size_fifos(overrides, within_percent, front_points, jobs, progress)


class _ByProgram:
    def __init__(self, path: str, program: str) -> None:
        self._path = path
        self._program = program
        self._recorded = self.retime([])  # which also says whether the program can read the file

    def config(self) -> dict[str, Any]:
        return {key: entry["value"] for key, entry in self._recorded.summary["configuration"].items()}

    def summary(self) -> dict[str, Any]:
        return self._recorded.summary

    def retime(self, overrides: list[str], critical_path: bool = False) -> Result:
        with tempfile.TemporaryDirectory(prefix="faster-sim-") as temporary:
            folder = Path(temporary) / "whatif"
            path = ["--critical-path"] if critical_path else []
            ended = _program.call(self._program, ["whatif", self._path, "--out", str(folder), *path, *_as_options(overrides)])
            return result_in(folder, ended)

    def retime_many(self, rows: list[list[str]], progress: Optional[Progress]) -> list[Retimed]:
        if not rows:
            return []
        with tempfile.TemporaryDirectory(prefix="faster-sim-") as temporary:
            matrix, csv = Path(temporary) / "matrix.yaml", Path(temporary) / "matrix.csv"
            lines = ["- {" + ", ".join(override.replace("=", ": ", 1) for override in row) + "}\n" for row in rows]
            matrix.write_text("".join(lines), encoding="utf-8")
            try:
                _program.call(self._program, ["whatif", self._path, "--matrix", str(matrix), "--csv", str(csv)], progress)
            except InputError as error:
                place = re.escape(str(matrix)) + r":(\d+): "
                raise InputError(re.sub(place, lambda found: f"row {int(found[1]) - 1}: ", str(error))) from None
            table = _tables.of_csv(csv.read_text(encoding="utf-8"))
        statuses = ["done" if outcome == "finished" else outcome for outcome in table["outcome"].tolist()]
        return [Retimed(*row) for row in zip(statuses, table["total_cycles"].tolist(), table["milliseconds"].tolist())]

    def sensitivities(self, overrides: list[str], progress: Optional[Progress]) -> str:
        return self._file(["sensitivities", self._path, *_as_options(overrides)], "--csv", "sensitivities.csv", progress)

    def size_fifos(self, overrides: list[str], within_percent: float, front_points: int, jobs: int,
                   progress: Optional[Progress]) -> str:
        words = ["size-fifos", self._path, "--within", repr(within_percent), "--points", str(front_points),
                 *(["--jobs", str(jobs)] if jobs else []), *_as_options(overrides)]
        return self._file(words, "--out", "sizing/sizing.json", progress)

    def _file(self, words: list[str], option: str, name: str, progress: Optional[Progress]) -> str:
        """What the command writes there."""
        with tempfile.TemporaryDirectory(prefix="faster-sim-") as temporary:
            target = Path(temporary) / Path(name).parts[0]
            ended = _program.call(self._program, [*words, option, str(target)], progress)
            if ended.code != EXIT_DONE:
                raise ProgramError(f"{words[0]} ended with exit code {ended.code}: {ended.errors.strip()}")
            return (Path(temporary) / name).read_text(encoding="utf-8")


def _rows_of(configurations: Sequence[Mapping[str, object]]) -> list[dict[str, object]]:
    if isinstance(configurations, (Mapping, str, bytes)) or not isinstance(configurations, Iterable):
        raise InputError(f"configurations is of type {type(configurations).__name__}, expected a list of dicts")
    rows = list(configurations)
    for number, row in enumerate(rows):
        if not isinstance(row, Mapping):
            raise InputError(f"row {number} is of type {type(row).__name__}, expected a dict of keys and values")
    return [dict(row) for row in rows]


def _program_of(path: str, name: str, given: Optional[str]) -> str:
    if given is not None and Path(given).name != DEFAULT:
        return _program.find(given)
    try:
        return _program.find(name)
    except ProgramError:
        raise ProgramError(f"{path} was recorded by {name}, which is not in $PATH, expected it there or as "
                           f"Program(path of {name}).load_events(...)") from None


def _as_options(overrides: list[str]) -> list[str]:
    return [word for override in overrides for word in ("--set", override)]


def _cell(value: object) -> object:
    if isinstance(value, numpy.generic):
        return value.item()
    return _values.as_yaml(value) if isinstance(value, (list, tuple, numpy.ndarray, os.PathLike)) else value
