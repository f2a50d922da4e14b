# SPDX-License-Identifier: MIT
"""Damaged containers through `verify`: the loader's result is named, with exit code 7.

"Sealed" rows carry right checksums, so that the rule itself is tried.
"""

import struct

import glb
from container import ENTRY_BYTES, HEADER_BYTES, Container, Section, crc32c, seal, seal_header
from harness import Row, read_bytes

CLIP_HEAD, BONE_HEAD, BONE_RECORD = 16, 16, 16
ROW_PITCH, TEXTURE_WIDTH, TEXTURE_HEIGHT, BONE_COUNT = 68, 60, 64, 40
FLIPS_OF_EACH_KIND = 64
_baked = {}


def _good(case):
    """The container of the tiny animal, baked once for all rows."""
    if "bytes" not in _baked:
        case.expect_ok(case.bake(case.write_animal(glb.tiny_animal().glb()), measure=True))
        _baked["bytes"] = read_bytes(case.path("out/deer.posepack"))
    return _baked["bytes"]


def _patched(data, kind, offset, value, sealed=seal):
    data = bytearray(data)
    struct.pack_into("<" + kind, data, offset, value)
    return sealed(data)


def _header(kind, offset, value, sealed=seal_header):
    return lambda data: _patched(data, kind, offset, value, sealed)


def _changed(change):
    """A change of the parsed container, laid out again by the rules."""
    def make(data):
        container = Container(data)
        change(container)
        return container.build()
    return make


def _entry(kind, field, fmt, value):
    """A field of a section's entry overwritten after the layout."""
    return lambda data: _patched(data, fmt, Container(data).entry_offset(kind) + field, value)


def _fill_byte(data):
    container = Container(data)
    offset = struct.unpack_from("<Q", data, container.entry_offset(b"PIXL") + 8)[0]
    data = bytearray(data)
    if data[offset - 1] != 0:
        raise ValueError("expected fill in front of PIXL")
    data[offset - 1] = 1
    return bytes(data)


def _gap(container):
    container.section(b"STAT").gap_bytes = 64


def _append(kind):
    return lambda container: container.sections.append(Section(kind, b"four"))


def _double_pixels(container):
    container.sections.append(Section(b"PIXL", container.section(b"PIXL").data, 12))


def _pitch_512(container):
    """Lines padded to 512 bytes, with all else right. The tiny animal's lines differ under 256."""
    tight = container.get("I", TEXTURE_WIDTH) * 8
    wide = (tight + 511) // 512 * 512
    if wide == (tight + 255) // 256 * 256:
        raise ValueError(f"expected lines that differ under 256 and 512, found {tight} bytes")
    pixels = container.section(b"PIXL")
    old = container.get("I", ROW_PITCH)
    lines = [pixels.data[start:start + tight] for start in range(0, len(pixels.data), old)]
    pixels.data = bytearray(b"".join(bytes(line).ljust(wide, b"\0") for line in lines))
    container.set("I", ROW_PITCH, wide)


def _wrapping_clip(container):
    struct.pack_into("<II", container.section(b"CLIP").data, CLIP_HEAD + 16, 4, 0xFFFFFFFE)


def _own_parent(container):
    struct.pack_into("<I", container.section(b"BONE").data, BONE_HEAD + BONE_RECORD * 1 + 4, 1)


def _not_a_number(container):
    struct.pack_into("<H", container.section(b"PIXL").data, 8 * 5, 0x7E00)


def _bomb(container):
    pixels = container.section(b"PIXL")
    pixels.data, pixels.flags, pixels.raw_bytes = bytearray(100), 2, 1 << 30


# name, title, the bytes from those of a good file, the loader's result
REFUSED = [
    ("P01", "no bytes", lambda data: b"", "TOO_SMALL"),
    ("P02", "the first 127 bytes", lambda data: data[:127], "TOO_SMALL"),
    ("P03", "LF made CRLF", lambda data: data.replace(b"\n", b"\r\n"), "MAGIC"),
    ("P04", "major 2, sealed", _header("H", 8, 2), "VERSION"),
    ("P06a", "file_bytes one less, sealed", lambda data: _patched(data, "Q", 16, len(data) - 1), "SIZE"),
    ("P06b", "file_bytes one more, sealed", lambda data: _patched(data, "Q", 16, len(data) + 1), "SIZE"),
    ("P07", "one zero byte more", lambda data: data + b"\0", "SIZE"),
    ("P09a", "no section, sealed", _header("I", 24, 0), "LIMIT"),
    ("P09b", "33 sections, sealed", _header("I", 24, 33), "LIMIT"),
    ("P09c", "0xFFFFFFFF sections, sealed", _header("I", 24, 0xFFFFFFFF), "LIMIT"),
    ("P13", "a fill byte in front of PIXL", _fill_byte, "PADDING"),
    ("P14", "CLIP at 2^64 - 64, sealed", _entry(b"CLIP", 8, "Q", 2**64 - 64), "SECTION"),
    ("P16", "64 zero bytes too many in front of STAT, sealed", _changed(_gap), "SECTION"),
    ("P17", "PIXL twice, sealed", _changed(_double_pixels), "SECTION_DUP"),
    ("P19", "unknown section ABCD, sealed", _changed(_append(b"ABCD")), "UNKNOWN_REQUIRED"),
    ("P22", "section type with a digit, sealed", _changed(_append(b"ab1d")), "SECTION"),
    ("P23a", "no bone, sealed", _header("I", BONE_COUNT, 0), "LIMIT"),
    ("P23b", "1,025 bones, sealed", _header("I", BONE_COUNT, 1025), "LIMIT"),
    ("P25", "row pitch a multiple of 512, sealed", _changed(_pitch_512), "SEMANTIC"),
    ("P26", "clip whose rows wrap, sealed", _changed(_wrapping_clip), "SEMANTIC"),
    ("P28", "bone that is its own parent, sealed", _changed(_own_parent), "SEMANTIC"),
    ("P31", "one NaN texel, sealed", _changed(_not_a_number), "SEMANTIC"),
    ("P33", "100 compressed bytes that claim 1 GiB, sealed", _changed(_bomb), "SEMANTIC"),
]


def _expect_result(case, data, result_name):
    path = case.write("broken.posepack", data)
    result = case.run("verify", path)
    case.equal(result.exit_code, 7, f"exit code (stderr {result.stderr})")
    case.check(result.stderr.startswith("posepack: error[E-PACK-INVALID]: broken.posepack: ") and
               result.stderr.count("\n") == 1,
               f"stderr: expected one E-PACK-INVALID line, found {result.stderr}")
    case.check(f" {result_name};" in result.stderr, f"stderr: expected {result_name}, found {result.stderr}")
    case.check(result.stdout.startswith("FAILED"), f"stdout: expected FAILED, found {result.stdout}")
    case.expect_bounded(result, "verify")


def _refused_row(name, title, make, result_name):
    return Row(name, title, lambda case: _expect_result(case, make(_good(case)), result_name))


def _flips(first, count, result_name, case):
    """One bit in bytes spread evenly over a range, another bit each time."""
    data = _good(case)
    step = max(1, count // FLIPS_OF_EACH_KIND)
    for number, offset in enumerate(range(first, first + count, step)):
        flipped = bytearray(data)
        flipped[offset] ^= 1 << number % 8
        faults = len(case.faults)
        _expect_result(case, bytes(flipped), result_name)
        if len(case.faults) > faults:
            case.faults.append(f"the last faults are those of byte {offset}, bit {number % 8}")
            return


def _header_flips(case):
    _flips(16, HEADER_BYTES - 16, "HEADER_CRC", case)


def _table_flips(case):
    _flips(HEADER_BYTES, ENTRY_BYTES * len(Container(_good(case)).sections), "TABLE_CRC", case)


def _section_flips(case):
    data = _good(case)
    container = Container(data)
    for section in container.sections:
        offset = struct.unpack_from("<Q", data, container.entry_offset(section.kind) + 8)[0]
        _flips(offset + len(section.data) // 2, 1, "SECTION_CRC", case)


def _optional_section(case):
    case.write("good.posepack", _changed(_append(b"abCd"))(_good(case)))
    result = case.run("verify", "good.posepack")
    case.expect_ok(result)
    shown = case.inspect("good.posepack")
    case.equal(shown["sections"][-1]["type"], "abCd", "last section")
    case.equal([clip["name"] for clip in shown["clips"]], ["Walk", "Idle"], "clips")


def _same_layout(case):
    """What is laid out here is byte for byte what the program wrote: else the sealed rows prove nothing."""
    data = _good(case)
    case.check(Container(data).build() == data, "a container parsed and laid out again differs")
    case.equal(crc32c(b"123456789"), 0xE3069283, "CRC-32C of 123456789")


def _unread_containers(case):
    """What cannot be opened is refused alike by inspect and export, and nothing is exported."""
    case.write("broken.posepack", _good(case)[:-1])
    for arguments in (("inspect", "broken.posepack"), ("export", "--exr", "broken.posepack")):
        result = case.run(*arguments)
        case.expect_refused(result, 7, "E-PACK-INVALID", ("SIZE", "broken.posepack"))
        missing = case.run(*arguments[:-1], "nothing.posepack")
        case.expect_refused(missing, 2, "E-IO-OPEN", ("nothing.posepack",))


ROWS = [Row("P00", "a good container comes back from parts", _same_layout)] + [
    _refused_row(*row) for row in REFUSED] + [
    Row("P10", "header bits flipped", _header_flips),
    Row("P11", "table bits flipped", _table_flips),
    Row("P12", "section bits flipped", _section_flips),
    Row("P20", "MUST PASS: unknown section abCd at the end", _optional_section),
    Row("P34", "inspect and export of containers that do not open", _unread_containers),
]
