#!/usr/bin/env python3
"""Writes docs/reference.md: the headers that a design includes, class by class, from their comments.

    scripts/reference.py            renews the page
    scripts/reference.py --check    says whether it is up to date

What a design includes is what the examples and their tutorial do: dataflow/commands/simple_tool.hpp, and what that includes.
"""

import re
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1]
PAGE = SOURCE / "docs" / "reference.md"
INTRODUCTION = """# Reference for C++

What the headers say that a design includes ([tutorial.md](tutorial.md) uses most of it). They are installed, and
[promised](stability.md); all others are details. Private and inherited members are left out.
`scripts/reference.py` writes this page.
"""
OPENS_TYPE = re.compile(r"(?:template <[^>]*> )?(?:class|struct|enum class) (\w+)")


def headers() -> list[Path]:
    """In the order in which they are included."""
    rooms = SOURCE / "src"
    found: list[Path] = []
    examples = sorted(file for pattern in ("*.cpp", "*.hpp") for file in (SOURCE / "examples").rglob(pattern))
    for file in examples:
        for name in included(file):
            if (rooms / name).exists():
                found += [rooms / name, *(rooms / inner for inner in included(rooms / name) if name.endswith("simple_tool.hpp"))]
    # The types of what these describe.
    for name in ("dataflow/core/machine/module_description.hpp", "dataflow/run/config/simple_design.hpp", "channels/process_clock.hpp",
                 "channels/tokens_of.hpp", "channels/token_loop.hpp", "hls/hls_design.hpp"):
        found += sorted(rooms.rglob(Path(name).name))
    return list(dict.fromkeys(found))


def included(file: Path) -> list[str]:
    return re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.MULTILINE)


def without_bodies(lines: list[str]) -> list[str]:
    """Declarations alone: what stands between the braces of a function is nobody's business."""
    text = re.sub(r"\)(?:\n +| ): [^;{}]*(?:\{[^{}]*\}[^;{}]*)*\{\}", ");", "\n".join(lines))  # what a constructor begins with
    kept, depth = [], 0
    for line in text.split("\n"):
        if depth == 0:
            kept.append(re.sub(r" \{ .* \}$", ";", line))
            body = re.search(r"\) ?(?:const|override|noexcept| )* ?(?::.*)?\{$|^\s+: .*\{$", line)
            depth = 1 if body else 0
            if body:
                kept[-1] = re.sub(r" ?\{$", ";", re.sub(r" : .*\{$", " {", kept[-1]))
        else:
            depth += line.count("{") - line.count("}")
    return kept


def public_part(lines: list[str]) -> list[str]:
    """Of a class or struct, braces included."""
    kept, is_shown = [], not lines[0].lstrip().startswith(("class", "template"))
    kept.append(lines[0])
    for line in lines[1:-1]:
        access = re.fullmatch(r"  (public|protected|private):", line)
        if access:
            is_shown = access.group(1) != "private"
        if is_shown or line.startswith("class "):
            kept.append(line)
    return without_bodies([*kept, lines[-1]])


def blocks(lines: list[str]) -> list[list[str]]:
    """Top-level declarations of the namespace with their comments."""
    found, block, depth = [], [], 0
    for line in lines:
        if not block and (not line.strip() or line.startswith(("#", "namespace", "}", "using", "// "))):
            continue
        block.append(line)
        if not line.lstrip().startswith("//"):
            depth += line.count("{") - line.count("}")
            if depth == 0 and line.rstrip().endswith((";", "}")):
                found.append(block)
                block = []
    return found


def of_header(file: Path) -> str:
    name = file.relative_to(SOURCE / "src")
    parts = [f"\n## {name}\n"]
    for block in blocks(file.read_text(encoding="utf-8").splitlines()):
        comment = [line.removeprefix("///").removeprefix(" ") for line in block if line.startswith("///")]
        code = [line for line in block if not line.startswith("///")]
        if not comment or not code:
            continue
        if code[0].startswith("template") and len(code) > 1 and OPENS_TYPE.match(code[1]):
            code[:2] = [f"{code[0]} {code[1]}"]
        opened = OPENS_TYPE.match(code[0])
        shown = public_part(code) if opened and len(code) > 2 else without_bodies(code)
        if opened:
            parts.append(f"### {opened.group(1)}\n")
        parts.append(paragraphs(comment))
        parts.append("```cpp\n" + "\n".join(line for line in shown if line.strip()) + "\n```\n")
    return "\n".join(parts) if len(parts) > 1 else ""


def paragraphs(comment: list[str]) -> str:
    """An example in a comment is indented; a line of its own stays one."""
    return re.sub(r" \(docs[^)]*\)", "", "\n".join(line.rstrip() for line in comment)) + "\n"


def main(arguments: list[str]) -> int:
    page = INTRODUCTION + "".join(of_header(file) for file in headers())
    if arguments == ["--check"]:
        if PAGE.read_text(encoding="utf-8") == page:
            return 0
        print("docs/reference.md is not what the headers say: run scripts/reference.py", file=sys.stderr)
        return 1
    PAGE.write_text(page, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
