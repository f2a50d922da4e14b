#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The loader needs no library: it compiles freestanding as C99 and as C++, and its objects ask for nothing but
the four memory functions that compilers may call anywhere, and hold no writable data."""

import os
import subprocess
import sys
import tempfile

import guard

ALLOWED = {"memcpy", "memmove", "memset", "memcmp"}
WARNINGS = ["-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Wvla", "-Werror"]
BUILDS = [
    ("gcc", ["-x", "c", "-std=c99", "-O2", "-ffreestanding", "-fno-builtin"]),
    ("clang", ["-x", "c", "-std=c99", "-O2", "-ffreestanding", "-fno-builtin"]),
    ("gcc", ["-x", "c", "-std=c99", "-O3"]),
    ("g++", ["-x", "c++", "-std=c++17", "-O2", "-fno-exceptions", "-fno-rtti"]),
]


def symbols(objects):
    """(letter, name) of every symbol of the objects, as nm prints them."""
    listing = subprocess.run(["nm", "--format=posix", *objects], capture_output=True, text=True, check=True).stdout
    for line in listing.splitlines():
        fields = line.split()
        if len(fields) >= 2:
            yield fields[1], fields[0]


def check_build(report, root, sources, compiler, flags):
    """Compiles the sources one way and looks at the symbols of the objects together."""
    label = f"{compiler} {' '.join(flags)}"
    with tempfile.TemporaryDirectory() as folder:
        objects = []
        for source in sources:
            target = os.path.join(folder, source.replace("/", "_") + ".o")
            result = subprocess.run([compiler, *flags, *WARNINGS, "-I", os.path.join(root, "include"),
                                     "-I", os.path.join(root, "src"), "-c", os.path.join(root, source), "-o", target],
                                    capture_output=True, text=True)
            if result.returncode != 0:
                report.fault(f"{source} ({label})", result.stderr.strip())
                continue
            objects.append(target)
        found = set(symbols(objects)) if objects else set()
    report.looked(len(found))
    defined = {name for letter, name in found if letter not in "Uw"}
    for letter, name in sorted(found):
        if letter in "Uw" and name not in defined | ALLOWED:
            report.fault(label, f"expected no library function but {', '.join(sorted(ALLOWED))}, found {name}")
        if letter in "dDbBC":
            report.fault(label, f"expected no writable data, found {name}")


def main():
    root = guard.project_root()
    report = guard.Report("symbols of the loader")
    sources = [path for path in guard.project_files(root)
               if path.startswith(("src/format/", "src/loader/")) and path.endswith(".c")]
    if not any(path.startswith("src/loader/") for path in sources):
        report.fault("src/loader", "expected C files, found none")
    for compiler, flags in BUILDS:
        if guard.available(compiler):
            check_build(report, root, sources, compiler, flags)
    return report.finish()


if __name__ == "__main__":
    sys.exit(main())
