"""The programs in which simulations run: SystemC elaborates one design per process."""

import os
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Iterator, Optional, Sequence, Union

from faster_sim._errors import InputError, InputWarning, ProgramError

Progress = Callable[[int, int], object]
"""Told how much of how much is done. What it raises ends the work."""

Path_ = Union[str, "os.PathLike[str]"]

DEFAULT = "faster-sim"
EXIT_DONE, EXIT_FAILED_CHECK, EXIT_BAD_INPUT, EXIT_DEADLOCK = range(4)
_WARNING_LINE = re.compile(r"^[^\s:]+: warning: (.*)\n?", re.MULTILINE)
_PROGRESS_LINE = re.compile(rb"\r\[[^\r\n]*\x1b\[K|\r\x1b\[K")


@dataclass(frozen=True)
class Ended:
    """What became of a command."""

    code: int
    printed: str
    errors: str


def find(program: Path_) -> str:
    """A path, or a name: of the program in $FASTER_SIM, beside it, in the build or wheel that this package is of, or in
    $PATH."""
    name = os.fspath(program)
    if os.sep in name:
        return name
    places = list(_places(name))
    for place in places:
        if os.access(place, os.X_OK) and not os.path.isdir(place):
            return place
    raise ProgramError(f"no program {name} in $PATH, expected one there; Program(path) takes a path" if name != DEFAULT
                       else "no program faster-sim in $FASTER_SIM or $PATH")


def _places(name: str) -> Iterator[str]:
    chosen = os.environ.get("FASTER_SIM")
    if chosen:
        yield chosen if name == DEFAULT else str(Path(chosen).absolute().parent / name)
    package = Path(__file__).absolute().parent
    yield str(package / "bin" / name)
    yield str(package.parents[1] / "bin" / name)
    in_path = shutil.which(name)
    if in_path:
        yield in_path


def call(program: Path_, arguments: Sequence[str], progress: Optional[Progress] = None) -> Ended:
    """Raises InputError with the program's line, where the input is bad. A failed check and a deadlock are for the caller.
    Each warning of the program becomes an InputWarning."""
    for word in arguments:
        if "\0" in word:
            raise InputError(f"{word!r} has a character of code 0, expected none")
    found = find(program)
    with tempfile.TemporaryFile() as errors, tempfile.TemporaryFile() as output:
        code = _call([found, *arguments], output, errors, progress)
        ended = Ended(code, _read(output), _warned(_read(errors)))
    said = ended.errors.strip()
    if code == EXIT_BAD_INPUT:
        raise InputError(said.removeprefix(Path(found).name + ": "))
    if code not in (EXIT_DONE, EXIT_FAILED_CHECK, EXIT_DEADLOCK):
        raise ProgramError(f"{Path(found).name} ended with exit code {code}: {said}")
    return ended


def main() -> None:
    """The command `faster-sim` of an installed wheel."""
    found = str(Path(__file__).absolute().parent / "bin" / DEFAULT)
    os.execv(found, [DEFAULT, *sys.argv[1:]])


def _warned(errors: str) -> str:
    """What is left without the warnings, which are told of the line outside of this package that called it."""
    level, frame = 1, sys._getframe()
    while frame is not None and frame.f_globals.get("__name__", "").startswith("faster_sim."):
        level, frame = level + 1, frame.f_back  # type: ignore[assignment]
    for text in _WARNING_LINE.findall(errors):
        warnings.warn(text, InputWarning, stacklevel=level)
    return _WARNING_LINE.sub("", errors)


def _read(file: object) -> str:
    file.seek(0)  # type: ignore[attr-defined]
    content: bytes = _PROGRESS_LINE.sub(b"", file.read()).replace(b"\r\n", b"\n")  # type: ignore[attr-defined]
    return content.decode(errors="replace")


def _call(words: Sequence[str], output: object, errors: object, progress: Optional[Progress]) -> int:
    terminal, end = pty.openpty() if progress else (None, output)  # only a terminal is shown progress
    try:
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=end, stderr=errors)  # type: ignore[call-overload]
    except OSError as error:
        raise ProgramError(f"{words[0]}: {error.strerror}, expected a program that can be run") from None
    finally:
        if terminal is not None:
            os.close(end)  # type: ignore[arg-type]
    with process:
        try:
            if terminal is not None and progress is not None:
                _follow(terminal, output, progress)
            return int(process.wait())
        except BaseException:
            process.terminate()  # then it clears away what is half-written
            raise
        finally:
            if terminal is not None:
                os.close(terminal)


def _follow(terminal: int, output: object, progress: Progress) -> None:
    while True:
        try:
            shown = os.read(terminal, 4096)
        except OSError:  # nobody writes any more
            return
        output.write(shown)  # type: ignore[attr-defined]
        for done, of_all in re.findall(rb"\] (\d+)/(\d+) ", shown):
            progress(int(done), int(of_all))
