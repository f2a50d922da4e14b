# SPDX-License-Identifier: MIT
"""Everything a container says, as lines that the C loader's dump tool prints too: floats as the eight hexadecimal digits
of their bits, names in quotes, one bone-row a line."""
import functools
import struct

from posepack_reader.dualquat import dualquat_matrices
from posepack_reader.framing import HEADER_FIELDS, HEADER_FLOATS
from posepack_reader.sample import Sampler
from posepack_reader.values import NO_BONE, NONE, value

# Bits of the phases at which poses are printed: NaN, 0.001, 0.1, a third, a half, 0.72, the last below 1, 1 and 2.
PHASES = (0x7FC00000, 0x3A83126F, 0x3DCCCCCD, 0x3EAAAAAB, 0x3F000000, 0x3F3851EC, 0x3F7FFFFF, 0x3F800000, 0x40000000)


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


def dump_clip(number, clip, slots):
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
    yield "  slots" + "".join(" %d:%d/%d" % slot for slot in slots)


@functools.lru_cache(maxsize=None)
def widened_halves():
    """For every half the bits of the same number as an f32, by Python's own conversion; None for NaN and infinity."""
    halves = (struct.unpack("<e", struct.pack("<H", bits))[0] if bits & 0x7C00 != 0x7C00 else None
              for bits in range(65536))
    return [None if number is None else struct.pack(">f", number).hex() for number in halves]


def dump_dualquat_rows(container):
    """Every bone-row as the twelve floats of its matrix."""
    letter = "e" if container.texel_bytes == 8 else "f"
    bones = range(container.header["bone_count"])
    length = value(container.header["dualquat_length"])
    places = [container.places(bone) for bone in bones]
    for row in range(container.header["row_count"]):
        block = container.place_bytes(row)
        numbers = struct.unpack(f"<{4 * len(block) // container.texel_bytes}{letter}", block)
        stored = [[numbers[4 * places[bone][k] + c] for bone in bones] for k in range(2) for c in range(4)]
        for bone, matrix in enumerate(zip(*dualquat_matrices(stored, length))):
            yield f"row {row} bone {bone} {struct.pack('>12f', *matrix).hex(' ', 4)}"


def dump_rows(container):
    """Every bone of every row as twelve floats; runs have no such rows."""
    if container.header["row_scheme"] == 2:
        return
    if container.header["encoding"] == 3:
        yield from dump_dualquat_rows(container)
        return
    widened = widened_halves().__getitem__ if container.texel_bytes == 8 else hex_bits
    components = list(container.components())
    for row in range(container.header["row_count"]):
        texts = list(map(widened, container.row_bits(row)))
        for bone, places in enumerate(components):
            yield f"row {row} bone {bone} " + " ".join([texts[place] for place in places])


def dump_samples(container):
    """Where the rows of every bone of every clip are, and its pose at some phases."""
    for number in range(len(container.clips)):
        sampler = Sampler(container, number)
        for bone in sampler.bones:
            yield (f"run {number} bone {bone} texel %d texel_step %d k_step %d intervals %d wraps %d" %
                   sampler.run(bone))
        for phase in PHASES:
            for bone, matrix in enumerate(sampler.pose(value(phase))):
                text = struct.pack(">12f", *matrix).hex(" ", 4)
                yield f"sample {number} phase {hex_bits(phase)} bone {bone} {text}"


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
        yield from dump_clip(number, clip, container.slots[number] if container.runs else [])
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
        yield "  joints" + "".join(" none" if bone == NO_BONE else f" {bone}" for bone in mesh["joints"])
    yield from dump_rows(container)
    yield from dump_samples(container)
