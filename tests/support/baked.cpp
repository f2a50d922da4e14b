// SPDX-License-Identifier: MIT
#include "support/baked.hpp"

#include <stdexcept>

#include "palette/container_writer.hpp"
#include "palette/encode.hpp"
#include "palette/spaces.hpp"

namespace posepack::support {
namespace {

void plan_all(const animal::Animal& animal, const std::vector<motion::RowWish>& wishes,
              palette::Palette& palette) {
    const motion::SkinSet points = motion::unique_points(animal);
    std::vector<glm::dvec3> posed(points.size());
    motion::skin(points, motion::rest_pose(animal), posed);
    palette.radius = motion::sphere_around(posed).radius;
    std::uint32_t rows = 0;
    for (std::uint32_t c = 0; c < animal.clips.size(); ++c) {
        motion::ClipSampler sampler(animal, animal.clips[c]);
        palette::PaletteClip clip;
        clip.source = c;
        clip.plan = motion::plan_rows(animal, animal.clips[c], sampler, points, palette.radius,
                                      c < wishes.size() ? wishes[c] : motion::RowWish{});
        clip.first_row = rows;
        rows += clip.plan.row_count;
        palette.clips.push_back(std::move(clip));
    }
    palette.layout.row_count = rows;
}

}  // namespace

Baked bake_all(const animal::Animal& animal, const recipe::OutputOptions& output,
               const std::vector<motion::RowWish>& wishes) {
    Baked baked;
    palette::Palette& palette = baked.palette;
    plan_all(animal, wishes, palette);
    auto layout = palette::choose_layout(output, static_cast<std::uint32_t>(animal.bones.size()),
                                         palette.layout.row_count);
    if (!layout) throw std::runtime_error(base::format_issue(layout.issue()));
    palette.layout = layout.value();
    palette.spaces = palette::model_space(animal);
    palette::RowEncoder encoder(palette.layout);
    const palette::BoneBoxes boxes(animal);
    std::vector<motion::Affine> bones(animal.bones.size());
    std::vector<float> stored(animal.bones.size() * 12);
    for (palette::PaletteClip& clip : palette.clips) {
        motion::ClipSampler sampler(animal, animal.clips[clip.source]);
        for (std::uint32_t row = 0; row < clip.plan.row_count; ++row) {
            motion::sample_row(sampler, clip.plan, row, bones);
            if (encoder.encode(clip.first_row + row, bones, stored) < bones.size())
                throw std::runtime_error("a matrix does not fit");
            boxes.add(stored, clip.bounds);
        }
    }
    palette.pixels = encoder.finish();
    baked.container = palette::write_container(animal, palette, "{}");
    return baked;
}

recipe::OutputOptions in_floats() {
    recipe::OutputOptions options;
    options.texel_format = recipe::TexelFormat::rgba32f;
    return options;
}

}  // namespace posepack::support
