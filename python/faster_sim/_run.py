"""Runs and sweeps, each in processes of its own."""

import json
import os
import tempfile
from pathlib import Path
from typing import Optional, Union

import numpy

from faster_sim import _program
from faster_sim._program import Progress
from faster_sim._results import Result, table

Path_ = Union[str, "os.PathLike[str]"]


def run(config: Path_, *, out: Optional[Path_] = None, progress: Optional[Progress] = None, **values: object) -> Result:
    """Runs a configuration, with other values for some keys: run("a.yaml", accelerator__raster_cores=2).

    out: folder for all that `faster-sim run --out` writes; without, nothing is left on the disk.
    Raises InputError for what is wrong with the configuration or a value.
    """
    with tempfile.TemporaryDirectory(prefix="faster-sim-") as temporary:
        folder = Path(out if out is not None else Path(temporary) / "run")
        arguments = ["run", os.fspath(config), "--out", str(folder), *_program.settings(values)]
        code, said = _program.call(arguments, progress)
        return _result_in(folder, said if code == _program.EXIT_DEADLOCK else "")


def sweep(file: Path_, out: Path_, *, jobs: int = 0, progress: Optional[Progress] = None) -> numpy.ndarray:
    """Runs all points of a sweep file; goes on where an earlier one in the same folder was interrupted.

    jobs: processes at once, 0 as many as the host has cores. Returns results.csv: a row per point.
    """
    arguments = ["sweep", os.fspath(file), "--out", os.fspath(out)] + (["-j", str(jobs)] if jobs else [])
    _program.call(arguments, progress)
    return table((Path(out) / "results.csv").read_text(encoding="utf-8"))


def _result_in(folder: Path, deadlock_report: str) -> Result:
    names = ["summary.json"] if deadlock_report else ["summary.json", "samples.csv", "fifos.csv", "loops.csv"]
    texts = {Path(name).stem: (folder / name).read_text(encoding="utf-8") for name in names}
    figures = {"total_cycles": 0, "milliseconds": 0.0} if deadlock_report else json.loads(texts["summary"])
    return Result(figures["total_cycles"], figures["milliseconds"], deadlock_report, texts.__getitem__)
