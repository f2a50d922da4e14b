#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The rules of the corpus tables must find what they forbid: wrong rows, each with the fault that it must get."""

import sys

import rules
import table

# row, whether something moves, whether of invalid/, part of the fault or None where there must be none
CASES = [
    (table.Row("a.glb", 3, "E-GLB-SCHEMA", "valid"), True, True, "valid, so it must not be refused as malformed"),
    (table.Row("a.glb", 3, "E-GLB-SCHEMA", "valid", "Because."), True, True, "must not be refused as malformed"),
    (table.Row("a.glb", 3, "E-GLB-TRAILING", "warned"), True, True, "expected a sentence"),
    (table.Row("a.glb", 3, "E-GLB-TRAILING", "warned", "Because."), True, True, None),
    (table.Row("a.glb", 0, "-", "error"), True, True, "expected a sentence"),
    (table.Row("a.glb", 0, "-", "error", "Because."), True, True, None),
    (table.Row("a.glb", 0, "-", "valid"), True, True, None),
    (table.Row("a.glb", 0, "-", "valid"), False, True, "nothing in it moves, yet it bakes"),
    (table.Row("a.glb", 0, "-", "valid", "Because."), True, True, "nothing to explain"),
    (table.Row("a.glb", 5, "E-GLB-NO-MESH", "valid", "Because."), False, True, "expected E-GLB-NO-ANIMATION"),
    (table.Row("a.glb", 5, "E-GLB-NO-ANIMATION", "valid"), False, True, None),
    (table.Row("a.glb", 5, "E-GLB-NO-ANIMATION", "valid"), True, True, "expected a sentence"),
    (table.Row("a.glb", 5, "E-GLB-NO-ANIMATION", "error"), False, True, "expected a sentence"),
    (table.Row("a.glb", 5, "E-GLB-SCHEMA", "error", "Because."), None, True, "does not go with exit code 5"),
    (table.Row("a.glb", 0, "E-GLB-SCHEMA", "valid"), True, True, "does not go with exit code 0"),
    (table.Row("a.glb", 70, "E-INTERNAL", "none"), None, True, "expected exit code 0, 3, 5 or 6"),
    (table.Row("a.glb", 3, "E-GLB-IBM"), True, False, "expected a sentence"),
    (table.Row("a.glb", 3, "E-GLB-IBM", "none", "Because."), True, False, None),
]
VERDICTS = [("Validator: valid (infos only)", "valid"), ("Validator: W:GLB_EXTRA_DATA", "warned"),
            ("Validator: E:NODE_LOOP", "error"), ("Validator: E:A W:B", "error"), ("x [validator: no error]", "valid"),
            ("x [validator: VALIDATOR CRASHED]", "none"), ("x [validator: NODE_LOOP]", "error"), ("node cycle", "none")]


def main():
    exits = rules.issue_exits(sys.argv[1])
    wrong = 0
    for row, is_moving, is_invalid, part in CASES:
        faults = rules.faults_of(row, exits, is_moving, is_invalid)
        if bool(faults) != (part is not None) or (part and not any(part in fault for fault in faults)):
            print(f"{row.line().strip()}: expected '{part}', found {faults}")
            wrong += 1
    for text, verdict in VERDICTS:
        if rules.verdict_of(text) != verdict:
            print(f"{text}: expected {verdict}, found {rules.verdict_of(text)}")
            wrong += 1
    print(f"rules of the corpus tables: {len(CASES) + len(VERDICTS)} cases, {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
