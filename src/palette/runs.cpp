// SPDX-License-Identifier: MIT
#include "palette/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "format/bytes.h"
#include "format/dualquat.h"
#include "format/half.h"
#include "format/texels.h"
#include "posepack/format.h"

namespace posepack::palette {
namespace {

std::size_t numbers_per_row(std::uint8_t encoding) {
    return encoding == POSEPACK_ENCODING_DUALQUAT ? 8 : 12;
}

posepack_dualquat dualquat_at(const float* numbers) {
    posepack_dualquat out{};
    std::copy_n(numbers, 4, out.real);
    std::copy_n(numbers + 4, 4, out.dual);
    return out;
}

}  // namespace

RunEncoder::RunEncoder(std::uint8_t encoding, std::uint8_t texel_format, const RoundingAids& aids,
                       std::size_t bone_count, double enough)
    : encoding_(encoding), texel_format_(texel_format), aids_(aids), enough_(enough), runs_(bone_count) {}

bool RunEncoder::store(std::size_t bone, std::span<const float> numbers, std::size_t row_count) {
    const bool half = texel_format_ == POSEPACK_TEXEL_RGBA16F;
    const float largest = half ? 65504.0f : 3.4e38f;
    for (const float number : numbers)
        if (!(std::abs(number) <= largest)) return false;
    runs_[bone] = {static_cast<std::uint32_t>(numbers_.size() / numbers_per_row(encoding_)),
                   static_cast<std::uint32_t>(row_count - 1)};
    numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
    return true;
}

bool RunEncoder::add_affine(std::size_t bone, std::span<const motion::Affine> rows, bool closes) {
    std::vector<float> numbers(rows.size() * 12);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::span<float, 12> out(&numbers[r * 12], 12);
        if (closes && r + 1 == rows.size() && r > 0)
            std::copy_n(numbers.begin(), 12, out.begin());
        else if (texel_format_ == POSEPACK_TEXEL_RGBA16F)
            round_affine(rows[r], aids_.moments[bone], aids_.halves, out);
        else
            for (int i = 0; i < 3; ++i)
                for (int c = 0; c < 4; ++c)
                    out[static_cast<std::size_t>(4 * i + c)] =
                        static_cast<float>(c < 3 ? rows[r].linear[c][i] : rows[r].translation[i]);
    }
    return store(bone, numbers, rows.size());
}

bool RunEncoder::add_dualquat(std::size_t bone, std::span<const Similarity> rows, bool closes, bool turned) {
    const auto length = static_cast<double>(aids_.dualquat_length);
    std::vector<float> numbers(rows.size() * 8);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::span<float, 8> out(&numbers[r * 8], 8);
        if (closes && r + 1 == rows.size() && r > 0) {
            for (std::size_t i = 0; i < 8; ++i) out[i] = turned ? -numbers[i] : numbers[i];
        } else if (texel_format_ == POSEPACK_TEXEL_RGBA16F) {
            const motion::Affine exact{rows[r].scale * rotation_matrix(rows[r].rotation),
                                       rows[r].translation};
            round_dualquat(exact, rows[r], aids_.moments[bone], length, aids_.halves, out, enough_);
        } else {
            std::array<double, 8> exact{};
            dualquat_numbers(rows[r], length, exact);
            for (std::size_t i = 0; i < 8; ++i) out[i] = static_cast<float>(exact[i]);
        }
    }
    return store(bone, numbers, rows.size());
}

void RunEncoder::share(std::size_t bone, std::size_t other) {
    runs_[bone] = runs_[other];
}

void RunEncoder::write_matrix(std::size_t bone, std::uint32_t interval, float factor, float* matrix) const {
    const Run& run = runs_[bone];
    const std::size_t width = numbers_per_row(encoding_);
    const float* a =
        &numbers_[(run.first_row + std::min(interval, std::max(run.interval_count, 1u) - 1)) * width];
    const float* b = run.interval_count == 0 ? a : a + width;
    if (encoding_ == POSEPACK_ENCODING_DUALQUAT) {
        const posepack_dualquat first = dualquat_at(a);
        const posepack_dualquat second = dualquat_at(b);
        posepack_dualquat_blend(&first, &second, factor, aids_.dualquat_length, matrix);
    } else {
        for (std::size_t i = 0; i < 12; ++i) matrix[i] = a[i] * (1.0f - factor) + b[i] * factor;
    }
}

// Interval j of every bone at once: bones with fewer stay in their last. Which bone is where at what time
// does not matter to the bounds.
void RunEncoder::grow_bounds(const BoneBoxes& boxes, Box& box) const {
    std::uint32_t longest = 1;
    for (const Run& run : runs_) longest = std::max(longest, run.interval_count);
    std::array<std::vector<float>, 5> quarters;
    for (auto& matrices : quarters) matrices.resize(runs_.size() * 12);
    for (std::uint32_t interval = 0; interval < longest; ++interval) {
        for (std::size_t i = 0; i < quarters.size(); ++i)
            for (std::size_t bone = 0; bone < runs_.size(); ++bone)
                write_matrix(bone, interval, 0.25f * static_cast<float>(i), &quarters[i][bone * 12]);
        boxes.add_arcs(quarters, box);
    }
}

// Entries in the order of the bones need new runs in the same order: rows are put into it here.
ClipRuns RunEncoder::finish() {
    ClipRuns out;
    out.encoding = encoding_;
    const bool half = texel_format_ == POSEPACK_TEXEL_RGBA16F;
    const std::size_t width = numbers_per_row(encoding_);
    constexpr std::uint32_t kUnplaced = 0xFFFFFFFFu;
    std::vector<std::uint32_t> placed(numbers_.size() / width + 1, kUnplaced);  // by first row
    std::uint32_t rows = 0;
    for (const Run& run : runs_) {
        std::uint32_t& offset = placed[run.first_row];
        if (offset == kUnplaced) {
            offset = rows;
            rows += run.interval_count + 1;
            const float* numbers = &numbers_[run.first_row * width];
            for (std::size_t i = 0; i < (run.interval_count + std::size_t{1}) * width; ++i) {
                const std::size_t at = out.texels.size();
                out.texels.resize(at + (half ? 2 : 4));
                if (half)
                    posepack_write_u16(&out.texels[at], posepack_half_from_float(numbers[i]));
                else
                    posepack_write_f32(&out.texels[at], numbers[i]);
            }
        }
        out.entries.push_back(offset | run.interval_count << POSEPACK_RUN_OFFSET_BITS);
        out.longest = std::max(out.longest, run.interval_count);
    }
    return out;
}

base::Result<Layout> runs_layout(std::uint8_t encoding, std::uint8_t texel_format, std::uint32_t bone_count,
                                 std::uint32_t row_count, std::uint64_t texel_count,
                                 std::uint32_t last_texels) {
    Layout layout;
    layout.encoding = encoding;
    layout.texel_format = texel_format;
    layout.texel_order = POSEPACK_ORDER_BONE_MAJOR;
    layout.texels_per_bone = encoding == POSEPACK_MIXED
                                 ? std::uint8_t{POSEPACK_MIXED}
                                 : static_cast<std::uint8_t>(posepack_encoding_texels(encoding));
    layout.texel_bytes = posepack_texel_bytes(texel_format);
    layout.bone_count = bone_count;
    layout.row_count = row_count;
    const std::uint64_t all = texel_count + last_texels;
    std::uint64_t width = POSEPACK_RUNS_MIN_WIDTH;
    while ((all + width - 1) / width > POSEPACK_RUNS_MAX_HEIGHT) width *= 2;
    constexpr std::uint64_t kTableBytes = 32u << 20;  // 4,096 clips of 1,024 bones have 16 MiB of runs
    if (all * layout.texel_bytes > POSEPACK_MAX_FILE_BYTES - kTableBytes)
        return base::Issue{base::IssueCode::lim_container, "",
                           fmt::format("expected at most {} bytes of texels, found {}",
                                       POSEPACK_MAX_FILE_BYTES - kTableBytes, all * layout.texel_bytes)};
    layout.texture_width = static_cast<std::uint32_t>(width);
    layout.texture_height = static_cast<std::uint32_t>((all + width - 1) / width);
    layout.row_pitch_bytes = layout.texture_width * layout.texel_bytes;
    layout.run_texels = texel_count;
    return layout;
}

}  // namespace posepack::palette
