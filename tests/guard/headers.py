#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every header compiles alone: those of the compiler as C++20, the public ones as C99 and as C++17."""

import concurrent.futures
import os
import subprocess
import sys

import guard

CXX20 = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
C99 = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Werror"]
CXX17 = ["-std=c++17", "-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Werror"]


def jobs_for(path):
    """Command lines (without folders) that must accept a file which includes nothing but this header."""
    if path.startswith("src/") and path.endswith(".hpp"):
        return [[compiler, "-x", "c++", *CXX20] for compiler in guard.available("g++", "clang++")[:1]]
    if path.startswith("src/") and path.endswith(".h"):
        return [[compiler, "-x", "c", *C99] for compiler in guard.available("gcc", "clang")]
    if path.startswith("include/posepack/") and path.endswith(".h"):
        return ([[compiler, "-x", "c", *C99] for compiler in guard.available("gcc", "clang")] +
                [[compiler, "-x", "c++", *CXX17] for compiler in guard.available("g++", "clang++")])
    return []


def compile_alone(root, path, command):
    """Compiles a file that includes the header twice. Returns what the compiler said, or None when it agreed."""
    include = path.split("/", 1)[1]  # "posepack/loader.h", "base/text.hpp": as everybody includes it
    text = f'#include "{include}"\n#include "{include}"\nint posepack_header_alone(void);\n'
    result = subprocess.run([*command, "-fsyntax-only", "-I", os.path.join(root, "src"),
                             "-I", os.path.join(root, "include"), "-"],
                            input=text, capture_output=True, text=True)
    return None if result.returncode == 0 else result.stderr.strip()


def main():
    root = guard.project_root()
    report = guard.Report("headers compiled alone")
    work = [(path, command) for path in guard.project_files(root) for command in jobs_for(path)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        answers = pool.map(lambda job: compile_alone(root, *job), work)
        for (path, command), answer in zip(work, answers):
            report.looked()
            if answer is not None:
                report.fault(f"{path} ({command[0]} {command[3]})", answer)
    return report.finish()


if __name__ == "__main__":
    sys.exit(main())
