# SPDX-License-Identifier: MIT
"""Clips and states (sections 8 and 9; rules C and A)."""
from posepack_reader.tables import TEXELS
from posepack_reader.values import (NONE, is_finite, is_index, is_non_negative, is_positive, is_zero, require, u32, u32s,
                                    value)


class Clips:
    """Reads clips and states. Needs what Framing and Tables have read."""

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
            if clip["row_scheme"] == 0:
                texels = self.header["bone_count"] * self.header["texels_per_bone"]
                require(clip["first_texel"] == next_row * texels)  # C6
            next_row += clip["row_count"] + clip["closing_row"]
            first_cut, own_cuts = u32(data, at + 28), u32(data, at + 32)
            require(first_cut == next_cut)  # C7
            next_cut += own_cuts
            require(next_cut <= cut_count)  # C7
            clip["cuts"] = cuts[first_cut:next_cut]
            require(clip["row_scheme"] == 0 or not clip["cuts"])  # C7
            require(all(cut < clip["row_count"] for cut in clip["cuts"]))  # C7
            require(all(a < b for a, b in zip(clip["cuts"], clip["cuts"][1:])))  # C7
            self.clips.append(clip)
        require(next_row == self.header["row_count"] and next_cut == cut_count)  # C6, C7
        differ = any(clip["encoding"] != self.clips[0]["encoding"] for clip in self.clips)
        require(differ == (self.header["encoding"] == 255))  # C3
        all_measured = all(clip["measured"] for clip in self.clips)
        require(self.header["optional_features"] & 1 == all_measured)  # C13

    def read_clip(self, r):
        h = self.header
        require(r[10] == h["row_scheme"] or (r[10], h["row_scheme"]) == (1, 2))  # C3
        require(r[8] in TEXELS and h["encoding"] in (r[8], 255) and r[9] == TEXELS[r[8]])  # C3
        require(r[11] <= 2 and r[12] <= 1 and r[14] <= 1 and r[15] <= 1)  # C4
        require(r[13] <= (r[10] == 0 and r[8] == 3 and r[11] == 0))  # C5: dual quaternions of a uniform loop
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
