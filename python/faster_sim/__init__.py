"""Cycles of a dataflow design before HLS: run it, record it, re-time what was recorded.

    >>> import faster_sim
    >>> events = faster_sim.record("configs/banana.yaml", "banana.events")
    >>> events.whatif({"accelerator.fifos.fragment_depth.depth": 8}).total_cycles

Keys are those of the configuration (`faster-sim keys`). docs/python.md teaches the rest.
"""

from faster_sim._core import InputError, commit as __commit__, version as __version__
from faster_sim._errors import DeadlockError, InputWarning, ProgramError
from faster_sim._events import Events
from faster_sim._results import Answer, Check, Result
from faster_sim._run import Program, check, compare, estimate, evaluate, load_events, record, run, sweep
from faster_sim._tables import Table, to_pandas

__all__ = ["Answer", "Check", "DeadlockError", "Events", "InputError", "InputWarning", "Program", "ProgramError", "Result", "Table",
           "check", "compare", "estimate", "evaluate", "load_events", "record", "run", "sweep", "to_pandas"]

InputError.__module__ = __name__  # where users know it from
DeadlockError.__module__ = __name__
InputWarning.__module__ = __name__
