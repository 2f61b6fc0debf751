"""What goes wrong."""

from functools import cached_property
from typing import Any

from faster_sim import _tables
from faster_sim._core import InputError
from faster_sim._tables import Table

__all__ = ["DeadlockError", "InputError", "InputWarning", "ProgramError"]


class InputWarning(UserWarning):
    """Input that can be worked with, but looks like a mistake: a mesh in millimetres, a camera outside of its image."""


class ProgramError(RuntimeError):
    """A program is missing, or ended as it never should."""


class DeadlockError(RuntimeError):
    """Nothing can move any more. The text says who waits for whom; there are no cycles, and no figures but those of what
    was done until then."""

    def __init__(self, report: str, summary: dict[str, Any]) -> None:
        super().__init__(report)
        self.report = report
        """Who waits for whom, as the program prints it."""
        self.summary = summary
        """summary.json of the run: deadlock, partial, configuration."""

    def __reduce__(self) -> Any:
        return (type(self), (self.report, self.summary))

    @property
    def cycle(self) -> int:
        """From which on nothing moved."""
        return int(self.summary["deadlock"]["cycle"])

    @property
    def wait_cycle(self) -> list[dict[str, Any]]:
        """The modules that wait for each other in a circle: `process`, `waits_for`, `to` read or write `fifo`,
        `since_cycle`, `position`, `source`, `occupancy` of `capacity`."""
        return list(self.summary["deadlock"]["wait_cycle"])

    @cached_property
    def stuck(self) -> Table:
        """All that wait, a row each."""
        return _tables.of_rows(self.summary["deadlock"]["stuck"])

    @property
    def samples_done(self) -> int:
        """That ended before."""
        return int(self.summary["partial"]["samples"])

    @cached_property
    def fifos(self) -> Table:
        """A row per FIFO of each core, up to the deadlock."""
        return _tables.of_rows(self.summary["partial"]["fifos"])

    @cached_property
    def loops(self) -> Table:
        """A row per loop of each core, up to the deadlock."""
        return _tables.of_rows(self.summary["partial"]["loops"])
