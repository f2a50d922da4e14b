# SPDX-License-Identifier: MIT
"""Header values, strings, bones, spaces and meshes (sections 3 and 5 to 7; rules H, S, B and M)."""
from posepack_reader.values import (NO_BONE, NONE, Refused, is_finite, is_index, is_positive, is_zero, require, u16, u32, u32s,
                                    value)

TEXELS = {1: 4, 2: 3, 3: 2}  # of a bone, by encoding


class Tables:
    """Reads the tables that nothing in time depends on. Needs what Framing has read."""

    def check_header_values(self):
        h = self.header
        encodings = (1, 2, 3, 255) if h["row_scheme"] == 2 else (1, 2, 3)
        known = ((h["encoding"], encodings, (4, 5, 255)), (h["texel_format"], (1, 2), (3, 4)),
                 (h["texel_order"], (0, 1), (2,)), (h["row_scheme"], (0, 2), (1, 255)))
        require(all(number in now + later for number, now, later in known))  # H1 to H4
        require(h["space_flags"] <= 1)  # H6
        require(is_zero(self.data[58:60]))  # H7
        require(is_positive(h["radius_m"]))  # H8
        require(all(number in now for number, now, later in known), "UNSUPPORTED")
        require(h["texels_per_bone"] == (TEXELS | {255: 255})[h["encoding"]])  # H5
        require(("RUNS" in self.bytes_of) == (h["row_scheme"] == 2))  # H10
        require("RUNS" in self.bytes_of or "SLOT" not in self.bytes_of)  # H10
        length = h["dualquat_length"]
        require(is_positive(length) if h["encoding"] in (3, 255) else length == 0)  # H9

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
        require(all(bone < count or bone == NO_BONE for bone in self.joint_map))  # B3
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
