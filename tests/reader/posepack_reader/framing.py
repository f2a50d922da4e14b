# SPDX-License-Identifier: MIT
"""Header, section table and the places of sections (sections 3 and 4 of the specification; rules F and T)."""
from posepack_reader.values import crc32c, is_zero, require, u8, u16, u32, u64

MAGIC = bytes([0x8B, 0x50, 0x50, 0x4B, 0x0D, 0x0A, 0x1A, 0x0A])
REQUIRED = ("CLIP", "STAT", "BONE", "SPAC", "STRS", "PIXL")
KNOWN = REQUIRED + ("RUNS", "SLOT")

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


class Framing:
    """Reads `self.data` into `header`, `sections` and the bytes of each section, by its name."""

    def read_header(self):
        data = self.data
        require(len(data) >= 128, "TOO_SMALL")  # F1
        require(data[0:8] == MAGIC, "MAGIC")  # F2
        require((u16(data, 8), u16(data, 10), u32(data, 12)) == (1, 4, 128), "VERSION")  # F3
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
            known = name in KNOWN
            require(known or name[0].islower(), "UNKNOWN_REQUIRED")  # T4
            require(section.flags <= 2, "SECTION")  # T5
            require(section.flags == 0 or not known or name == "PIXL", "SECTION")  # T6
            if section.flags == 0:
                require(section.raw_bytes == section.stored_bytes, "SECTION")  # T7
                require(section.raw_crc == section.crc, "SECTION")  # T7
            require(3 <= section.align_log2 <= 12, "SECTION")  # T8
            if known:
                require(section.align_log2 == (12 if name == "PIXL" else 3), "SECTION")  # T8
        needed = REQUIRED + (("RUNS",) if self.header["row_scheme"] == 2 else ())
        require(all(name in seen for name in needed), "SECTION_MISSING")  # T9

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
