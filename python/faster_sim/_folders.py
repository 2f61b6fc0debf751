"""What `run --out` and `whatif --out` leave in a folder."""

import json
from pathlib import Path

from faster_sim._errors import DeadlockError
from faster_sim._program import EXIT_DEADLOCK, Ended
from faster_sim._results import Result


def result_in(folder: Path, ended: Ended) -> Result:
    """Raises DeadlockError if the run got stuck."""
    summary = (folder / "summary.json").read_text(encoding="utf-8")
    figures = json.loads(summary)
    if ended.code == EXIT_DEADLOCK:
        raise DeadlockError(_report_in(ended.errors), figures)
    texts = {name: (folder / f"{name}.csv").read_text(encoding="utf-8") for name in ("samples", "fifos", "loops")}
    return Result(figures["total_cycles"], figures["milliseconds"], {"summary": summary, **texts}.__getitem__, ended.printed)


def _report_in(errors: str) -> str:
    """Between warnings and the list of what was written."""
    begin = max(errors.find("deadlock at cycle"), 0)
    return errors[begin:].partition("\n\nwritten: ")[0].strip() + "\n"
