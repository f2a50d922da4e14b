#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A second reader of posepack containers, written from docs/format/posepack-1.md alone.

It shares no line with the C loader and uses only the standard library. It checks every rule of section 14 of the
specification and prints everything a container says, in a form that the C loader's dump tool prints too:
floats as the eight hexadecimal digits of their bits, names in quotes, one bone-row a line.

    posepack_reader.py FILE.posepack

A file that breaks a rule prints one line, `refused RESULT`.
"""
import functools
import struct
import sys

MAGIC = bytes([0x8B, 0x50, 0x50, 0x4B, 0x0D, 0x0A, 0x1A, 0x0A])
NONE = 0xFFFFFFFF
REQUIRED = ("CLIP", "STAT", "BONE", "SPAC", "STRS", "PIXL")


class Refused(Exception):
    """A rule is broken; the argument is the result that the specification names."""


def require(holds, result="SEMANTIC"):
    if not holds:
        raise Refused(result)


# --- numbers ------------------------------------------------------------------------------------------------------

def u8(data, offset):
    return data[offset]


def u16(data, offset):
    return int.from_bytes(data[offset:offset + 2], "little")


def u32(data, offset):
    return int.from_bytes(data[offset:offset + 4], "little")


def u64(data, offset):
    return int.from_bytes(data[offset:offset + 8], "little")


def u32s(data, offset, count):
    return list(struct.unpack_from(f"<{count}I", data, offset))


def value(bits):
    """The number that the bits of an f32 mean."""
    return struct.unpack("<f", struct.pack("<I", bits))[0]


def is_finite(bits):
    return bits & 0x7F800000 != 0x7F800000


def is_non_negative(bits):
    return is_finite(bits) and bits >> 31 == 0


def is_positive(bits):
    return is_non_negative(bits) and bits != 0


def is_zero(data):
    return not any(data)


def is_index(index, count):
    return index == NONE or index < count


def make_crc_table():
    table = []
    for byte in range(256):
        crc = byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
        table.append(crc)
    return table


CRC_TABLE = make_crc_table()


def crc32c(data):
    crc = 0xFFFFFFFF
    table = CRC_TABLE
    for byte in data:
        crc = crc >> 8 ^ table[(crc ^ byte) & 0xFF]
    return crc ^ 0xFFFFFFFF


# --- framing ------------------------------------------------------------------------------------------------------

HEADER_FIELDS = (  # name, offset, reader
    ("major", 8, u16), ("minor", 10, u16), ("file_bytes", 16, u64), ("section_count", 24, u32),
    ("required_features", 32, u32), ("optional_features", 36, u32), ("bone_count", 40, u32), ("row_count", 44, u32),
    ("clip_count", 48, u32), ("encoding", 52, u8), ("texel_format", 53, u8), ("texels_per_bone", 54, u8),
    ("texel_order", 55, u8), ("row_scheme", 56, u8), ("space_flags", 57, u8), ("texture_width", 60, u32),
    ("texture_height", 64, u32), ("row_pitch", 68, u32), ("rows_per_line", 72, u32), ("radius_m", 76, u32),
    ("dualquat_length", 80, u32), ("bake_abi", 84, u32))
HEADER_FLOATS = ("radius_m", "dualquat_length")


class Section:
    def __init__(self, entry):
        self.type = entry[0:4]
        self.flags = u32(entry, 4)
        self.offset = u64(entry, 8)
        self.stored_bytes = u64(entry, 16)
        self.raw_bytes = u64(entry, 24)
        self.align_log2 = u32(entry, 32)
        self.crc = u32(entry, 36)
        self.raw_crc = u32(entry, 40)
        require(u32(entry, 44) == 0, "SECTION")  # T1

    def name(self):
        return self.type.decode("ascii")


class Container:
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
        self.check_texels()

    def read_header(self):
        data = self.data
        require(len(data) >= 128, "TOO_SMALL")  # F1
        require(data[0:8] == MAGIC, "MAGIC")  # F2
        require((u16(data, 8), u16(data, 10), u32(data, 12)) == (1, 2, 128), "VERSION")  # F3
        require(u32(data, 124) == crc32c(data[0:124]), "HEADER_CRC")  # F4
        self.header = {name: read(data, offset) for name, offset, read in HEADER_FIELDS}
        h = self.header
        require(h["file_bytes"] == len(data), "SIZE")  # F5
        require(h["file_bytes"] <= 1 << 28, "LIMIT")  # F6
        require(1 <= h["section_count"] <= 32, "LIMIT")  # F7
        require(1 <= h["bone_count"] <= 1024, "LIMIT")  # F8
        require(1 <= h["row_count"] <= 65536, "LIMIT")  # F9
        require(1 <= h["clip_count"] <= 4096, "LIMIT")  # F10
        require(h["required_features"] == 0, "UNKNOWN_REQUIRED")  # F11

    def read_table(self):
        data = self.data
        end = 128 + 48 * self.header["section_count"]
        require(u32(data, 28) == 128 and end <= len(data), "SECTION")  # F12
        require(u32(data, 120) == crc32c(data[128:end]), "TABLE_CRC")  # F13
        self.sections = [Section(data[at:at + 48]) for at in range(128, end, 48)]
        seen = set()
        for section in self.sections:
            letters = all(0x41 <= c <= 0x5A or 0x61 <= c <= 0x7A for c in section.type)
            require(letters, "SECTION")  # T2
            name = section.name()
            require(name not in seen, "SECTION_DUP")  # T3
            seen.add(name)
            known = name in REQUIRED
            require(known or name[0].islower(), "UNKNOWN_REQUIRED")  # T4
            require(section.flags <= 2, "SECTION")  # T5
            require(section.flags == 0 or not known or name == "PIXL", "SECTION")  # T6
            if section.flags == 0:
                require(section.raw_bytes == section.stored_bytes, "SECTION")  # T7
                require(section.raw_crc == section.crc, "SECTION")  # T7
            require(3 <= section.align_log2 <= 12, "SECTION")  # T8
            if known:
                require(section.align_log2 == (12 if name == "PIXL" else 3), "SECTION")  # T8
        require(all(name in seen for name in REQUIRED), "SECTION_MISSING")  # T9

    def place_sections(self):
        data = self.data
        end = 128 + 48 * len(self.sections)
        for section in self.sections:
            align = 1 << section.align_log2
            start = -(-end // align) * align
            require(section.offset == start and start <= len(data), "SECTION")  # T10
            require(1 <= section.stored_bytes <= len(data) - start, "SECTION")  # T11
            require(is_zero(data[end:start]), "PADDING")  # T12
            end = start + section.stored_bytes
        require(end == len(data), "SECTION")  # T13
        self.bytes_of = {}
        for section in self.sections:
            stored = data[section.offset:section.offset + section.stored_bytes]
            require(crc32c(stored) == section.crc, "SECTION_CRC")  # T14
            self.bytes_of[section.name()] = stored

    # --- tables ---------------------------------------------------------------------------------------------------

    def check_header_values(self):
        h = self.header
        known = ((h["encoding"], (1, 2, 3), (4, 5, 255)), (h["texel_format"], (1, 2), (3, 4)),
                 (h["texel_order"], (0, 1), (2,)), (h["row_scheme"], (0,), (1, 2, 255)))
        require(all(number in now + later for number, now, later in known))  # H1 to H4
        require(h["space_flags"] <= 1)  # H6
        require(is_zero(self.data[58:60]))  # H7
        require(is_positive(h["radius_m"]))  # H8
        require(all(number in now for number, now, later in known), "UNSUPPORTED")
        require(h["texels_per_bone"] == {1: 4, 2: 3, 3: 2}[h["encoding"]])  # H5
        length = h["dualquat_length"]
        require(is_positive(length) if h["encoding"] == 3 else length == 0)  # H9

    def read_strings(self):
        data = self.bytes_of["STRS"]
        require(len(data) >= 8)  # S1
        count = u32(data, 0)
        require(count <= (len(data) - 8) // 4)  # S1
        offsets = u32s(data, 4, count + 1)
        text = data[8 + 4 * count:]
        require(offsets[0] == 0 and offsets[-1] == len(text))  # S2
        require(all(a <= b for a, b in zip(offsets, offsets[1:])))  # S2
        self.strings = [text[a:b] for a, b in zip(offsets, offsets[1:])]
        require(all(a < b for a, b in zip(self.strings, self.strings[1:])))  # S3
        for string in self.strings:
            require(len(string) <= 255)  # S4
            try:
                characters = string.decode("utf-8", "strict")
            except UnicodeDecodeError:
                raise Refused("SEMANTIC") from None  # S5
            require(not any(ord(c) < 0x20 or 0x7F <= ord(c) <= 0x9F for c in characters))  # S6

    def string(self, index):
        require(index < len(self.strings))
        return self.strings[index]

    def read_bones(self):
        data = self.bytes_of["BONE"]
        count = self.header["bone_count"]
        joints = 16 + 16 * count
        require(len(data) >= joints)  # B1
        require((u32(data, 0), u32(data, 4), u32(data, 12)) == (count, 16, 0))  # B1
        joint_count = u32(data, 8)
        end = joints + 2 * joint_count
        require(len(data) == -(-end // 4) * 4)  # B2
        self.joint_map = [u16(data, joints + 2 * i) for i in range(joint_count)]
        require(all(bone < count for bone in self.joint_map))  # B3
        self.bones = []
        for at in range(16, joints, 16):
            name, parent, flags, node = u32s(data, at, 4)
            require(is_index(parent, count))  # B5
            require(flags <= 1)  # B6
            self.bones.append((self.string(name), parent, flags, node))  # B4
        self.check_ancestors()
        require(is_zero(data[end:]), "PADDING")  # B7

    def check_ancestors(self):
        ends = set()  # bones whose chain of parents is known to end
        for bone in range(len(self.bones)):
            chain = []
            while bone != NONE and bone not in ends:
                require(bone not in chain)  # B5
                chain.append(bone)
                bone = self.bones[bone][1]
            ends.update(chain)

    def read_space(self):
        data = self.bytes_of["SPAC"]
        require(len(data) >= 64)  # M1
        self.model_from_palette = u32s(data, 0, 12)
        self.forward_axis, self.metres_per_unit, mesh_count, record_bytes = u32s(data, 48, 4)
        require(len(data) == 64 + 80 * mesh_count and record_bytes == 80)  # M1
        require(all(is_finite(bits) for bits in self.model_from_palette))  # M2
        if self.header["space_flags"] == 0:
            identity = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]
            require([value(bits) for bits in self.model_from_palette] == identity)  # M3
        require(self.forward_axis <= 3)  # M4
        require(is_positive(self.metres_per_unit))  # M5
        self.meshes = [self.read_mesh(data, at) for at in range(64, len(data), 80)]

    def read_mesh(self, data, at):
        name, node, mesh, skin, first_joint, joint_count, vertex_count, reserved = u32s(data, at, 8)
        matrix = u32s(data, at + 32, 12)
        require(first_joint + joint_count <= len(self.joint_map))  # M7
        require(reserved == 0)  # M8
        require(all(is_finite(bits) for bits in matrix))  # M9
        joints = self.joint_map[first_joint:first_joint + joint_count]
        return {"name": self.string(name), "node": node, "mesh": mesh, "skin": skin, "joints": joints,
                "vertex_count": vertex_count, "palette_from_mesh": matrix}  # M6

    def read_clips(self):
        data = self.bytes_of["CLIP"]
        count = self.header["clip_count"]
        cuts_at = 16 + 192 * count
        require(len(data) >= cuts_at)  # C1
        cut_count = u32(data, 8)
        require((u32(data, 0), u32(data, 4), u32(data, 12)) == (count, 192, 0))  # C1
        require(len(data) == cuts_at + 4 * cut_count)  # C1
        cuts = u32s(data, cuts_at, cut_count)
        self.clips = []
        next_row = next_cut = 0
        for at in range(16, cuts_at, 192):
            clip = self.read_clip(data[at:at + 192])
            require(clip["first_row"] == next_row and clip["row_count"] >= 1)  # C6
            texels = self.header["bone_count"] * self.header["texels_per_bone"]
            require(clip["first_texel"] == next_row * texels)  # C6
            next_row += clip["row_count"] + clip["closing_row"]
            first_cut, own_cuts = u32(data, at + 28), u32(data, at + 32)
            require(first_cut == next_cut)  # C7
            next_cut += own_cuts
            require(next_cut <= cut_count)  # C7
            clip["cuts"] = cuts[first_cut:next_cut]
            require(all(cut < clip["row_count"] for cut in clip["cuts"]))  # C7
            require(all(a < b for a, b in zip(clip["cuts"], clip["cuts"][1:])))  # C7
            self.clips.append(clip)
        require(next_row == self.header["row_count"] and next_cut == cut_count)  # C6, C7
        all_measured = all(clip["measured"] for clip in self.clips)
        require(self.header["optional_features"] & 1 == all_measured)  # C13

    def read_clip(self, r):
        h = self.header
        require((r[8], r[9], r[10]) == (h["encoding"], h["texels_per_bone"], h["row_scheme"]))  # C3
        require(r[11] <= 2 and r[12] <= 1 and r[14] <= 1 and r[15] <= 1)  # C4
        require(r[13] <= (r[8] == 3 and r[11] == 0))  # C5: dual quaternions of a loop
        require(is_zero(r[96:120]) and u32(r, 176) == NONE and is_zero(r[180:184]))  # C5
        require(is_zero(r[188:192]))  # C5
        clip = {"name": self.string(u32(r, 0)), "source_name": self.string(u32(r, 4)),  # C2
                "encoding": r[8], "texels_per_bone": r[9], "row_scheme": r[10], "wrap": r[11], "seam": r[12],
                "closing_row": r[13], "interpolation": r[14], "measured": r[15] & 1, "first_row": u32(r, 16),
                "row_count": u32(r, 20), "first_texel": u32(r, 24), "cut_count": u32(r, 32), "rate_hz": u32(r, 36),
                "period_s": u32(r, 40), "start_s": u32(r, 44), "speed_mps": u32(r, 48),
                "stride_phase": u32(r, 52), "box_min": u32s(r, 56, 3), "box_max": u32s(r, 68, 3),
                "sphere_center": u32s(r, 80, 3), "sphere_radius": u32(r, 92), "seam_gap": u32(r, 184),
                "error": u32s(r, 120, 7), "normal_error": u32s(r, 148, 7)}
        self.check_clip_floats(clip)
        self.check_clip_error(clip["error"], clip["measured"])
        self.check_clip_error(clip["normal_error"], clip["measured"])
        return clip

    @staticmethod
    def check_clip_floats(clip):
        one_row = clip["row_count"] == 1
        require(clip["rate_hz"] == 0 if one_row else is_positive(clip["rate_hz"]))  # C8
        require(is_non_negative(clip["period_s"]) if one_row else is_positive(clip["period_s"]))  # C8
        require(is_finite(clip["start_s"]) and is_finite(clip["stride_phase"]))  # C9
        require(is_non_negative(clip["speed_mps"]) and is_non_negative(clip["seam_gap"]))  # C9
        bounds = clip["box_min"] + clip["box_max"] + clip["sphere_center"]
        require(all(is_finite(bits) for bits in bounds) and is_non_negative(clip["sphere_radius"]))  # C10
        require(all(value(a) <= value(b) for a, b in zip(clip["box_min"], clip["box_max"])))  # C10

    def check_clip_error(self, error, measured):
        mesh, vertex, bone = error[4:]
        if not measured:
            require(error == [0, 0, 0, 0, NONE, NONE, NONE])  # C12
            return
        require(all(is_non_negative(bits) for bits in error[0:3]) and is_finite(error[3]))  # C11
        require(is_index(mesh, len(self.meshes)))  # C11
        require(is_index(vertex, 0 if mesh == NONE else self.meshes[mesh]["vertex_count"]))  # C11
        require(is_index(bone, self.header["bone_count"]))  # C11

    def read_states(self):
        data = self.bytes_of["STAT"]
        require(len(data) >= 8)  # A1
        count, self.default_state = u32s(data, 0, 2)
        require(len(data) == 8 + 8 * count)  # A1
        require(is_index(self.default_state, count))  # A2
        self.states = []
        previous = -1
        for at in range(8, len(data), 8):
            name, clip = u32s(data, at, 2)
            require(name > previous)  # A3
            require(clip < self.header["clip_count"])  # A4
            self.states.append((self.string(name), clip))  # A3
            previous = name

    # --- texels ---------------------------------------------------------------------------------------------------

    def check_texels(self):
        h = self.header
        pixl = next(section for section in self.sections if section.name() == "PIXL")
        per_line, rows = h["rows_per_line"], h["row_count"]
        self.texel_bytes = {1: 8, 2: 16}[h["texel_format"]]
        row_texels = h["bone_count"] * h["texels_per_bone"]
        self.row_bytes = row_texels * self.texel_bytes
        tight = per_line * self.row_bytes
        require(1 <= per_line <= rows)  # G1
        require(h["texture_width"] == per_line * row_texels)  # G2
        require(h["texture_height"] == -(-rows // per_line))  # G3
        require(h["row_pitch"] in (tight, -(-tight // 256) * 256))  # G4
        require(pixl.raw_bytes == h["row_pitch"] * h["texture_height"] <= 1 << 28)  # G5, G6
        require(pixl.flags == 0, "NEEDS_DECODE")  # X5
        self.pixels = self.bytes_of["PIXL"]
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
            sign, quarter, two = (0x8000, 0x3400, 0x4000) if self.texel_bytes == 8 else (0x80000000, 0x3E800000, 0x40000000)
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


# --- dump ---------------------------------------------------------------------------------------------------------

def hex_bits(bits):
    return f"{bits:08x}"


def hex_list(list_of_bits):
    return " ".join(map(hex_bits, list_of_bits))


def quoted(string):
    plain = (chr(c) if 0x20 <= c <= 0x7E and c not in (0x22, 0x5C) else f"\\x{c:02x}" for c in string)
    return '"' + "".join(plain) + '"'


def index_text(index):
    return "none" if index == NONE else str(index)


def error_text(error):
    return hex_list(error[0:4]) + " " + " ".join(index_text(index) for index in error[4:])


def dump_clip(number, clip):
    numbers = " ".join(f"{name} {clip[name]}" for name in (
        "encoding", "texels_per_bone", "row_scheme", "wrap", "seam", "closing_row", "interpolation", "measured",
        "first_row", "row_count", "first_texel", "cut_count"))
    floats = " ".join(f"{name} {hex_bits(clip[name])}" for name in (
        "rate_hz", "period_s", "start_s", "speed_mps", "stride_phase", "sphere_radius", "seam_gap"))
    yield f"clip {number} {quoted(clip['name'])} {quoted(clip['source_name'])}"
    yield f"  {numbers}"
    yield f"  {floats}"
    yield f"  box {hex_list(clip['box_min'])} {hex_list(clip['box_max'])} sphere {hex_list(clip['sphere_center'])}"
    yield f"  error {error_text(clip['error'])}"
    yield f"  normal {error_text(clip['normal_error'])}"
    yield "  cuts" + "".join(f" {cut}" for cut in clip["cuts"])


@functools.lru_cache(maxsize=None)
def widened_halves():
    """For every half the bits of the same number as an f32, by Python's own conversion; None for NaN and infinity."""
    halves = (struct.unpack("<e", struct.pack("<H", bits))[0] if bits & 0x7C00 != 0x7C00 else None
              for bits in range(65536))
    return [None if number is None else struct.pack(">f", number).hex() for number in halves]


def rounded(numbers):
    """Numbers rounded to single precision, each as a step of the arithmetic of section 10 leaves it."""
    return struct.unpack(f"<{len(numbers)}f", struct.pack(f"<{len(numbers)}f", *numbers))


def f32_sum(*terms):
    """The sums of lists, from left to right, rounded at each step."""
    total = terms[0]
    for term in terms[1:]:
        total = rounded([a + b for a, b in zip(total, term)])
    return total


def f32_product(a, b):
    return rounded([x * y for x, y in zip(a, b)])


def f32_difference(a, b):
    return rounded([x - y for x, y in zip(a, b)])


def f32_quotient(a, b):
    return rounded([x / y for x, y in zip(a, b)])


def f32_dot(a, b):
    return f32_sum(*(f32_product(x, y) for x, y in zip(a, b)))


def dualquat_matrices(real, dual, length):
    """Section 10 for all bones of a row at once: `real` and `dual` are four lists each, a number a bone."""
    one, two = [1.0] * len(real[0]), [2.0] * len(real[0])
    square = f32_dot(real, real)
    along = f32_quotient(f32_dot(real, dual), square)
    scale = f32_sum(one, f32_quotient(f32_product(two, along), [length] * len(one)))
    x, y, z, w = real
    dx, dy, dz, dw = (f32_difference(d, f32_product(along, r)) for r, d in zip(real, dual))
    h = f32_quotient(two, square)

    def diagonal(a, b):
        return f32_product(scale, f32_difference(one, f32_product(h, f32_sum(f32_product(a, a), f32_product(b, b)))))

    def beside(a, b, c, combine):
        return f32_product(scale, f32_product(h, combine(f32_product(a, b), f32_product(w, c))))

    def moved(d, a, cross_a, cross_b):
        turned = f32_difference(f32_product(w, d), f32_product(dw, a))
        return f32_product(h, f32_sum(turned, f32_difference(f32_product(*cross_a), f32_product(*cross_b))))

    return [diagonal(y, z), beside(x, y, z, f32_difference), beside(x, z, y, f32_sum), moved(dx, x, (y, dz), (z, dy)),
            beside(x, y, z, f32_sum), diagonal(x, z), beside(y, z, x, f32_difference), moved(dy, y, (z, dx), (x, dz)),
            beside(x, z, y, f32_difference), beside(y, z, x, f32_sum), diagonal(x, y), moved(dz, z, (x, dy), (y, dx))]


def dump_dualquat_rows(container):
    """Every bone-row as the twelve floats of its matrix."""
    letter = "e" if container.texel_bytes == 8 else "f"
    bones = range(container.header["bone_count"])
    length = value(container.header["dualquat_length"])
    places = [container.places(bone) for bone in bones]
    for row in range(container.header["row_count"]):
        block = container.place_bytes(row)
        numbers = struct.unpack(f"<{4 * len(block) // container.texel_bytes}{letter}", block)
        real, dual = ([[numbers[4 * places[bone][k] + c] for bone in bones] for c in range(4)] for k in range(2))
        for bone, matrix in enumerate(zip(*dualquat_matrices(real, dual, length))):
            yield f"row {row} bone {bone} {struct.pack('>12f', *matrix).hex(' ', 4)}"


def dump_rows(container):
    """Every bone-row as twelve floats."""
    if container.header["encoding"] == 3:
        yield from dump_dualquat_rows(container)
        return
    widened = widened_halves().__getitem__ if container.texel_bytes == 8 else hex_bits
    components = list(container.components())
    for row in range(container.header["row_count"]):
        texts = list(map(widened, container.row_bits(row)))
        for bone, places in enumerate(components):
            yield f"row {row} bone {bone} " + " ".join([texts[place] for place in places])


def dump(container):
    """Lines of the canonical dump."""
    for name, _, _ in HEADER_FIELDS:
        number = container.header[name]
        yield f"header {name} {hex_bits(number) if name in HEADER_FLOATS else number}"
    yield f"header recipe_sha256 {container.data[88:120].hex()}"
    for s in container.sections:
        yield (f"section {s.name()} flags {s.flags} offset {s.offset} stored {s.stored_bytes} raw {s.raw_bytes} "
               f"align_log2 {s.align_log2} crc {hex_bits(s.crc)} raw_crc {hex_bits(s.raw_crc)}")
    for number, clip in enumerate(container.clips):
        yield from dump_clip(number, clip)
    yield f"states {len(container.states)} default {index_text(container.default_state)}"
    for number, (name, clip) in enumerate(container.states):
        yield f"state {number} {quoted(name)} clip {clip}"
    for number, (name, parent, flags, node) in enumerate(container.bones):
        yield f"bone {number} {quoted(name)} parent {index_text(parent)} flags {flags} node {node}"
    yield f"space model_from_palette {hex_list(container.model_from_palette)}"
    yield f"space forward_axis {container.forward_axis} metres_per_unit {hex_bits(container.metres_per_unit)}"
    for number, mesh in enumerate(container.meshes):
        yield (f"mesh {number} {quoted(mesh['name'])} node {mesh['node']} mesh {mesh['mesh']} skin {mesh['skin']} "
               f"vertices {mesh['vertex_count']}")
        yield f"  palette_from_mesh {hex_list(mesh['palette_from_mesh'])}"
        yield "  joints" + "".join(f" {bone}" for bone in mesh["joints"])
    yield from dump_rows(container)


def dump_bytes(data):
    """Lines of the dump of a container in memory, or the one line that says why it is refused."""
    try:
        container = Container(data)
    except Refused as refusal:
        return [f"refused {refusal}"]
    return list(dump(container))


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: posepack_reader.py FILE.posepack")
    with open(sys.argv[1], "rb") as file:
        print("\n".join(dump_bytes(file.read())))


if __name__ == "__main__":
    main()
