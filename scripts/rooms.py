#!/usr/bin/env python3
"""Fails on a source file that breaks a rule of the house which can be read off it: scripts/rooms.py [ROOT]

Rooms: the folders of src/. shared/ includes no other room; depth/, results/ and the two algorithms include shared/ and
themselves; only the files beside the rooms include all of them. Every .cpp includes precomp.hpp first. A name stands for one file, or for a header and the .cpp
that defines what it declares.
All C++: the licence first, at most 500 lines of at most 120 columns, no macros but include guards.
"""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "shared": {"shared"},
    "depth": {"shared", "depth"},
    "gwatershed": {"shared", "gwatershed"},
    "rgwatershed": {"shared", "rgwatershed"},
    "results": {"shared", "results"},
}
FOLDERS = "include", "src", "test", "perf", "samples", "tools"
MAX_LINES = 500
MAX_COLUMNS = 120

problems = []


def report(path, line, what):
    problems.append("%s:%d: %s" % (path.relative_to(root), line, what))


def room_of(path):
    """The room of a path relative to src/; "" for what stands beside the rooms."""
    return path.parts[0] if len(path.parts) > 1 else ""


def check_includes(src, path):
    first = re.search(r'^\s*#\s*include\s*(\S+)', path.read_text(), re.MULTILINE)
    if path.suffix == ".cpp" and first and first[1] != '"precomp.hpp"':
        report(path, 1, 'the first header is not "precomp.hpp"')
    room = room_of(path.relative_to(src))
    if room and room not in MAY_INCLUDE:
        report(path, 1, "the room %s has no rule in scripts/rooms.py" % room)
        return
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*"([^"]+)"', line)
        if not match:
            continue
        if match[1] == "precomp.hpp" or match[1].startswith("opencv2/"):
            continue
        if not (src / match[1]).is_file() or ".." in match[1]:
            report(path, number, '"%s" is not a path from src/' % match[1])
        elif room and room_of(pathlib.Path(match[1])) not in MAY_INCLUDE[room]:
            report(path, number, 'a file of %s/ must not include "%s"' % (room, match[1]))


def check_names(files):
    """Base names are unique, and what a header declares is defined in the .cpp beside it."""
    first = {}
    for path in files:
        other = first.setdefault(path.stem, path)
        if other.parent != path.parent:
            report(path, 1, "there is a %s, too" % other.relative_to(root))
    for path in files:
        if path.suffix != ".hpp" or path.with_suffix(".cpp").is_file():
            continue
        code = re.sub(r"//.*", "", path.read_text())
        # A declaration of a function at the left margin, also over several lines.
        for match in re.finditer(r"^(?!#|using |typedef |static_assert)\w[^;{}=]*\)( const)?;", code, re.MULTILINE):
            line = code.count("\n", 0, match.start()) + 1
            report(path, line, "declared here, and there is no %s.cpp to define it" % path.stem)


def check_text(path):
    lines = path.read_text().splitlines()
    if not lines or lines[0] != "// This file is part of OpenCV project.":
        report(path, 1, "the first lines are those of OpenCV's licence")
    if len(lines) > MAX_LINES:
        report(path, len(lines), "%d lines; at most %d" % (len(lines), MAX_LINES))
    for number, line in enumerate(lines, 1):
        if len(line) > MAX_COLUMNS:
            report(path, number, "%d columns; at most %d" % (len(line), MAX_COLUMNS))
        if re.match(r"\s*#\s*define(?!\s+\w+_HPP$)", line):
            report(path, number, "a macro")


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".cpp", ".hpp"))


root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
for source in sources(root / "src"):
    check_includes(root / "src", source)
check_names(sources(root / "src"))
for folder in FOLDERS:
    for source in sources(root / folder):
        check_text(source)
print("\n".join(problems) or "the rooms are in order")
sys.exit(bool(problems))
