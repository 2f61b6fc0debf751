#!/usr/bin/env python3
"""Checks that texts lead somewhere and stand alone:
  - a page and heading that a comment or a page names are there, and so are files in backticks;
  - no comment begins with a word that needs the comment before it ("The same ...");
  - pages that are not in the repository are not named.
It takes a second. Exit code 1 if it found something."""

import re
import subprocess
import sys
from functools import lru_cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCES = {".cpp", ".hpp", ".js", ".py", ".sh", ".sv", ".cmake", ".txt", ".yaml", ".html", ".css"}
PAGES = (".md",)

# A comment that begins so says nothing without its neighbour.
NEEDS_A_NEIGHBOUR = re.compile(r"(The same|Same|Likewise|Between them|Ditto|As above|As before|The former|The latter|Both of them|Another of those)\b")
# Pages of which only those who wrote the project know.
UNKNOWN_PAGE = re.compile(r"\b(SPEC|SYSTEM|KERNEL)\b(?!\s+(PUBLIC|ON|PRIVATE|INTERFACE)\b)")
REFERENCE = re.compile(r"(?<![\w/.-])((?:docs|configs|traces)/[\w/-]+\.md)(?:#([\w-]+))?")
LINK = re.compile(r"\]\(([^)\s:]*?)(?:#([^)\s]*))?\)")
NAMED_FILE = re.compile(r"`([\w./-]+\.(?:hpp|cpp|sv|sh|py|cmake|js))`")
NAMED_PATH = re.compile(r"`((?:src|configs|traces|docs|examples|scripts|tests|rtl|cmake|bench|fuzz|python)/[\w./-]*)`")
COMMENT = {".cpp": "//", ".hpp": "//", ".js": "//", ".sv": "//"}

# Files that a reader is to write, or that a build makes.
MADE = {"page.hpp", "stage.cpp", "stage.hpp", "design.cpp", "shelf.cpp", "deflate.cpp"}


def tracked() -> list[str]:
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=False)
    if listed.returncode != 0:  # an archive without its history
        return sorted(str(file.relative_to(ROOT)) for file in ROOT.rglob("*") if file.is_file() and "build" not in file.parts)
    return [name for name in listed.stdout.splitlines() if (ROOT / name).is_file()]


@lru_cache(maxsize=None)
def headings(page: Path) -> frozenset[str]:
    """Anchors, as GitHub makes them."""
    anchors: dict[str, int] = {}
    found = set()
    in_block = False
    for line in page.read_text(encoding="utf-8").splitlines():
        in_block ^= line.startswith("```")
        match = None if in_block else re.match(r"#+ (.*)", line)
        if match:
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", match.group(1)).lower()
            anchor = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
            count = anchors.get(anchor, 0)
            anchors[anchor] = count + 1
            found.add(anchor if count == 0 else f"{anchor}-{count}")
    return frozenset(found)


class Complaints:
    def __init__(self) -> None:
        self.count = 0

    def add(self, file: str, line: int, what: str) -> None:
        print(f"{file}:{line}: {what}", file=sys.stderr)
        self.count += 1


def check_target(complaints: Complaints, file: str, line: int, page: Path, heading: str) -> None:
    if not page.exists():
        complaints.add(file, line, f"no page {page.relative_to(ROOT) if page.is_relative_to(ROOT) else page}")
    elif heading and page.suffix == ".md" and heading not in headings(page):
        complaints.add(file, line, f"{page.relative_to(ROOT)} has no heading #{heading}")


def joined_comments(lines: list[str], mark: str) -> list[tuple[int, str]]:
    """Comments of several lines as one text, each with its first line's number."""
    comments: list[tuple[int, str]] = []
    last = -2
    for number, line in enumerate(lines, start=1):
        match = re.search(re.escape(mark) + r"[/!]*<?\s?(.*)", line)
        if not match:
            continue
        is_alone = line.lstrip().startswith(mark)
        if is_alone and last == number - 1:
            first, text = comments[-1]
            comments[-1] = (first, text + " " + match.group(1).strip())
        else:
            comments.append((number, match.group(1).strip()))
        last = number if is_alone else -2
    return comments


def check_source(complaints: Complaints, name: str, lines: list[str]) -> None:
    for number, line in enumerate(lines, start=1):
        for match in REFERENCE.finditer(line):
            check_target(complaints, name, number, ROOT / match.group(1), match.group(2) or "")
    mark = COMMENT.get(Path(name).suffix)
    for number, text in joined_comments(lines, mark) if mark else []:
        if NEEDS_A_NEIGHBOUR.match(text):
            complaints.add(name, number, f"'{text[:40]}': a comment has a subject of its own")


def check_page(complaints: Complaints, name: str, lines: list[str], files: frozenset[str]) -> None:
    page = ROOT / name
    in_block = False
    for number, line in enumerate(lines, start=1):
        in_block ^= line.startswith("```")
        if in_block:
            continue
        for target, heading in LINK.findall(line):
            if not target.startswith("/"):
                check_target(complaints, name, number, (page.parent / target).resolve() if target else page, heading)
        if name == "CHANGELOG.md":  # which names what is gone
            continue
        for path in NAMED_PATH.findall(line):
            if "NNNN" not in path and not (ROOT / path).exists():
                complaints.add(name, number, f"no path {path}")
        for file in NAMED_FILE.findall(line):
            if file not in MADE and not any(known == file or known.endswith("/" + file) for known in files):
                complaints.add(name, number, f"no file {file}")


def main() -> int:
    complaints = Complaints()
    names = tracked()
    files = frozenset(names)
    for name in names:
        if Path(name).suffix not in SOURCES and not name.endswith(PAGES):
            continue
        lines = (ROOT / name).read_text(encoding="utf-8", errors="replace").splitlines()
        if name != "scripts/check-comments.py":
            for number, line in enumerate(lines, start=1):
                if UNKNOWN_PAGE.search(line):
                    complaints.add(name, number, f"'{line.strip()[:60]}': names a page that is not here")
        if name.endswith(PAGES):
            check_page(complaints, name, lines, files)
        else:
            check_source(complaints, name, lines)
    if complaints.count:
        print(f"check-comments: {complaints.count} places", file=sys.stderr)
        return 1
    print(f"check-comments: {len(names)} files lead somewhere and stand alone")
    return 0


if __name__ == "__main__":
    sys.exit(main())
