# SPDX-License-Identifier: MIT
"""Runs, slots, and the texture that they lie in (section 10; rules R, L, G and X)."""
import itertools
import struct

from posepack_reader.values import require, u32s


class Runs:
    """Reads RUNS, and PIXL behind it. Needs what Framing and Clips have read."""

    def read_runs(self):
        """`self.runs[clip][bone]` is (offset, interval_count)."""
        h = self.header
        self.runs = []
        if h["row_scheme"] != 2:
            return
        words = self.bytes_of["RUNS"]
        require(len(words) == 4 * h["clip_count"] * h["bone_count"])  # R1
        require(h["texel_order"] == 0)  # R2
        texel = 0
        for number, clip in enumerate(self.clips):
            own = u32s(words, 4 * number * h["bone_count"], h["bone_count"])
            self.runs.append([(word & 0xFFFFF, word >> 20) for word in own])
            bone_rows = 0
            for offset, intervals in self.runs[-1]:
                end = offset + intervals + 1
                require(offset == bone_rows or end <= bone_rows)  # R3
                bone_rows = max(bone_rows, end)
            require(clip["row_count"] == max(intervals for _, intervals in self.runs[-1]) + 1)  # R4
            require(clip["first_texel"] == texel)  # R5
            texel += bone_rows * clip["texels_per_bone"]
        self.run_texels = texel
        self.read_slots()

    def read_slots(self):
        """`self.slots[clip]` is a list of (row, offset, span), empty where the clip has none."""
        self.slots = [[] for _ in self.clips]
        require(("SLOT" in self.bytes_of) == any(clip["row_scheme"] == 1 for clip in self.clips))  # L1
        if "SLOT" not in self.bytes_of:
            return
        data = self.bytes_of["SLOT"]
        at = 8 * len(self.clips)
        require(len(data) >= at)  # L2
        words = u32s(data, 0, 2 * len(self.clips))
        room = (len(data) - at) // 4
        used = 0
        for clip, runs, slots, first, count in zip(self.clips, self.runs, self.slots, words[0::2], words[1::2]):
            require(first == used and count <= room - used)  # L3
            require((count > 0) == (clip["row_scheme"] == 1))  # L3
            used += count
            for row, offset, span in struct.iter_unpack("<HBB", data[at + 4 * first:at + 4 * used]):
                require(offset < span or span == 0)  # L4
                require(row + (offset if span == 0 else 1) < clip["row_count"])  # L4
                slots.append((row, offset, span))
            require(not slots or {n for _, n in runs} <= {0, clip["row_count"] - 1})  # L5
        require(len(data) == at + 4 * used)  # L6

    def check_run_texels(self):
        h = self.header
        row_texels = self.clips[-1]["texels_per_bone"]
        needed = self.run_texels + row_texels
        width = next(1 << log2 for log2 in itertools.count(6) if -(-needed >> log2) <= 4096)
        require(h["rows_per_line"] == 1)  # G1
        require(h["texture_width"] == width)  # G2
        require(h["texture_height"] == -(-needed // width))  # G3
        require(h["row_pitch"] == width * self.texel_bytes)  # G4
        require(self.pixl.raw_bytes == h["row_pitch"] * h["texture_height"] <= 1 << 28)  # G5, G6
        require(self.pixl.flags == 0, "NEEDS_DECODE")  # X5
        letter, mask = ("H", 0x7C00) if self.texel_bytes == 8 else ("I", 0x7F800000)
        self.run_bits = struct.unpack(f"<{4 * len(self.pixels) // self.texel_bytes}{letter}", self.pixels)
        require(not any(bits & mask == mask for bits in self.run_bits))  # X1
        for clip, runs in zip(self.clips, self.runs):
            for offset, intervals in runs:
                self.check_run(clip, offset, intervals)
        used, row = self.run_texels * self.texel_bytes, row_texels * self.texel_bytes
        repeated = self.pixels[used - row:used] * -(-(len(self.pixels) - used) // row)
        require(self.pixels[used:] == repeated[:len(self.pixels) - used])  # X3

    def bone_row_bits(self, clip, bone_row):
        """The components of a bone-row, counted from the clip's first, as integers."""
        start = 4 * (clip["first_texel"] + bone_row * clip["texels_per_bone"])
        return self.run_bits[start:start + 4 * clip["texels_per_bone"]]

    def check_run(self, clip, offset, intervals):
        half = self.texel_bytes == 8
        sign, quarter, one, two = ((0x8000, 0x3400, 0x3C00, 0x4000) if half else
                                   (0x80000000, 0x3E800000, 0x3F800000, 0x40000000))
        rows = [self.bone_row_bits(clip, offset + row) for row in range(intervals + 1)]
        if clip["encoding"] == 1:
            require(all(row[3::4] == (0, 0, 0, one) for row in rows))  # X2
        if clip["encoding"] == 3:
            require(all(quarter <= max(b & ~sign for b in row[0:4]) <= two for row in rows))  # X6
        if clip["wrap"] == 0:
            turns = {a ^ b for a, b in zip(rows[0], rows[-1])}
            require(turns == {0} or clip["encoding"] == 3 and turns == {sign})  # X8
