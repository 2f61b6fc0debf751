"""Commands of a program, each in processes of its own."""

import json
import os
import tempfile
from pathlib import Path
from typing import Any, Mapping, Optional, Union

from faster_sim import _program, _tables, _values
from faster_sim._errors import ProgramError
from faster_sim._events import Events
from faster_sim._folders import result_in
from faster_sim._program import DEFAULT, EXIT_DONE, Path_, Progress
from faster_sim._results import Answer, Check, Result
from faster_sim._tables import Table


class Program:
    """A program of a design: `faster-sim`, or one that is written as docs/tutorial.md does. A path, or the name of one that
    lies beside faster-sim or in $PATH.

    Of the keyword arguments of all commands, names with "." or "__" are keys of the configuration
    (accelerator__raster_cores=2), and others options as `--help` has them (critical_path=True, vcd="run.vcd").
    """

    def __init__(self, program: Path_ = DEFAULT) -> None:
        self.path = _program.find(program)

    def __repr__(self) -> str:
        return f"Program({self.path!r})"

    def run(self, config: Path_, values: Mapping[str, object] = {}, /, *, out: Optional[Path_] = None,
            progress: Optional[Progress] = None, **more: object) -> Result:
        """Runs a configuration, with other values of some keys.

        out: folder for all that `run --out` writes; without, nothing is left on the disk but what options name.
        Raises DeadlockError if it gets stuck, InputError for what is wrong with the configuration or a value.
        """
        with tempfile.TemporaryDirectory(prefix="faster-sim-") as temporary:
            folder = Path(out if out is not None else Path(temporary) / "run")
            words = ["run", os.fspath(config), "--out", str(folder), *_values.settings(values), *_values.words(more)]
            ended = _program.call(self.path, words, progress)
            return result_in(folder, ended)

    def record(self, config: Path_, path: Path_, values: Mapping[str, object] = {}, /, *,
               progress: Optional[Progress] = None, **more: object) -> Events:
        """Runs a configuration, with other values of some keys, and keeps its events in a file. One that gets stuck raises
        DeadlockError; what was in the file stays there."""
        options: dict[str, Any] = {**more, "events": os.fspath(path)}
        self.run(config, values, progress=progress, **options)
        return self.load_events(path)

    def load_events(self, path: Path_) -> Events:
        """The events of `run --events`. InputError for any other file."""
        return Events(path, self.path)

    def sweep(self, file: Path_, out: Path_, *, jobs: int = 0, progress: Optional[Progress] = None, **more: object) -> Table:
        """Runs all points of a sweep file; goes on where an earlier one in the same folder was interrupted.

        jobs: processes at once, 0 as many as the host has cores. Returns results.csv: a row per point, whose `status` is
        done, deadlock or failed; `message` says why.
        """
        words = ["sweep", os.fspath(file), "--out", os.fspath(out), *_values.words({"jobs": jobs or None, **more})]
        _program.call(self.path, words, progress)
        return _tables.of_csv((Path(out) / "results.csv").read_text(encoding="utf-8"))

    def check(self, *budgets: Path_, progress: Optional[Progress] = None, **more: object) -> Check:
        """Checks budgets; `check["limits"]` has a row per limit. A broken one raises nothing: the answer is false."""
        with tempfile.TemporaryDirectory(prefix="faster-sim-") as temporary:
            file = Path(temporary) / "check.json"
            words = ["check", *(os.fspath(one) for one in budgets), "--json", str(file), *_values.words(more)]
            ended = _program.call(self.path, words, progress)
            found = json.loads(file.read_text(encoding="utf-8"))
        return Check(found, {"limits": _limits(found)}, ended.printed)

    def compare(self, before: Union[Result, Path_], after: Union[Result, Path_], **more: object) -> Answer:
        """What changed from one run to another: results, or folders of `run --out`. `answer["changes"]` has a row for each
        figure, the largest difference first."""
        with tempfile.TemporaryDirectory(prefix="faster-sim-") as temporary:
            file = Path(temporary) / "comparison.json"
            runs = [_folder_of(run, Path(temporary) / name) for run, name in ((before, "before"), (after, "after"))]
            words = ["compare", *runs, "--json", str(file), *_values.words(more)]
            ended = self._done(words, None)
            found = json.loads(file.read_text(encoding="utf-8"))
        return Answer(found, {"changes": _changes(found)}, ended.printed)

    def estimate(self, config: Path_, *, out: Optional[Path_] = None, progress: Optional[Progress] = None,
                 **more: object) -> Answer:
        """Finds an object's pose; `answer["iterations"]` has a row per iteration. With all=True, of all targets of a
        dataset: `answer["results"]` has a row per estimate, and there is no summary."""
        words = ["estimate", os.fspath(config)]
        if more.get("all"):
            return self._answer(words, None, ["results"], out, progress, more)
        return self._answer(words, "estimate.json", ["iterations"], out, progress, more)

    def evaluate(self, *results: Path_, dataset: Path_, out: Optional[Path_] = None, progress: Optional[Progress] = None,
                 **more: object) -> Answer:
        """Judges files of results against a dataset of BOP; tables `scores`, `errors`, `curves`."""
        words = ["evaluate", *(os.fspath(one) for one in results), os.fspath(dataset)]
        return self._answer(words, "evaluation.json", ["scores", "errors", "curves"], out, progress, more)

    def call(self, command: str, *words: Path_, progress: Optional[Progress] = None, **more: object) -> str:
        """Any command, as in a shell: call("record", "a.yaml", out="trace"). Returns what it printed."""
        return self._done([command, *(os.fspath(one) for one in words), *_values.words(more)], progress).printed

    def _done(self, words: list[str], progress: Optional[Progress]) -> _program.Ended:
        ended = _program.call(self.path, words, progress)
        if ended.code != EXIT_DONE:
            raise ProgramError(f"{words[0]} ended with exit code {ended.code}: {(ended.errors or ended.printed).strip()}")
        return ended

    def _answer(self, words: list[str], json_file: Optional[str], tables: list[str], out: Optional[Path_],
                progress: Optional[Progress], more: dict[str, object]) -> Answer:
        with tempfile.TemporaryDirectory(prefix="faster-sim-") as temporary:
            folder = Path(out if out is not None else Path(temporary) / "out")
            ended = self._done([*words, "--out", str(folder), *_values.words(more)], progress)
            found = json.loads((folder / json_file).read_text(encoding="utf-8")) if json_file else {}
            read = {name: _tables.of_csv((folder / f"{name}.csv").read_text(encoding="utf-8")) for name in tables}
        return Answer(found, read, ended.printed)


def load_events(path: Path_) -> Events:
    """The events of `run --events`, of whatever design: those of faster-sim are re-timed in this process, others by the
    program that recorded them. InputError for any other file."""
    return Events(path)


def run(config: Path_, values: Mapping[str, object] = {}, /, *, out: Optional[Path_] = None,
        progress: Optional[Progress] = None, **more: object) -> Result:
    """Program("faster-sim").run."""
    return Program().run(config, values, out=out, progress=progress, **more)


def record(config: Path_, path: Path_, values: Mapping[str, object] = {}, /, *, progress: Optional[Progress] = None,
           **more: object) -> Events:
    """Program("faster-sim").record."""
    return Program().record(config, path, values, progress=progress, **more)


def sweep(file: Path_, out: Path_, *, jobs: int = 0, progress: Optional[Progress] = None, **more: object) -> Table:
    """Program("faster-sim").sweep."""
    return Program().sweep(file, out, jobs=jobs, progress=progress, **more)


def check(*budgets: Path_, progress: Optional[Progress] = None, **more: object) -> Check:
    """Program("faster-sim").check."""
    return Program().check(*budgets, progress=progress, **more)


def compare(before: Union[Result, Path_], after: Union[Result, Path_], **more: object) -> Answer:
    """Program("faster-sim").compare."""
    return Program().compare(before, after, **more)


def estimate(config: Path_, *, out: Optional[Path_] = None, progress: Optional[Progress] = None, **more: object) -> Answer:
    """Program("faster-sim").estimate."""
    return Program().estimate(config, out=out, progress=progress, **more)


def evaluate(*results: Path_, dataset: Path_, out: Optional[Path_] = None, progress: Optional[Progress] = None,
             **more: object) -> Answer:
    """Program("faster-sim").evaluate."""
    return Program().evaluate(*results, dataset=dataset, out=out, progress=progress, **more)


def _folder_of(run: Union[Result, Path_], folder: Path) -> str:
    if not isinstance(run, Result):
        return os.fspath(run)
    folder.mkdir()
    (folder / "summary.json").write_text(run._text("summary"), encoding="utf-8")
    for name in ("samples", "fifos", "loops"):
        (folder / f"{name}.csv").write_text(run._text(name), encoding="utf-8")
    return str(folder)


def _limits(found: dict[str, Any]) -> Table:
    rows = []
    for budget in found["budgets"]:
        for limit in budget.get("limits") or []:
            tightest = limit.get("tightest") or {}
            rows.append({"budget": budget["name"], "figure": limit["figure"], "limit": limit["limit"],
                         "status": "passed" if limit["passed"] else "breached", "measured": tightest.get("measured"),
                         "margin": tightest.get("margin")})
        if not budget.get("limits"):
            rows.append({"budget": budget["name"], "figure": "", "limit": "", "status": budget["status"]})
    return _tables.of_rows(rows, ["budget", "figure", "limit", "status", "measured", "margin"])


def _changes(found: dict[str, Any]) -> Table:
    rows = [{"list": name, **row} for name, rows in found["figures"].items() for row in rows]
    rows.sort(key=lambda row: -abs(row["difference"]))
    return _tables.of_rows(rows, ["list", "item", "figure", "a", "b", "difference", "percent"])
