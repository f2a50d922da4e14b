# SPDX-License-Identifier: MIT
"""The texture of uniform rows: its geometry, the texels and where a bone-row lies (section 10; rules G and X)."""
import struct

from posepack_reader.values import is_zero, require


class Texels:
    """Reads PIXL where rows are uniform. Needs what Framing and Clips have read."""

    def check_texels(self):
        self.texel_bytes = {1: 8, 2: 16}[self.header["texel_format"]]
        self.pixl = next(section for section in self.sections if section.name() == "PIXL")
        self.pixels = self.bytes_of["PIXL"]
        if self.header["row_scheme"] == 2:
            self.check_run_texels()
        else:
            self.check_uniform_texels()

    def check_uniform_texels(self):
        h = self.header
        per_line, rows = h["rows_per_line"], h["row_count"]
        row_texels = h["bone_count"] * h["texels_per_bone"]
        self.row_bytes = row_texels * self.texel_bytes
        tight = per_line * self.row_bytes
        require(1 <= per_line <= rows)  # G1
        require(h["texture_width"] == per_line * row_texels)  # G2
        require(h["texture_height"] == -(-rows // per_line))  # G3
        require(h["row_pitch"] in (tight, -(-tight // 256) * 256))  # G4
        require(self.pixl.raw_bytes == h["row_pitch"] * h["texture_height"] <= 1 << 28)  # G5, G6
        require(self.pixl.flags == 0, "NEEDS_DECODE")  # X5
        for line in range(h["texture_height"]):
            start = line * h["row_pitch"]
            for row in range(line * per_line, (line + 1) * per_line):
                self.check_row(min(row, rows - 1))  # X1, X2
                if row >= rows:
                    require(self.place_bytes(row) == self.place_bytes(rows - 1))  # X3
            require(is_zero(self.pixels[start + tight:start + h["row_pitch"]]), "PADDING")  # X4
        for clip in self.clips:
            if clip["closing_row"]:
                self.check_closing_row(clip)  # X7

    def place_bytes(self, row):
        """The bytes of the block of a row, or of a place behind the last row."""
        per_line = self.header["rows_per_line"]
        start = row // per_line * self.header["row_pitch"] + row % per_line * self.row_bytes
        return self.pixels[start:start + self.row_bytes]

    def row_bits(self, row):
        """Components of the block of a row as integers: of halves or of floats."""
        block = self.place_bytes(row)
        letter, size = ("H", 2) if self.texel_bytes == 8 else ("I", 4)
        return struct.unpack(f"<{len(block) // size}{letter}", block)

    def check_row(self, row):
        bits = self.row_bits(row)
        mask, one = (0x7C00, 0x3C00) if self.texel_bytes == 8 else (0x7F800000, 0x3F800000)
        require(not any(b & mask == mask for b in bits))  # X1
        if self.header["encoding"] == 1:
            for bone in range(self.header["bone_count"]):
                places = self.places(bone)
                require([bits[4 * place + 3] for place in places] == [0, 0, 0, one])  # X2

        if self.header["encoding"] == 3:
            half = self.texel_bytes == 8
            sign, quarter, two = (0x8000, 0x3400, 0x4000) if half else (0x80000000, 0x3E800000, 0x40000000)
            for bone in range(self.header["bone_count"]):
                place = 4 * self.places(bone)[0]
                require(quarter <= max(b & ~sign for b in bits[place:place + 4]) <= two)  # X6

    def check_closing_row(self, clip):
        """A closing row has the bits of row 0, of some bones with all eight signs turned."""
        sign = 0x8000 if self.texel_bytes == 8 else 0x80000000
        first, closing = (self.row_bits(row) for row in (clip["first_row"], clip["first_row"] + clip["row_count"]))
        for bone in range(self.header["bone_count"]):
            turns = {first[4 * place + c] ^ closing[4 * place + c] for place in self.places(bone) for c in range(4)}
            require(turns in ({0}, {sign}))

    def places(self, bone):
        """Places of the texels of a bone in the block of its row."""
        count, texels = self.header["bone_count"], self.header["texels_per_bone"]
        if self.header["texel_order"] == 0:
            return [bone * texels + k for k in range(texels)]
        return [k * count + bone for k in range(texels)]

    def components(self):
        """For every bone, where in the block of a row the twelve numbers of its 3x4 matrix are."""
        for bone in range(self.header["bone_count"]):
            places = self.places(bone)
            if self.header["encoding"] == 1:
                yield [4 * places[column] + row for row in range(3) for column in range(4)]
            else:
                yield [4 * places[row] + column for row in range(3) for column in range(4)]
