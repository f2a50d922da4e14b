#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No number that reaches a file comes from the C library's mathematics, whose last bits differ from host to host:
docs/numerical_contract.md. Square roots, rounding, and functions of signs and exponents are exact and allowed."""

import re
import sys

import guard

# Files whose results are printed for people and reach no file.
FOR_PEOPLE = {"src/bake/doctor.cpp", "src/menagerie/statistics.cpp"}
INEXACT = ["sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "exp2", "expm1", "log",
           "log2", "log10", "log1p", "pow", "cbrt", "hypot", "fma", "tgamma", "lgamma", "erf"]
CALL = re.compile(r"(?:\bstd::|\bglm::|(?<![\w.>:]))(" + "|".join(INEXACT) + r")[fl]?\s*\(")
COMMENTS = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:[^\"\\\n]|\\.)*\"", re.DOTALL)


def main():
    root = guard.project_root()
    report = guard.Report("sources without the C library's mathematics")
    for path in guard.project_files(root):
        if not path.startswith(("src/", "include/")) or not path.endswith((".c", ".h", ".cpp", ".hpp")):
            continue
        if path in FOR_PEOPLE:
            continue
        report.looked()
        text = COMMENTS.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), guard.read_text(root, path))
        for match in CALL.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            report.fault(f"{path}:{line}", f"expected base/trig.hpp or + - * / and sqrt, found {match.group(1)}()")
    return report.finish()


if __name__ == "__main__":
    sys.exit(main())
