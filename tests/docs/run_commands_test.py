"""Runs the commands of README.md and docs/ as they stand there, in a copy of the tree, and compares what the pages say they
print. page_blocks.py has the conventions.

    FASTER_SIM=build/release/bin/faster-sim python3 tests/docs/run_commands_test.py [--long] [PAGE...]

Each page has a copy of its own, where build/PRESET/bin has the programs of the folder of FASTER_SIM. Without --long, what is
in LONG is left out; with it, only the pages that have such commands are run, with all of them.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Optional

from page_blocks import Block, Command, blocks_of, missing_in

SOURCE = Path(__file__).resolve().parents[2]
BINARIES = Path(os.environ["FASTER_SIM"]).resolve().parent
PARTS = ["README.md", "configs", "docs", "examples", "scripts", "traces"]
PAGES = ["README.md", *sorted(str(page.relative_to(SOURCE)) for page in (SOURCE / "docs").rglob("*.md")), "configs/README.md", "traces/README.md"]
FAILS_ON_PURPOSE = {  # what the page shows ends with this exit code
    "check configs/budgets/edge_heavy_1_core.yaml --set": 1,
    "--twin-set": 1,
    "number.deph=4": 2,
}

# What a script does once it has installed and built.
INSTEAD = {
    "/usr/bin/python3": "PYTHONPATH=$PWD/build/release/python /usr/bin/python3 -c 'import faster_sim; print(faster_sim.__version__)'",
    "bash scripts/run.sh": "build/release/bin/faster-sim run configs/faster_zcu102.yaml --out out/main",
}

# What scripts/run.sh leaves besides; pages may count on nothing else.
BUILT_BY_RUN = re.search(r"cmake --build --preset release --target (.*)", (SOURCE / "scripts" / "run.sh").read_text(encoding="utf-8")).group(1).split()

# Part of a command: why it is not run.
NOT_RUN = {
    "scripts/setup.sh": "installs packages",
    "scripts/test.sh": "installs packages, builds and runs all tests, this one too",
    "apt install": "installs packages",
    "cmake ": "builds; scripts/check-changes.sh and package.a_project_guards_its_own_design do what these pages show",
    "ctest ": "runs the tests, of which this is one",
    "git apply": "scripts/check-changes.sh applies, builds and runs the changes",
    "out/changed": "a run of a changed design: scripts/check-changes.sh",
    "modules.inlier_unit.triangle_cycles": "a key of a changed design: scripts/check-changes.sh",
    "edge_map.algorithm=outer_border": "a value of a changed design: scripts/check-changes.sh",
    "git worktree": "builds another commit, of a clone",
    "../before/": "a build of another commit",
    "build/lto": "another build",
    "_bench": "a benchmark: minutes, and its figures are the host's",
    "bench/from_python.py": "a benchmark",
    "[latency]": "a measurement",
    "faster-sim explore": "serves until it is interrupted; tests/cli/explore_test.cpp",
    "gtkwave": "a program with a window",
    "parallel ": "GNU parallel, which the project does not install; tests/cli/sweep_test.cpp has shards",
    "sbatch ": "wants a cluster; tests/cluster/slurm_test.sh",
    "sweep merge": "merges what the line before it made, on a cluster or by GNU parallel",
    "DATASET": "a dataset that is not in the repository; tests/cli/evaluate_test.cpp and estimate_test.cpp make one",
    "KEY=VALUE": "a template",
    "shelf.yaml": "a configuration that names files that are not in the repository",
    "configs/experiments/": "hours",
    "scripts/next-architecture.sh": "half an hour",
    "scripts/mutate.py": "an hour; its list is tested",
    "scripts/table-6-1.sh": "a quarter of an hour",
    "hls_pipeline ": "in the folder of the example: tests/examples/tutorial_test.cpp",
    "configs/sweeps/zcu102.yaml": "half an hour",
}

# Part of a command: why it is run with --long only.
LONG = {
    "sensitivities out/banana.events": "half a minute",
    "architecture=setup_overlap": "a measurement",
    "size-fifos out/": "minutes",
    "cosim main_job": "half a minute",
    "sensitivities out/main.events": "half a minute",
    "record configs/faster_zcu102.yaml": "for the line behind it",
    "faster_zcu102_memory.yaml": "half a minute, as it is run five times",
    "out/memory.events": "for the line before it",
    "out/next.events": "for the line before it",
    "--fst out/banana.fst": "seconds of writing",
    "--timeline out/banana.json": "seconds of writing",
    "banana.yaml --sensitivities": "seconds; 150 retimings",
    "configs/sweeps/architectures.yaml": "minutes",
    "configs/sweeps/own_designs.yaml": "minutes",
    "edge-quality --poses 50": "minutes",
    "estimate configs/": "minutes",
    "faster-sim grip": "half a minute",
}


def matching(command: str, table: dict) -> str:
    return next((part for part in table if part in command), "")


class Page:
    """A page's commands in a copy of the tree."""

    def __init__(self, name: str, runs_long: bool, scratch: Path) -> None:
        self.name = name
        self.runs_long = runs_long
        self.blocks: list[Block] = blocks_of(SOURCE / name)
        self.folder = scratch / re.sub(r"\W", "_", name)
        self.faults: list[str] = []
        self.left_out: set[str] = set()
        self.printed: Optional[str] = None  # by the last command; None: it was not run
        self.times: list[tuple[float, str]] = []

    def has_long(self) -> bool:
        return any(matching(c.text, LONG) and not matching(c.text, NOT_RUN) for block in self.blocks for c in block.commands)

    def run(self) -> None:
        for part in PARTS:
            copy = shutil.copytree if (SOURCE / part).is_dir() else shutil.copy
            copy(SOURCE / part, self.folder / part)
        (self.folder / "out").mkdir()
        for preset in ("release", "ci"):
            (self.folder / "build" / preset).mkdir(parents=True)
            (self.folder / "build" / preset / "bin").symlink_to(BINARIES)
            if "faster_python" in BUILT_BY_RUN:
                (self.folder / "build" / preset / "python").symlink_to(BINARIES.parent / "python")
        where = self.folder
        for block in self.blocks:
            if block.file:
                (self.folder / block.file).write_text(block.content, encoding="utf-8")
            if block.output and self.printed is not None and (missing := missing_in(self.printed, block.output)):
                self.faults.append(f"{self.name}:{block.line}: the command before does not print:\n  {missing}\n  but:\n{self.printed[:6000]}")
            for command in block.commands:
                if command.text.startswith("cd ") and not matching(command.text, NOT_RUN):
                    where = where / command.text.split()[1]
                else:
                    self.run_one(block, command, where)

    def run_one(self, block: Block, command: Command, where: Path) -> None:
        text = INSTEAD.get(command.text.partition("#")[0].strip(), command.text)
        known = [matching(text, NOT_RUN)] + ([] if self.runs_long else [matching(text, LONG)])
        if any(known):
            self.left_out.update(part for part in known if part)
            self.printed = None
            return
        path = f"{BINARIES}:{os.environ['PATH']}"
        begin = time.monotonic()
        done = subprocess.run(["bash", "-c", text], cwd=where, env={**os.environ, "PATH": path, "LC_ALL": "C.UTF-8"}, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        self.times.append((time.monotonic() - begin, text))
        self.printed = done.stdout
        code = FAILS_ON_PURPOSE.get(matching(command.text, FAILS_ON_PURPOSE), 0)
        place = f"{self.name}:{block.line}: {command.text}"
        if done.returncode != code:
            self.faults.append(f"{place}\n  exit code {done.returncode}, expected {code}\n{done.stdout[-2000:]}")
        elif missing := missing_in(done.stdout, command.expected):
            self.faults.append(f"{place}\n  does not print, where the page has it:\n  {missing}\n  but:\n{done.stdout[:6000]}")


def self_check() -> None:
    """What would be found if the comparison were blind."""
    printed = "total 10 cycles\nHost: 0.5 s\nend\n"
    assert missing_in(printed, ["total 10 cycles", "Host: 0.1 s", "end"]) == ""
    assert missing_in(printed, ["total 10 cycles", "...", "end"]) == ""
    assert missing_in(printed, ["total 1... cycles"]) == ""
    assert missing_in(printed, ["total 11 cycles"]) == "total 11 cycles"
    assert missing_in(printed, ["total 10 cycles", "end"]) == "end"
    assert missing_in(printed, ["end", "...", "total 10 cycles"]) == "total 10 cycles"


def main(arguments: list[str]) -> int:
    self_check()
    runs_long = "--long" in arguments
    names = [argument for argument in arguments if argument != "--long"] or PAGES
    with tempfile.TemporaryDirectory() as scratch:
        pages = [Page(name, runs_long, Path(scratch)) for name in names]
        pages = [page for page in pages if page.has_long() or not runs_long]
        for page in pages:
            page.folder.mkdir()
        with ThreadPoolExecutor(2) as pool:
            list(pool.map(Page.run, sorted(pages, key=lambda page: -len(page.blocks))))
    faults = [fault for page in pages for fault in page.faults]
    if names == PAGES and not runs_long:
        left_out = set().union(*(page.left_out for page in pages))
        faults += [f"{part}: no page has such a command any more" for part in {**NOT_RUN, **LONG} if part not in left_out]
    times = sorted((entry for page in pages for entry in page.times), reverse=True)
    for seconds, command in times[:10]:
        print(f"{seconds:6.1f} s  {command}")
    print(f"{len(times)} commands of {len(pages)} pages, {sum(seconds for seconds, _ in times):.0f} s")
    print("\n".join(faults))
    if len(times) < 40 and names == PAGES and not runs_long:
        faults.append("fewer commands than the pages have")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
