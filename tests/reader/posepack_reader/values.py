# SPDX-License-Identifier: MIT
"""Numbers of a container, its checksum (section 2 of the specification), and what a broken rule raises."""
import struct

NONE = 0xFFFFFFFF
NO_BONE = 0xFFFF  # of a joint that moves no vertex


class Refused(Exception):
    """A rule is broken; the argument is the result that the specification names."""


def require(holds, result="SEMANTIC"):
    if not holds:
        raise Refused(result)


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


def _make_crc_table():
    table = []
    for byte in range(256):
        crc = byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
        table.append(crc)
    return table


_CRC_TABLE = _make_crc_table()


def crc32c(data):
    crc = 0xFFFFFFFF
    table = _CRC_TABLE
    for byte in data:
        crc = crc >> 8 ^ table[(crc ^ byte) & 0xFF]
    return crc ^ 0xFFFFFFFF
