"""The code blocks of a page, and what they say a command prints.

Conventions, which read naturally:
- A block of commands has no language, or `console`, `bash` or `sh`. With `$ ` before commands, other lines are output.
- A block `text` is output of the last command before it.
- An output with a line `...` is an excerpt: its lines are printed in this order, maybe with others between. `...` within a line
  stands for anything. Times and rates of the host (`0.03 s`, `589 kHz`) may be others.
- A block whose first line is the comment `# NAME.yaml` is a file of that name.
"""

import re
import textwrap
from dataclasses import dataclass, field
from pathlib import Path

COMMANDS = re.compile(r"\(?(?:[A-Z_]+=\S+ )*(?:\S*/)?(?:faster-sim|faster_\w+_(?:bench|tests)|python3|pipeline|bash|sh|cmake|ctest|cd|export|git|apt|apt-get|diff|printf|time|parallel|"
                      r"sbatch|gtkwave|source|setup\.sh)(?!\S)")
FILE = re.compile(r"# ([\w.-]+\.(?:yaml|csv|json))$")


@dataclass
class Command:
    text: str
    expected: list[str] = field(default_factory=list)  # lines; empty: anything


@dataclass
class Block:
    line: int
    commands: list[Command] = field(default_factory=list)
    file: str = ""  # its name, if the block is one
    content: str = ""
    output: list[str] = field(default_factory=list)  # of the last command before it


def commands_of(content: str, language: str) -> list[Command]:
    lines = content.replace("\\\n", " ").splitlines()
    has_prompts = any(line.startswith("$ ") for line in lines)
    commands: list[Command] = []
    for line in lines:
        if line.startswith("$ "):
            commands.append(Command(line[2:]))
        elif not has_prompts and COMMANDS.match(line):
            commands.append(Command(line))
        elif commands and has_prompts:
            commands[-1].expected.append(line)
        elif commands and line.strip() and not line.startswith(" "):
            raise ValueError(f"neither a command nor output: {line}")
    return commands


def blocks_of(page: Path) -> list[Block]:
    text = page.read_text(encoding="utf-8")
    blocks: list[Block] = []
    for found in re.finditer(r"^( *)```(\w*)\n(.*?)^\1```$", text, re.DOTALL | re.MULTILINE):
        content, language = textwrap.dedent(found.group(3)), found.group(2)
        block = Block(text[: found.start()].count("\n") + 1, content=content)
        first = content.partition("\n")[0]
        if FILE.match(first):
            block.file = FILE.match(first).group(1)
        elif language == "text":
            block.output = content.splitlines()
        elif language in ("", "console", "bash", "sh") and (first.startswith("$ ") or COMMANDS.match(first)):
            block.commands = commands_of(content, language)
        else:
            continue
        blocks.append(block)
    return blocks


def without_host_times(line: str) -> str:
    return re.sub(r"[\d.]+ (s|kHz)\b", r"# \1", line.rstrip())


def missing_in(printed: str, expected: list[str]) -> str:
    """The first of the expected lines that the output does not have where it should be; empty if there is none."""
    lines = [without_host_times(line) for line in printed.splitlines()]
    wanted = [without_host_times(line) for line in expected]
    while wanted and not wanted[-1].strip():
        wanted.pop()
    is_excerpt = any(text.strip() == "..." for text in wanted)
    next_line = 0
    for text in wanted:
        if text.strip() == "...":
            continue
        may_skip = is_excerpt or next_line == 0
        found = next((i for i in range(next_line, len(lines)) if fits(lines[i], text)), -1)
        if found < 0 or (not may_skip and found != next_line):
            return text or "(an empty line)"
        next_line = found + 1
    return ""


def fits(line: str, text: str) -> bool:
    parts = [re.escape(part) for part in text.strip().split("...")]
    return re.fullmatch(".*".join(parts), line.strip()) is not None
