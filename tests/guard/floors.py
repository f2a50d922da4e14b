#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rooms include rooms on lower floors only, and third-party headers enter by one door each. The table of
CONTRIBUTING.md names every room on its floor.

A header that shows a third-party header behind a door is private: only its own room may include it."""

import re
import sys

import guard

FLOORS = {
    "format": 0, "base": 0,
    "loader": 1, "recipe": 1,
    "animal": 2, "menagerie": 2,
    "motion": 3,
    "palette": 4, "vat": 4,
    "measure": 5, "fit": 5,
    "choose": 6,
    "output": 7,
    "bake": 8,
    "stress": 9,
    "cli": 10,
}
PRINTING_FLOOR = 7  # rooms below return what they have to say

# Pattern of an include, the rooms whose files may hold it, and whether their public headers may too.
DOORS = [
    (r"tiny_gltf\.h", {"animal"}, False),
    (r"draco/|meshoptimizer\.h", {"animal"}, False),
    (r"OpenEXR/|Imf[A-Z]|Imath|half\.h", {"output"}, False),
    (r"OpenImageIO/", {"output"}, False),
    (r"png\.h", {"output"}, False),
    (r"CLI/", {"cli"}, True),
    (r"nettle/", {"base"}, False),
    (r"rapidjson/", {"base", "animal"}, False),
    (r"nlohmann/", {"base", "recipe", "output", "bake", "stress", "cli", "menagerie"}, False),
    (r"glm/", {room for room, floor in FLOORS.items() if floor >= 2}, True),
    (r"fmt/", {room for room in FLOORS if room not in ("format", "loader")}, True),
]
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
PRINTING = re.compile(r"\bstd::(?:cout|cerr|clog|puts|printf|fprintf)\b|(?<![\w.>:])(?:printf|fprintf|puts|perror)\s*\("
                      r"|\bfmt::(?:print|println)\b")
COMMENTS = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
TABLE_LINE = re.compile(r"^\| (\d+) \| ([^|]+) \|", re.MULTILINE)
ROOM_NAME = re.compile(r"`(\w+)`")
STRINGS = re.compile(r'"(?:[^"\\\n]|\\.)*"')


def blank(match):
    """The text of a match without its characters, so that line numbers stay."""
    return re.sub(r"[^\n]", " ", match.group(0))


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def check_room_include(report, where, room, target):
    """An include of another room: it must lie lower; the loader and the format see the format alone."""
    if room == target:
        return
    if room in ("loader", "format") and target != "format":
        report.fault(where, f"expected {room}/ to include only format/, found {target}/")
    elif FLOORS[target] >= FLOORS[room]:
        report.fault(where, f"expected a floor below {FLOORS[room]} ({room}), found {target}/ on floor {FLOORS[target]}")


def check_door(report, where, room, name):
    for pattern, rooms, _ in DOORS:
        if re.match(pattern, name) and room not in rooms:
            report.fault(where, f"<{name}> enters by {', '.join(sorted(rooms))} only, found in {room}")


def is_private(text):
    """True for the text of a header that shows what must stay behind its door."""
    return any(re.match(pattern, match.group(2)) for match in INCLUDE.finditer(text)
               for pattern, _, headers_too in DOORS if not headers_too)


def check_includes(report, path, room, text, private_headers):
    for match in INCLUDE.finditer(text):
        report.looked()
        name, where = match.group(2), f"{path}:{line_of(text, match.start())}"
        top = name.split("/")[0]
        if top == "posepack" and room == "base":
            report.fault(where, "base/ knows neither the format nor the loader")
        elif top == "posepack" and name != "posepack/format.h" and FLOORS[room] < 1:
            report.fault(where, f"expected {room}/ to include only posepack/format.h, found {name}")
        elif match.group(1) == '"' and top in FLOORS and "/" in name:
            check_room_include(report, where, room, top)
        elif match.group(1) == '"' and "/" not in name:
            report.fault(where, f'expected the room in the name ("{room}/{name}"), found "{name}"')
        if name in private_headers and top != room:
            report.fault(where, f"{name} is private to {top}/: it shows a third-party header")
        if name == "iostream" and room != "cli":
            report.fault(where, "<iostream> belongs to cli/ alone")
        check_door(report, where, room, name)


def check_printing(report, path, room, text):
    if FLOORS[room] >= PRINTING_FLOOR:
        return
    for match in PRINTING.finditer(STRINGS.sub(blank, text)):
        report.fault(f"{path}:{line_of(text, match.start())}", f"{room}/ does not print, found {match.group(0)}")


def check_public(report, path, text):
    for match in INCLUDE.finditer(text):
        report.looked()
        if not re.match(r"posepack/|std\w+\.h$", match.group(2)):
            report.fault(path, f"public headers include C's own headers only, found <{match.group(2)}>")


def check_table(report, text):
    """The table of people: each room of FLOORS is there, on the floor it has here."""
    table = {room: int(line.group(1)) for line in TABLE_LINE.finditer(text) for room in ROOM_NAME.findall(line.group(2))}
    for room in sorted(FLOORS.keys() | table.keys()):
        report.looked()
        if table.get(room) != FLOORS.get(room):
            report.fault("CONTRIBUTING.md", f"expected {room} on floor {FLOORS.get(room)}, found {table.get(room)}")


def main():
    root = guard.project_root()
    report = guard.Report("includes of rooms")
    texts = {path: COMMENTS.sub(blank, guard.read_text(root, path)) for path in guard.project_files(root)
             if path.startswith(("src/", "include/")) and path.endswith((".c", ".h", ".cpp", ".hpp", ".def"))}
    private_headers = {path.split("/", 1)[1] for path, text in texts.items()
                       if path.startswith("src/") and path.endswith(".hpp") and is_private(text)}
    for path, text in texts.items():
        parts = path.split("/")
        if parts[0] == "include":
            check_public(report, path, text)
        elif len(parts) > 2 and parts[1] in FLOORS:
            check_includes(report, path, parts[1], text, private_headers)
            check_printing(report, path, parts[1], text)
        else:
            report.fault(path, f"{parts[1]} has no floor yet: name its room in tests/guard/floors.py")
    if "CONTRIBUTING.md" in guard.project_files(root):
        check_table(report, guard.read_text(root, "CONTRIBUTING.md"))
    return report.finish()


if __name__ == "__main__":
    sys.exit(main())
