// SPDX-License-Identifier: MIT
// What rounding alone costs: the error of stored rows against the exact matrices of their times, for every
// form. Medians over the animals of a catalog, and the worst of them.
//
//     posepack_quantisation CATALOG MODELS [RATE_HZ]
//
// Between rows other errors rule (posepack report). docs/encodings/ quotes the table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "animal/read_animal.hpp"
#include "bake/bake_animal.hpp"
#include "base/files.hpp"
#include "motion/clip_sampler.hpp"
#include "motion/row_plan.hpp"
#include "motion/skin_set.hpp"
#include "posepack/loader.h"
#include "recipe/catalog.hpp"

namespace {

using namespace posepack;
using motion::Affine;

struct Figures {
    double max = 0.0, p999 = 0.0, rms = 0.0;
};

Affine affine_of(const float* m) {
    Affine out;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) out.linear[c][r] = static_cast<double>(m[r * 4 + c]);
        out.translation[r] = static_cast<double>(m[r * 4 + 3]);
    }
    return out;
}

// palette_from_mesh of the mesh that each bone belongs to.
std::vector<Affine> bone_entries(const posepack_view& view, std::uint32_t mesh_count) {
    std::vector<Affine> entries(view.header.bone_count);
    for (std::uint32_t m = 0; m < mesh_count; ++m) {
        posepack_mesh mesh;
        posepack_get_mesh(&view, m, &mesh);
        for (std::uint32_t joint = 0, bone = 0; joint < mesh.joint_count; ++joint)
            if (posepack_map_joint(&view, m, joint, &bone) == POSEPACK_OK)
                entries[bone] = affine_of(mesh.palette_from_mesh);
    }
    return entries;
}

// Distances of all points at all rows, fractions of R.
Figures row_errors(const animal::Animal& animal, const motion::SkinSet& points, const posepack_view& view) {
    posepack_space space;
    posepack_get_space(&view, &space);
    const Affine leave = affine_of(space.model_from_palette);
    const std::vector<Affine> entries = bone_entries(view, space.mesh_count);
    const double radius =
        static_cast<double>(view.header.radius_m) / static_cast<double>(space.metres_per_unit);
    std::vector<Affine> bones(entries.size());
    std::vector<float> stored(entries.size() * 12);
    std::vector<glm::dvec3> moved(points.size());
    std::vector<double> distances;
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        posepack_clip clip;
        posepack_get_clip(&view, c, &clip);
        const std::string name(clip.source_name.data, clip.source_name.size_bytes);
        const auto source = std::find_if(animal.clips.begin(), animal.clips.end(),
                                         [&](const animal::Clip& s) { return s.source_name == name; });
        motion::ClipSampler sampler(animal, *source);
        for (std::uint32_t row = 0; row < clip.row_count; ++row) {
            // The exact period is the source's; the stored one is a float.
            const double intervals = clip.wrap == POSEPACK_WRAP_LOOP ? clip.row_count : clip.row_count - 1.0;
            const bool is_open = clip.seam == POSEPACK_SEAM_OPEN && clip.wrap == POSEPACK_WRAP_LOOP;
            const double period_s = is_open ? static_cast<double>(clip.period_s) : source->duration_s;
            const double time_s = clip.row_count == 1 ? 0.0 : period_s * row / intervals;
            if (time_s > source->duration_s) break;
            sampler.sample(time_s, bones);
            posepack_decode_row(&view, clip.first_row + row, stored.data());
            for (std::size_t b = 0; b < bones.size(); ++b) {
                const Affine found = leave * affine_of(&stored[b * 12]) * entries[b];
                bones[b] = {found.linear - bones[b].linear, found.translation - bones[b].translation};
            }
            motion::skin(points, bones, moved);
            for (const glm::dvec3& d : moved) distances.push_back(std::sqrt(glm::dot(d, d)) / radius);
        }
    }
    Figures figures;
    for (const double d : distances) {
        figures.max = std::max(figures.max, d);
        figures.rms += d * d;
    }
    figures.rms = std::sqrt(figures.rms / static_cast<double>(distances.size()));
    const auto rank =
        distances.begin() + static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), rank, distances.end());
    figures.p999 = *rank;
    return figures;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

struct Form {
    recipe::Encoding encoding;
    recipe::TexelFormat format;
    recipe::Space space;
};

template <class T>
T take(base::Result<T> result) {
    if (!result) {
        fmt::print(stderr, "{}\n", base::format_issue(result.issue()));
        std::exit(EXIT_FAILURE);
    }
    return std::move(result).value();
}

void print_form(const Form& form, const std::string& text, const std::string& models, double rate_hz) {
    recipe::OutputOverrides overrides;
    overrides.encoding = form.encoding;
    overrides.texel_format = form.format;
    overrides.space = form.space;
    overrides.caps = recipe::Caps::desktop;
    const recipe::Catalog catalog = take(recipe::read_catalog(text, overrides, rate_hz));
    std::vector<double> max, p999, rms;
    std::string worst, refused;
    for (const recipe::AnimalEntry& entry : catalog.animals) {
        const base::Bytes glb = take(base::read_file(models + "/" + entry.model, 1u << 28));
        bake::AnimalOptions options;
        options.measure = false;
        const auto baked = bake::bake_animal(entry, glb, options);
        if (!baked) {
            refused += " " + entry.id;
            continue;
        }
        const animal::Animal animal = take(animal::read_animal(glb));
        posepack_view view;
        posepack_open(&view, baked.value().container.data(), baked.value().container.size());
        const Figures figures = row_errors(animal, motion::unique_points(animal), view);
        if (max.empty() || figures.max > *std::max_element(max.begin(), max.end())) worst = entry.id;
        max.push_back(figures.max);
        p999.push_back(figures.p999);
        rms.push_back(figures.rms);
    }
    if (max.empty()) return;
    fmt::print("{:9} {:8} {:11} {:3} animals: max {:.1e}  p99.9 {:.1e}  rms {:.1e}  worst {:.1e} ({}){}\n",
               name_of(form.encoding), name_of(form.format), name_of(form.space), max.size(), median(max),
               median(p999), median(rms), *std::max_element(max.begin(), max.end()), worst,
               refused.empty() ? "" : "  refused:" + refused);
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count < 3) {
        fmt::print(stderr, "usage: posepack_quantisation CATALOG MODELS [RATE_HZ]\n");
        return EXIT_FAILURE;
    }
    const base::Bytes bytes = take(base::read_file(arguments[1], recipe::kMaxCatalogBytes));
    const std::string text(bytes.begin(), bytes.end());
    const double rate_hz = argument_count > 3 ? std::strtod(arguments[3], nullptr) : 30.0;
    using recipe::Encoding;
    using recipe::Space;
    using recipe::TexelFormat;
    for (const Encoding encoding : {Encoding::mat4, Encoding::affine, Encoding::dualquat})
        for (const TexelFormat format : {TexelFormat::rgba16f, TexelFormat::rgba32f})
            for (const Space space : {Space::model, Space::normalised})
                print_form({encoding, format, space}, text, arguments[2], rate_hz);
    return EXIT_SUCCESS;
}
