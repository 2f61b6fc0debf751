"""The program `faster-sim`, in which simulations run: SystemC elaborates one design per process."""

import os
import pty
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import BinaryIO, Callable, Mapping, Optional, Sequence

from faster_sim._core import InputError

Progress = Callable[[int, int], object]
"""Told how much of how much is done. What it raises ends the work."""

EXIT_DONE, EXIT_FAILED_CHECK, EXIT_BAD_INPUT, EXIT_DEADLOCK = range(4)


class ProgramError(RuntimeError):
    """`faster-sim` is missing, or ended as it never should."""


def overrides(values: Mapping[str, object]) -> list[str]:
    """As --set has them. "__" stands for "." in names that are written as Python's keyword arguments."""
    return [f"{key.replace('__', '.')}={_as_yaml(value)}" for key, value in values.items()]


def settings(values: Mapping[str, object]) -> list[str]:
    """The same as options of the program."""
    return [word for override in overrides(values) for word in ("--set", override)]


def call(arguments: Sequence[str], progress: Optional[Progress] = None) -> tuple[int, str]:
    """The exit code and what was said on stderr. Raises InputError with the program's line, where the input is bad."""
    with tempfile.TemporaryFile() as errors:
        code = _call([_find(), *arguments], errors, progress)
        errors.seek(0)
        said = errors.read().decode(errors="replace").strip()
    if code == EXIT_BAD_INPUT:
        raise InputError(said.removeprefix("faster-sim: "))
    if code not in (EXIT_DONE, EXIT_DEADLOCK):
        raise ProgramError(f"faster-sim ended with exit code {code}: {said}")
    return code, said


def _call(words: Sequence[str], errors: BinaryIO, progress: Optional[Progress]) -> int:
    terminal, end = pty.openpty() if progress else (None, subprocess.DEVNULL)  # only a terminal is shown progress
    try:
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=end, stderr=errors)
    finally:
        if terminal is not None:
            os.close(end)
    with process:
        try:
            if terminal is not None:
                _follow(terminal, progress)
            return process.wait()
        except BaseException:
            process.terminate()  # then it clears away what is half-written
            raise
        finally:
            if terminal is not None:
                os.close(terminal)


def _follow(terminal: int, progress: Progress) -> None:
    while True:
        try:
            shown = os.read(terminal, 4096)
        except OSError:  # nobody writes any more
            return
        for done, of_all in re.findall(rb"\] (\d+)/(\d+) ", shown):
            progress(int(done), int(of_all))


def _find() -> str:
    """$FASTER_SIM, the program of the build that this package is of, or the one of $PATH."""
    beside = Path(__file__).absolute().parents[2] / "bin" / "faster-sim"
    for place in (os.environ.get("FASTER_SIM"), str(beside), shutil.which("faster-sim")):
        if place and os.access(place, os.X_OK):
            return place
    raise ProgramError("no program faster-sim in $FASTER_SIM or $PATH")


def _as_yaml(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_as_yaml, value)) + "]"
    return str(value)
