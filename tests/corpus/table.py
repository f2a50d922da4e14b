# SPDX-License-Identifier: MIT
"""Tables of results: one file of assets a line, columns between bars."""

import re

HEAD = "# SPDX-License-Identifier: MIT\n# file | exit code | issue | verdict of the validator | why it differs\n"


class Row:
    def __init__(self, file, exit_code, issue, verdict="none", sentence=""):
        self.file, self.exit_code, self.issue = file, exit_code, issue
        self.verdict, self.sentence = verdict, sentence

    def line(self):
        cells = [self.file, str(self.exit_code), self.issue, self.verdict, self.sentence]
        return " | ".join(cells).rstrip() + "\n"


def parse(text):
    """The rows of a table by file; a line that is none, or a file named twice, is an error."""
    rows = {}
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("#"):
            continue
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) != 5 or not cells[1].isdigit() or cells[0] in rows:
            raise ValueError(f"line {number}: expected 'file | exit code | issue | verdict | sentence', once a file: {line}")
        rows[cells[0]] = Row(cells[0], int(cells[1]), cells[2], cells[3], cells[4])
    return rows


def render(rows):
    return HEAD + "".join(row.line() for row in sorted(rows, key=lambda row: row.file))


def readme_rows(text):
    """Every table row of the assets' README that begins with a GLB: file -> all its rows, one after the other."""
    rows = {}
    for line in text.splitlines():
        found = re.match(r"\| (\S+\.glb) \| ", line)
        if found:
            rows.setdefault(found.group(1), []).append(line)
    return {file: "\n".join(lines) for file, lines in rows.items()}
