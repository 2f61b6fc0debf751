"""Cycles of the FASTER accelerator before HLS: run it, record it, re-time what was recorded.

    >>> import faster_sim
    >>> events = faster_sim.record("configs/banana.yaml", "banana.events")
    >>> events.whatif({"accelerator.fifos.fragment_depth.depth": 8}).total_cycles

Keys are those of the configuration (`faster-sim keys`). docs/python.md teaches the rest.
"""

from faster_sim._core import InputError, commit as __commit__, version as __version__
from faster_sim._events import Events, load_events, record
from faster_sim._program import ProgramError
from faster_sim._results import Result, to_pandas
from faster_sim._run import run, sweep

__all__ = ["Events", "InputError", "ProgramError", "Result", "load_events", "record", "run", "sweep", "to_pandas"]

InputError.__module__ = __name__  # where users know it from
