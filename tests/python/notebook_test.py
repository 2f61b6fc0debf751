"""Runs the cells of a notebook, one after the other, and shows what they show as a notebook would.

    PYTHONPATH=build/release/python python3 tests/python/notebook_test.py docs/first_half_hour.ipynb

Cells with the tag "matplotlib" are left out where that is not installed.
"""

import ast
import importlib.util
import json
import os
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib") is not None


def shown(cell: str, names: dict) -> object:
    """What the last line of a cell is worth, if it is an expression."""
    tree = ast.parse(cell)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)


def main(notebook: Path) -> int:
    cells = [cell for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]
    names: dict = {}
    tables = 0
    with tempfile.TemporaryDirectory() as folder:
        for part in ("configs", "traces", "examples"):
            (Path(folder) / part).symlink_to(SOURCE / part)
        os.chdir(folder)
        for number, cell in enumerate(cells):
            if "matplotlib" in cell["metadata"].get("tags", []) and not HAS_MATPLOTLIB:
                continue
            source = "".join(cell["source"])
            try:
                value = shown(source, names)
            except Exception as error:
                print(f"{notebook.name}, code cell {number}: {error!r} in\n{source}")
                return 1
            if hasattr(value, "_repr_html_"):
                tables += "<table>" in value._repr_html_()
        os.chdir("/")
    print(f"{len(cells)} cells, {tables} tables")
    return 0 if len(cells) > 5 and tables > 3 else 1


if __name__ == "__main__":
    os.environ.setdefault("MPLBACKEND", "Agg")
    sys.exit(main(Path(sys.argv[1]).resolve()))
