# SPDX-License-Identifier: MIT
"""A second reader of posepack containers, written from docs/format/posepack-1.md alone.

It shares no line with the C loader and uses only the standard library. It checks every rule of section 14 of the
specification and prints everything a container says. One module a room of the specification: values, framing, tables,
clips, texels, runs, sample, dualquat; dump prints.

    python3 tests/reader/posepack_reader FILE.posepack

A file that breaks a rule prints one line, `refused RESULT`.
"""
from posepack_reader.clips import Clips
from posepack_reader.dump import dump
from posepack_reader.framing import Framing
from posepack_reader.runs import Runs
from posepack_reader.tables import Tables
from posepack_reader.texels import Texels
from posepack_reader.values import Refused


class Container(Framing, Tables, Clips, Runs, Texels):
    """A container whose every rule has been checked."""

    def __init__(self, data):
        self.data = data
        self.read_header()
        self.read_table()
        self.place_sections()
        self.check_header_values()
        self.read_strings()
        self.read_bones()
        self.read_space()
        self.read_clips()
        self.read_states()
        self.read_runs()
        self.check_texels()


def dump_bytes(data):
    """Lines of the dump of a container in memory, or the one line that says why it is refused."""
    try:
        container = Container(data)
    except Refused as refusal:
        return [f"refused {refusal}"]
    return list(dump(container))
