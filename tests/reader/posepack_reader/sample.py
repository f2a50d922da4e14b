# SPDX-License-Identifier: MIT
"""A clip at a phase (section 11), in single precision, under every row scheme."""
import struct

from posepack_reader.dualquat import blended_dualquat_matrices, dualquat_matrices, f32_blend, rounded
from posepack_reader.values import value

MAT4_PLACES = [4 * column + row for row in range(3) for column in range(4)]


class Sampler:
    """The poses of one clip of a container whose rules have been checked."""

    def __init__(self, container, number):
        self.container = container
        self.clip = container.clips[number]
        self.runs = container.runs[number] if container.runs else None
        self.slots = container.slots[number] if container.runs else []
        self.length = value(container.header["dualquat_length"])
        self.bones = range(container.header["bone_count"])
        self.letter = "e" if container.texel_bytes == 8 else "f"
        self.rows = {}  # palette row: its numbers

    def intervals(self, bone):
        if self.runs:
            return self.runs[bone][1]
        rows = self.clip["row_count"]
        return rows if self.clip["wrap"] == 0 and rows > 1 else rows - 1

    def wraps(self):
        """Row 0 comes behind the last one."""
        return not self.runs and self.clip["wrap"] == 0 and self.clip["row_count"] > 1 and not self.clip["closing_row"]

    def run(self, bone):
        """First texel, texels from row to row and from texel to texel, intervals, and whether it wraps."""
        h = self.container.header
        if self.runs:
            texels = self.clip["texels_per_bone"]
            return (self.clip["first_texel"] + self.runs[bone][0] * texels, texels, 1, self.intervals(bone), 0)
        places = self.container.places(bone)
        return (self.clip["first_texel"] + places[0], h["bone_count"] * h["texels_per_bone"], places[1] - places[0],
                self.intervals(bone), int(self.wraps()))

    def numbers(self, bone, row):
        """What is stored for a bone in a row of its run: a texel behind the other."""
        if self.runs:
            bits = self.container.bone_row_bits(self.clip, self.runs[bone][0] + row)
            return struct.unpack(f"<{len(bits)}{self.letter}",
                                 struct.pack(f"<{len(bits)}{'H' if self.letter == 'e' else 'I'}", *bits))
        row += self.clip["first_row"]
        if row not in self.rows:
            block = self.container.place_bytes(row)
            self.rows[row] = struct.unpack(f"<{4 * len(block) // self.container.texel_bytes}{self.letter}", block)
        return [self.rows[row][4 * place + c] for place in self.container.places(bone) for c in range(4)]

    @staticmethod
    def part(share, count):
        """The whole part of `share` x `count`, below `count`, and the rest."""
        position = rounded([share * count])[0]
        whole = max(0, min(int(position), count - 1))
        return whole, rounded([position - whole])[0]

    def in_slots(self, phase):
        """A row, and how far the clip is on its way to the next."""
        slot, along = self.part(phase, len(self.slots))
        row, offset, span = self.slots[slot]
        if span:
            return row, rounded([rounded([offset + along])[0] / span])[0]
        rows, factor = self.part(along, offset)
        return row + rows, factor

    def place(self, bone, phase):
        """Two rows of the bone's run and the factor of the second."""
        count = self.intervals(bone)
        row, factor = self.in_slots(phase) if self.slots and count > 0 else self.part(phase, count)
        following = 0 if self.wraps() and row + 1 == count else row + 1
        if self.clip["interpolation"] == 1 or row in self.clip["cuts"]:
            return following if factor == 1.0 else row, following, 0.0
        return row, following, factor

    def decode(self, stored):
        """Matrices, twelve lists, of bone-rows, as many lists as numbers."""
        if self.clip["encoding"] == 3:
            return dualquat_matrices(stored, self.length)
        return [stored[place] for place in MAT4_PLACES] if self.clip["encoding"] == 1 else stored

    def blend(self, first, second, factor):
        if self.clip["encoding"] == 3:
            return blended_dualquat_matrices(first, second, factor, self.length)
        return [f32_blend(a, b, factor) for a, b in zip(self.decode(first), self.decode(second))]

    def pose(self, phase):
        """Twelve floats a bone."""
        phase = min(max(phase, 0.0), 1.0) if phase == phase else 0.0
        places = [self.place(bone, phase) for bone in self.bones]
        out = [None] * len(places)
        for moving in (False, True):
            bones = [bone for bone in self.bones if (places[bone][2] > 0.0) == moving]
            if not bones:
                continue
            first = list(zip(*(self.numbers(bone, places[bone][0]) for bone in bones)))
            if moving:
                second = list(zip(*(self.numbers(bone, places[bone][1]) for bone in bones)))
                matrices = self.blend(first, second, [places[bone][2] for bone in bones])
            else:
                matrices = self.decode(first)
            for bone, matrix in zip(bones, zip(*matrices)):
                out[bone] = matrix
        return out
