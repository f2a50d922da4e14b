#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The state of the tree: licence lines, file sizes, and nothing in it that belongs to one machine."""

import os
import re
import sys

import guard

LARGEST_BYTES = 1_000_000
SPDX = "SPDX-License-Identifier: MIT"
CODE_ENDINGS = (".c", ".h", ".cpp", ".hpp", ".def", ".py", ".sh", ".cmake", ".mjs", ".js", ".cjs", ".glsl")
CODE_NAMES = {"dev", "run", "CMakeLists.txt"}

# Text that only makes sense on the machine where it was written.
FOREIGN = [
    (re.compile(r"(?<![\w.])/(?:work|home|Users|farm)/\w"), "a path of one machine"),
    (re.compile(r"(?<![\w.])/root/"), "a path of one machine"),
    (re.compile(r"[\"'\s(][A-Z]:\\Users\\"), "a path of one machine"),
]
REGISTRY = re.compile(r'"resolved":\s*"https?:')


def is_code(path):
    return path.endswith(CODE_ENDINGS) or os.path.basename(path) in CODE_NAMES


def check_text(report, path, text):
    if is_code(path) and SPDX not in "\n".join(text.split("\n", 3)[:3]):
        report.fault(path, f"expected '{SPDX}' in the first three lines")
    for number, line in enumerate(text.split("\n"), 1):
        for pattern, what in FOREIGN:
            if pattern.search(line):
                report.fault(f"{path}:{number}", f"found {what}: {line.strip()[:100]}")
    if REGISTRY.search(text):
        report.fault(path, 'expected no "resolved" addresses of a registry; .npmrc leaves them out')


def main():
    root = guard.project_root()
    report = guard.Report("files of the tree")
    for path in guard.project_files(root):
        report.looked()
        size = os.path.getsize(os.path.join(root, path))
        if size > LARGEST_BYTES:
            report.fault(path, f"expected at most {LARGEST_BYTES:,} bytes, found {size:,}")
            continue
        try:
            text = guard.read_text(root, path)
        except UnicodeDecodeError:
            continue  # binary: fixtures and pictures
        if not path.endswith("tests/guard/tree.py"):
            check_text(report, path, text)
    return report.finish()


if __name__ == "__main__":
    sys.exit(main())
