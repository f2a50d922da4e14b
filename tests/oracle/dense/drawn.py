# SPDX-License-Identifier: MIT
"""Bones of a container at any times of a clip (docs/format/posepack-1.md, sections 10 and 11), in single precision.

The tables come from tests/reader/posepack_reader. Each numpy operation on float32 rounds once, as section 10 asks.
"""
import numpy as np

from posepack_reader.values import value

ONE, TWO = np.float32(1), np.float32(2)
SMALLEST_SQUARE = np.float32(1e-12)


def dot(a, b):
    """From left to right."""
    total = a[..., 0] * b[..., 0]
    for i in range(1, a.shape[-1]):
        total = total + a[..., i] * b[..., i]
    return total


def without_scale(stored, length):
    """Real part, d' and s: nine numbers in the last dimension."""
    real, dual = stored[..., 0:4], stored[..., 4:8]
    along = dot(real, dual) / dot(real, real)
    scale = ONE + (TWO * along) / length
    return np.concatenate([real, dual - along[..., None] * real, scale[..., None]], axis=-1)


def dualquat_matrices(parts):
    x, y, z, w, dx, dy, dz, dw, s = np.moveaxis(parts, -1, 0)
    h = TWO / np.maximum(dot(parts[..., 0:4], parts[..., 0:4]), SMALLEST_SQUARE)
    rows = [s * (ONE - h * (y * y + z * z)), s * (h * (x * y - w * z)), s * (h * (x * z + w * y)),
            h * ((w * dx - dw * x) + (y * dz - z * dy)),
            s * (h * (x * y + w * z)), s * (ONE - h * (x * x + z * z)), s * (h * (y * z - w * x)),
            h * ((w * dy - dw * y) + (z * dx - x * dz)),
            s * (h * (x * z - w * y)), s * (h * (y * z + w * x)), s * (ONE - h * (x * x + y * y)),
            h * ((w * dz - dw * z) + (x * dy - y * dx))]
    return np.stack(rows, axis=-1).reshape(parts.shape[:-1] + (3, 4))


def part(share, count):
    """The whole part of share x count, below count, and the rest. `count` is a number or one for each share."""
    position = share * np.asarray(count).astype(np.float32)
    whole = np.clip(position.astype(np.int64), 0, np.maximum(count, 1) - 1)
    return whole, position - whole.astype(np.float32)


class DrawnClip:
    """One clip of a checked container."""

    def __init__(self, container, number):
        self.clip = container.clips[number]
        self.period_s = value(self.clip["period_s"])
        self.length = np.float32(value(container.header["dualquat_length"]))
        self.bone_count = container.header["bone_count"]
        slots = container.slots[number] if container.runs else []
        self.slots = np.array(slots, np.int64).reshape(-1, 3)
        self.rows = self.run_rows(container, number) if container.runs else self.uniform_rows(container)

    @staticmethod
    def numbers(container):
        return np.frombuffer(container.pixels, "<f2" if container.texel_bytes == 8 else "<f4").astype(np.float32)

    def uniform_rows(self, container):
        """For all bones (rows, numbers), among them the row that comes behind the last interval."""
        h, clip = container.header, self.clip
        texels, bones = h["texels_per_bone"], self.bone_count
        lines = self.numbers(container).reshape(h["texture_height"], -1)[:, :4 * h["texture_width"]]
        rows = lines.reshape(h["texture_height"] * h["rows_per_line"], -1)
        if h["texel_order"] == 1:
            rows = rows.reshape(-1, texels, bones, 4).transpose(0, 2, 1, 3)
        own = rows.reshape(-1, bones, 4 * texels)[clip["first_row"]:][:clip["row_count"] + clip["closing_row"]]
        if clip["wrap"] == 0 and clip["row_count"] > 1 and not clip["closing_row"]:
            own = np.concatenate([own, own[:1]])
        return [own[:, bone] for bone in range(bones)]

    def run_rows(self, container, number):
        texels = self.numbers(container).reshape(-1, 4)
        size = self.clip["texels_per_bone"]
        rows = []
        for offset, intervals in container.runs[number]:
            first = self.clip["first_texel"] + offset * size
            rows.append(texels[first:first + (intervals + 1) * size].reshape(intervals + 1, 4 * size))
        return rows

    def place(self, phase, intervals):
        """For every phase the row, and the factor of the next."""
        if intervals == 0:
            return np.zeros(len(phase), np.int64), np.zeros(len(phase), np.float32)
        if len(self.slots):
            slot, along = part(phase, len(self.slots))
            row, offset, span = self.slots[slot].T
            within = (offset.astype(np.float32) + along) / np.maximum(span, 1).astype(np.float32)
            further, rest = part(along, offset)
            return np.where(span > 0, row, row + further), np.where(span > 0, within, rest)
        return part(phase, intervals)

    def poses(self, times_s):
        """Shape (bones, times, 3, 4). The end of a loop is the end of its last interval."""
        share = np.asarray(times_s) / self.period_s if self.period_s > 0.0 else np.zeros(len(times_s))
        phase = np.clip(share, 0.0, 1.0).astype(np.float32)
        places = {}
        out = np.empty((self.bone_count, len(phase), 3, 4), np.float32)
        for bone, rows in enumerate(self.rows):
            intervals = len(rows) - 1
            if intervals not in places:
                places[intervals] = self.place(phase, intervals)
            out[bone] = self.blend(rows, *places[intervals])
        return out

    def blend(self, rows, row, factor):
        following = np.minimum(row + 1, len(rows) - 1)
        held = np.isin(row, self.clip["cuts"]) | (self.clip["interpolation"] == 1)
        row = np.where(held & (factor == ONE), following, row)
        factor = np.where(held, np.float32(0), factor)[:, None]
        if self.clip["encoding"] == 3:
            rows = without_scale(rows, self.length)
        mixed = np.where(factor == 0.0, rows[row], rows[row] * (ONE - factor) + rows[following] * factor)
        if self.clip["encoding"] == 3:
            return dualquat_matrices(mixed)
        if self.clip["encoding"] == 1:
            return mixed.reshape(-1, 4, 4).transpose(0, 2, 1)[:, :3]
        return mixed.reshape(-1, 3, 4)
