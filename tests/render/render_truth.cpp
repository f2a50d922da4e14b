// SPDX-License-Identifier: MIT
// The vertices that a shader skins from a palette texture are those that the C loader's matrices give on the
// CPU.
//
// Every animal of the menagerie is baked in every form (encoding, texel format, texel order, row pitch),
// opened by the loader, and drawn into a transform feedback buffer at several times of every clip. Exit code
// 77: no EGL device.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "bake/bake_animal.hpp"
#include "base/files.hpp"
#include "menagerie/menagerie.hpp"
#include "recipe/catalog.hpp"
#include "render/error.hpp"
#include "render/headless.hpp"
#include "render/mesh_buffers.hpp"
#include "render/palette_texture.hpp"

namespace {

using namespace posepack;
using render::MeshVertex;
using render::require;

constexpr int kSkipped = 77;
// Blending and skinning in binary32 round a few times at the size of the animal: about ten times 2^-23.
constexpr double kPositionTolerance = 2e-6;  // fraction of R
constexpr double kNormalTolerance = 4e-6;
// The row position is a product of a rounded phase and the row count: 2^-23 of the clip each.
constexpr double kRowTolerance = 4e-7;  // fraction of the row count
constexpr std::array<double, 6> kCycles = {0.0, 0.1375, 0.5, 0.73125, 0.9990234375, 1.3125};

struct Captured {
    glm::vec3 position, normal, rows;
};

struct Tally {
    std::uint64_t vertices = 0, poses = 0, palettes = 0;
    double position = 0.0, normal = 0.0, row = 0.0;  // largest differences, in the units of the tolerances
};

// ---- The same law and the same skin, in double precision ----

double wrapped_phase(std::uint8_t wrap, double cycles) {
    if (wrap == POSEPACK_WRAP_LOOP) return cycles - std::floor(cycles);
    if (wrap == POSEPACK_WRAP_ONCE) return std::clamp(cycles, 0.0, 1.0);
    const double half = 0.5 * cycles;
    return 1.0 - std::abs(1.0 - 2.0 * (half - std::floor(half)));
}

// Distance in rows between the position that the shader chose and the one that the clip has at `cycles`.
double row_difference(const posepack_clip& clip, double cycles, const glm::vec3& rows) {
    const bool is_loop = clip.wrap == POSEPACK_WRAP_LOOP;
    const double count = clip.row_count;
    const double position = wrapped_phase(clip.wrap, cycles) * (is_loop ? count : count - 1.0);
    const bool is_held = clip.interpolation == POSEPACK_INTERPOLATION_STEP;
    const double expected = is_held ? std::floor(position) : position;
    const double row = static_cast<double>(rows.x) - clip.first_row;
    const double next = static_cast<double>(rows.y) - clip.first_row;
    const double first_again = clip.closing_row != 0 ? count : 0.0;
    const double behind_row = row + 1.0 < count ? row + 1.0 : (is_loop ? first_again : row);
    require(next == behind_row,
            fmt::format("expected row {} behind row {}, found {}", behind_row, row, next));
    const double difference = std::abs(row + static_cast<double>(rows.z) - expected);
    return is_loop ? std::min(difference, count - difference) : difference;
}

struct Skinned {
    std::array<double, 3> position{}, normal{};
};

Skinned skin(const MeshVertex& vertex, const std::vector<float>& pose, const float* model_from_palette) {
    std::array<double, 12> sum{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t e = 0; e < 12; ++e)
            sum[e] += static_cast<double>(vertex.weights[i]) *
                      static_cast<double>(pose[static_cast<std::size_t>(vertex.joints[i]) * 12 + e]);
    std::array<double, 12> m{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
            for (std::size_t k = 0; k < 3; ++k)
                m[r * 4 + c] += static_cast<double>(model_from_palette[r * 4 + k]) * sum[k * 4 + c];
            if (c == 3) m[r * 4 + c] += static_cast<double>(model_from_palette[r * 4 + 3]);
        }
    Skinned out;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.position[r] += m[r * 4 + c] * static_cast<double>(vertex.position[static_cast<int>(c)]);
            out.normal[r] += m[r * 4 + c] * static_cast<double>(vertex.normal[static_cast<int>(c)]);
        }
        out.position[r] += m[r * 4 + 3];
    }
    return out;
}

double distance(const std::array<double, 3>& a, const glm::vec3& b) {
    return std::hypot(a[0] - static_cast<double>(b.x), a[1] - static_cast<double>(b.y),
                      a[2] - static_cast<double>(b.z));
}

// ---- One palette on the GPU ----

class TruthTable {
 public:
    TruthTable(const render::PaletteTexture& palette, const render::SkinnedMesh& mesh,
               const render::Program& program)
        : palette_(palette),
          mesh_(mesh),
          program_(program),
          buffers_(render::upload_mesh(mesh)),
          capture_(render::make_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, nullptr,
                                       mesh.vertices.size() * sizeof(Captured), GL_STREAM_READ)) {
        program_.use();
        palette_.bind(program_);
    }

    void compare_all_clips(Tally& tally) const {
        for (std::uint32_t clip = 0; clip < palette_.view().header.clip_count; ++clip)
            for (const double cycles : kCycles) compare(clip, cycles, tally);
        ++tally.palettes;
    }

 private:
    std::vector<Captured> draw(std::uint32_t clip, double cycles) const {
        program_.set("clip", static_cast<int>(clip));
        program_.set("cycles", static_cast<float>(cycles));
        glBindVertexArray(buffers_.vertex_array.name());
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, capture_.name());
        glEnable(GL_RASTERIZER_DISCARD);
        glBeginTransformFeedback(GL_POINTS);
        glDrawArrays(GL_POINTS, 0, buffers_.vertex_count);
        glEndTransformFeedback();
        glDisable(GL_RASTERIZER_DISCARD);
        std::vector<Captured> captured(mesh_.vertices.size());
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0,
                           static_cast<GLsizeiptr>(captured.size() * sizeof(Captured)), captured.data());
        render::check_gl("the capture of skinned vertices");
        return captured;
    }

    // The loader's own blend of the rows that the shader chose.
    std::vector<float> pose_at(const glm::vec3& rows) const {
        std::vector<float> matrices(std::size_t{palette_.view().header.bone_count} * 12);
        require(
            posepack_blend_row(&palette_.view(), static_cast<std::uint32_t>(rows.x),
                               static_cast<std::uint32_t>(rows.y), rows.z, matrices.data()) == POSEPACK_OK,
            fmt::format("expected rows {} and {} in the palette", rows.x, rows.y));
        return matrices;
    }

    void compare(std::uint32_t clip, double cycles, Tally& tally) const {
        const std::vector<Captured> captured = draw(clip, cycles);
        const glm::vec3 rows = captured.front().rows;
        const posepack_clip facts = palette_.clip(clip);
        tally.row = std::max(tally.row, row_difference(facts, cycles, rows) / facts.row_count);
        const std::vector<float> pose = pose_at(rows);
        posepack_space space;
        posepack_get_space(&palette_.view(), &space);
        const double radius = static_cast<double>(palette_.view().header.radius_m);
        for (std::size_t v = 0; v < captured.size(); ++v) {
            require(captured[v].rows == rows, "expected the same rows for every vertex of an instance");
            const Skinned expected = skin(mesh_.vertices[v], pose, space.model_from_palette);
            // max() would pass over a NaN.
            const double position = distance(expected.position, captured[v].position) / radius;
            const double normal = distance(expected.normal, captured[v].normal);
            require(std::isfinite(position) && std::isfinite(normal),
                    "expected finite vertices from the shader");
            tally.position = std::max(tally.position, position);
            tally.normal = std::max(tally.normal, normal);
        }
        tally.vertices += captured.size();
        ++tally.poses;
    }

    const render::PaletteTexture& palette_;
    const render::SkinnedMesh& mesh_;
    const render::Program& program_;
    render::MeshBuffers buffers_;
    render::Buffer capture_;
};

// ---- Every animal in every form ----

template <class T>
T take(base::Result<T> result, std::string_view what) {
    require(static_cast<bool>(result), fmt::format("{}: {}", what, result ? "" : result.issue().detail));
    return std::move(result).value();
}

std::vector<recipe::OutputOverrides> all_forms() {
    std::vector<recipe::OutputOverrides> forms;
    for (const auto encoding : {recipe::Encoding::affine, recipe::Encoding::mat4, recipe::Encoding::dualquat})
        for (const auto format : {recipe::TexelFormat::rgba16f, recipe::TexelFormat::rgba32f})
            for (const auto order : {recipe::TexelOrder::bone_major, recipe::TexelOrder::planar}) {
                // Both pitches occur with every value of each of the other three.
                const bool is_tight =
                    (encoding == recipe::Encoding::mat4) != (order == recipe::TexelOrder::planar);
                recipe::OutputOverrides form;
                form.encoding = encoding;
                form.texel_format = format;
                form.texel_order = order;
                form.row_pitch = is_tight ? recipe::RowPitch::tight : recipe::RowPitch::align256;
                // mat4 in model space and the others normalised; in planar order the other way.
                form.space = (encoding == recipe::Encoding::mat4) == (order == recipe::TexelOrder::planar)
                                 ? recipe::Space::normalised
                                 : recipe::Space::model;
                forms.push_back(form);
            }
    return forms;
}

void compare_animal(const recipe::AnimalEntry& entry, const render::Program& program, Tally& tally) {
    const std::vector<std::uint8_t> glb = menagerie::generate_glb(entry.id);
    require(!glb.empty(), fmt::format("expected the menagerie to have a {}", entry.id));
    bake::AnimalOptions options;
    options.measure = false;
    const render::PaletteTexture palette(take(bake::bake_animal(entry, glb, options), entry.id).container);
    render::SkinnedMesh mesh = render::read_skinned_mesh(glb);
    palette.enter_palette(mesh);
    TruthTable(palette, mesh, program).compare_all_clips(tally);
}

Tally compare_catalog() {
    const base::Bytes text =
        take(base::read_file(POSEPACK_CATALOG, recipe::kMaxCatalogBytes), POSEPACK_CATALOG);
    const render::Program program({"palette.glsl", "truth.vert"}, {"nothing.frag"},
                                  {"skinned_position", "skinned_normal", "chosen_rows"});
    // Without a surface there is no framebuffer, and OpenGL draws nothing without one, captured or not.
    const render::Texture colour = render::make_texture(GL_RGBA8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    const render::Framebuffer framebuffer = render::make_framebuffer(colour.name(), 0);
    Tally tally;
    for (const recipe::OutputOverrides& form : all_forms()) {
        auto catalog =
            take(recipe::read_catalog({reinterpret_cast<const char*>(text.data()), text.size()}, form),
                 POSEPACK_CATALOG);
        for (recipe::AnimalEntry& entry : catalog.animals) {
            // The catalog loops and ends clips; the third way to wrap is tried on one clip of each animal.
            entry.clips.at(1).wrap = recipe::Wrap::ping_pong;
            entry.clips.at(1).seam = recipe::Seam::automatic;
            compare_animal(entry, program, tally);
        }
    }
    return tally;
}

int report(const Tally& tally) {
    fmt::print("compared {} vertices of {} poses in {} palettes\n", tally.vertices, tally.poses,
               tally.palettes);
    fmt::print("largest difference: position {:.2e} R, normal {:.2e}, row {:.2e} of a clip\n", tally.position,
               tally.normal, tally.row);
    const bool passed = tally.vertices > 0 && tally.position <= kPositionTolerance &&
                        tally.normal <= kNormalTolerance && tally.row <= kRowTolerance;
    if (!passed)
        fmt::print("expected some vertices, and at most {:.0e} R, {:.0e} and {:.0e}\n", kPositionTolerance,
                   kNormalTolerance, kRowTolerance);
    return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}

int without_device(const std::string& why_not) {
    fmt::print("no EGL device gives an OpenGL 3.3 context:{}\n", why_not);
    const char* ci = std::getenv("CI");
    return ci != nullptr && std::string_view(ci) == "true" ? EXIT_FAILURE : kSkipped;
}

}  // namespace

int main() {
    try {
        std::string why_not;
        const auto context = posepack::render::HeadlessContext::open(why_not);
        if (!context) return without_device(why_not);
        fmt::print("{}\n", context->description());
        return report(compare_catalog());
    } catch (const posepack::render::RenderError& error) {
        fmt::print("render_truth: {}\n", error.what());
        return EXIT_FAILURE;
    }
}
