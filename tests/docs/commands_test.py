"""Every faster-sim command of README.md and docs/ has a subcommand, options, keys and shipped files that there are."""

import os
import re
import shlex
import subprocess
import sys
import unittest
from functools import lru_cache
from pathlib import Path

from page_blocks import blocks_of

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["FASTER_SIM"]
SHIPPED = re.compile(r"(?:\./)?((?:configs|traces|examples|scripts|docs)/[\w./-]+)")


def output_of(*words: str) -> str:
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


@lru_cache(maxsize=None)
def options_of(command: str) -> set[str]:
    return set(re.findall(r"(?<![\w-])--?[a-z][a-z0-9-]*", output_of(command, "--help")))


@lru_cache(maxsize=None)
def subcommands() -> set[str]:
    return set(re.findall(r"^  (\S+) ", output_of("--help").partition("Subcommands:")[2], re.MULTILINE))


@lru_cache(maxsize=None)
def keys() -> set[str]:
    return set(re.findall(r"^\| `([a-z0-9_.]+)`", output_of("keys"), re.MULTILINE))


def commands_in(page: Path) -> list[list[str]]:
    """Of its code blocks: what follows "faster-sim", word by word."""
    calls = (re.match(r"(?:time )?(?:\S*/)?faster-sim ((?!-)[a-z].*)", command.text) for block in blocks_of(page) for command in block.commands)
    return [shlex.split(call.group(1), comments=True) for call in calls if call]


def faults_of(words: list[str]) -> list[str]:
    command, *rest = words
    if command not in subcommands():
        return [f"no command {command}"]
    faults = []
    for word in rest:
        option = word.partition("=")[0]
        if re.fullmatch(r"--?[a-z][a-z0-9-]*", option) and option not in options_of(command):
            faults.append(f"{command} has no {option}")
        file = SHIPPED.fullmatch(word)
        if file and not (SOURCE / file.group(1)).exists():
            faults.append(f"no file {file.group(1)}")
    for key, value in zip(rest, rest[1:]):
        name = value.partition("=")[0]
        if key == "--set" and re.fullmatch(r"[a-z0-9_.]+", name) and name not in keys():
            faults.append(f"no key {name}")
    return faults


class CommandsTest(unittest.TestCase):
    def test_commands_of_the_pages_are_true(self) -> None:
        found = 0
        for page in [SOURCE / "README.md", *sorted((SOURCE / "docs").rglob("*.md")), *sorted((SOURCE / "configs").rglob("*.md"))]:
            for words in commands_in(page):
                found += 1
                with self.subTest(page=page.name, command=" ".join(words)):
                    faults = faults_of(words)
                    if page.name == "changing-the-design.md":  # keys of changed designs: scripts/check-changes.sh looks for them
                        faults = [fault for fault in faults if not fault.startswith("no key ")]
                    self.assertEqual(faults, [])
        self.assertGreater(found, 50)

    def test_links_between_pages_lead_somewhere(self) -> None:
        for page in [SOURCE / "README.md", SOURCE / "CHANGELOG.md", *sorted((SOURCE / "docs").rglob("*.md"))]:
            for target in re.findall(r"\]\(([^)#\s:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
                with self.subTest(page=page.name, target=target):
                    self.assertTrue((page.parent / target).exists())


if __name__ == "__main__":
    sys.exit(unittest.main())
