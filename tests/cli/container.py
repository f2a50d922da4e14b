# SPDX-License-Identifier: MIT
"""Takes a container apart and puts it together again with right checksums, so that a test can break one
rule of docs/format/posepack-1.md and no other."""

import struct

HEADER_BYTES, ENTRY_BYTES = 128, 48
TABLE_CRC, HEADER_CRC = 120, 124


def _crc32c_table():
    table = []
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (0x82F63B78 if byte & 1 else 0)
        table.append(byte)
    return table


_TABLE = _crc32c_table()


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = _TABLE[(crc ^ byte) & 0xFF] ^ crc >> 8
    return crc ^ 0xFFFFFFFF


def seal(data):
    """The bytes with the checksums of table and header made right; the section count must fit the file."""
    data = bytearray(data)
    count = struct.unpack_from("<I", data, 24)[0]
    struct.pack_into("<I", data, TABLE_CRC, crc32c(data[HEADER_BYTES:HEADER_BYTES + count * ENTRY_BYTES]))
    return seal_header(data)


def seal_header(data):
    data = bytearray(data)
    struct.pack_into("<I", data, HEADER_CRC, crc32c(data[:HEADER_CRC]))
    return bytes(data)


class Section:
    """One section: what its entry says, and its bytes. A `raw_bytes` of None means: as many as are stored."""

    def __init__(self, kind, data, align_log2=3, flags=0, raw_bytes=None):
        self.kind = kind
        self.data = bytearray(data)
        self.align_log2 = align_log2
        self.flags = flags
        self.raw_bytes = raw_bytes
        self.gap_bytes = 0  # in front of it, beyond what alignment needs


class Container:
    def __init__(self, data):
        """Parses a container that is known to be good."""
        self.header = bytearray(data[:HEADER_BYTES])
        self.sections = []
        for index in range(self.get("I", 24)):
            kind, flags, offset, stored, _, align_log2 = struct.unpack_from("<4sIQQQI", data, HEADER_BYTES +
                                                                            index * ENTRY_BYTES)
            self.sections.append(Section(kind, data[offset:offset + stored], align_log2, flags))

    def get(self, kind, offset):
        return struct.unpack_from("<" + kind, self.header, offset)[0]

    def set(self, kind, offset, value):
        struct.pack_into("<" + kind, self.header, offset, value)

    def section(self, kind):
        return next(section for section in self.sections if section.kind == kind)

    def entry_offset(self, kind):
        """Where the entry of a section begins in the file."""
        return HEADER_BYTES + ENTRY_BYTES * self.sections.index(self.section(kind))

    def build(self):
        """Lays all out by the rules, with sizes, places and checksums that agree."""
        self.set("I", 24, len(self.sections))
        end = HEADER_BYTES + ENTRY_BYTES * len(self.sections)
        table, body = b"", b""
        for section in self.sections:
            align = 1 << section.align_log2
            start = (end + align - 1) // align * align + section.gap_bytes
            crc = crc32c(section.data)
            raw_bytes = len(section.data) if section.raw_bytes is None else section.raw_bytes
            table += struct.pack("<4sIQQQIIII", section.kind, section.flags, start, len(section.data),
                                 raw_bytes,
                                 section.align_log2, crc, crc, 0)
            body += bytes(start - end) + section.data
            end = start + len(section.data)
        self.set("Q", 16, end)
        return seal(bytes(self.header) + table + body)
