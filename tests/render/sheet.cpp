// SPDX-License-Identifier: MIT
#include "render/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "render/error.hpp"

namespace posepack::render {
namespace {

struct Shot {
    const char* state;
    float phase;
};

constexpr std::array<Shot, 3> kShots = {{{"wander", 0.12f}, {"flee", 0.30f}, {"attack", 0.42f}}};

// From the animal's left, a little ahead and above.
const glm::vec3 kToEye = glm::normalize(glm::vec3(1.0f, 0.42f, 0.62f));

struct Box {
    glm::vec2 low{1e9f}, high{-1e9f};

    glm::vec2 middle() const { return 0.5f * (low + high); }
    float half() const { return 0.5f * std::max(high.x - low.x, high.y - low.y); }
};

std::uint32_t clip_of(const SheetAnimal& animal, const char* state) {
    std::uint32_t clip = 0;
    require(posepack_find_state(&animal.palette.view(), state, &clip) == POSEPACK_OK,
            fmt::format("expected a state {} of {}", state, animal.id));
    return clip;
}

glm::vec3 transformed(const float* rows, const glm::vec3& place) {
    glm::vec3 out;
    for (int r = 0; r < 3; ++r)
        out[r] = glm::dot(glm::vec4(rows[4 * r], rows[4 * r + 1], rows[4 * r + 2], rows[4 * r + 3]),
                          glm::vec4(place, 1.0f));
    return out;
}

// What the skin of a row covers, in model space, seen from the eye.
Box seen(const SheetAnimal& animal, std::uint32_t clip, float phase, const glm::mat4& view) {
    const posepack_clip facts = animal.palette.clip(clip);
    const std::uint32_t row =
        facts.first_row + static_cast<std::uint32_t>(phase * static_cast<float>(facts.row_count));
    std::vector<float> matrices(std::size_t{animal.palette.view().header.bone_count} * 12);
    require(posepack_decode_row(&animal.palette.view(), row, matrices.data()) == POSEPACK_OK,
            fmt::format("expected row {} of {}", row, animal.id));
    const float* model_from_palette = animal.palette.space().model_from_palette;
    Box box;
    for (const MeshVertex& vertex : animal.mesh.vertices) {
        glm::vec3 skinned(0.0f);
        for (std::size_t slot = 0; slot < 4; ++slot)
            skinned +=
                vertex.weights[slot] *
                transformed(&matrices[static_cast<std::size_t>(vertex.joints[slot]) * 12], vertex.position);
        const glm::vec3 place = transformed(model_from_palette, skinned);
        const float bind_height = transformed(model_from_palette, vertex.position).y;
        const glm::vec2 point(view * glm::vec4(place, 1.0f));
        const glm::vec2 below(view * glm::vec4(place.x, 0.0f, place.z, 1.0f));  // its shadow, nearly
        box.low = glm::min(
            box.low, place.y < 0.3f * bind_height ? point : glm::min(point, glm::mix(point, below, 0.15f)));
        box.high = glm::max(box.high, point);
    }
    return box;
}

class Painter {
 public:
    explicit Painter(const SheetOptions& options) : options_(options), empty_(make_vertex_array()) {}

    Sheet paint(const std::vector<SheetAnimal>& animals) {
        const int count = static_cast<int>(animals.size());
        const int rows = (count + options_.columns - 1) / options_.columns;
        const int side = options_.cell_px * options_.samples_a_side;
        Sheet sheet{options_.columns * 3 * options_.cell_px, rows * options_.cell_px, {}};
        const int width = sheet.width * options_.samples_a_side;
        const int height = sheet.height * options_.samples_a_side;
        const Texture colour = make_texture(GL_RGBA16F, width, height, GL_RGBA, GL_FLOAT);
        const Texture depth =
            make_texture(GL_DEPTH_COMPONENT32F, width, height, GL_DEPTH_COMPONENT, GL_FLOAT);
        const Framebuffer framebuffer = make_framebuffer(colour.name(), depth.name());
        glEnable(GL_DEPTH_TEST);
        glClearColor(0.62f, 0.60f, 0.54f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (int index = 0; index < count; ++index) {
            const int column = index % options_.columns;
            const int row = rows - 1 - index / options_.columns;
            draw_animal(animals[static_cast<std::size_t>(index)], column * 3 * side, row * side, side,
                        (column + index / options_.columns) % 2 == 0);
        }
        glDisable(GL_DEPTH_TEST);
        sheet.rgb = resolve(colour.name(), sheet.width, sheet.height);
        check_gl("drawing the sheet");
        return sheet;
    }

 private:
    void draw_animal(const SheetAnimal& animal, int left, int bottom, int side, bool is_light) const {
        const glm::mat4 view = glm::lookAt(kToEye, glm::vec3(0.0f), glm::vec3(0, 1, 0));
        std::array<Box, kShots.size()> boxes;
        float half = 0.0f;
        for (std::size_t shot = 0; shot < kShots.size(); ++shot) {
            boxes[shot] = seen(animal, clip_of(animal, kShots[shot].state), kShots[shot].phase, view);
            half = std::max(half, boxes[shot].half());
        }
        const MeshBuffers buffers = upload_mesh(animal.mesh);
        program_.use();
        animal.palette.bind(program_);
        for (std::size_t shot = 0; shot < kShots.size(); ++shot) {
            const glm::vec2 middle = boxes[shot].middle();
            const float reach = half * 1.12f;
            const glm::mat4 projection =
                glm::ortho(middle.x - reach, middle.x + reach, middle.y - reach, middle.y + reach,
                           1.0f - 40.0f * half, 1.0f + 40.0f * half);
            glViewport(left + static_cast<int>(shot) * side, bottom, side, side);
            program_.set("clip_from_model", projection * view);
            program_.set("clip", static_cast<int>(clip_of(animal, kShots[shot].state)));
            program_.set("cycles", kShots[shot].phase);
            program_.set("half_m", half);
            program_.set("shade", is_light ? 1.0f : 0.90f);
            glBindVertexArray(empty_.name());
            draw_part(kFloor, 6);
            glBindVertexArray(buffers.vertex_array.name());
            for (const int part : {kShadow, kAnimal}) {
                program_.set("part", part);
                glDrawElements(GL_TRIANGLES, buffers.index_count, GL_UNSIGNED_INT, nullptr);
            }
        }
    }

    void draw_part(int part, int vertex_count) const {
        program_.set("part", part);
        glDrawArrays(GL_TRIANGLES, 0, vertex_count);
    }

    std::vector<std::uint8_t> resolve(GLuint samples, int width, int height) const {
        const Texture colour = make_texture(GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE);
        const Framebuffer framebuffer = make_framebuffer(colour.name(), 0);
        glViewport(0, 0, width, height);
        resolve_program_.use();
        resolve_program_.set_texture("samples", 0, samples);
        resolve_program_.set("samples_a_side", options_.samples_a_side);
        resolve_program_.set("picture_size", glm::vec2(width, height));
        glBindVertexArray(empty_.name());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<std::uint8_t> rgb(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
        return rgb;
    }

    static constexpr int kFloor = 0;
    static constexpr int kShadow = 1;
    static constexpr int kAnimal = 2;

    SheetOptions options_;
    VertexArray empty_;
    Program program_{{"palette.glsl", "sheet.vert"}, {"sheet.frag"}};
    Program resolve_program_{{"screen.vert"}, {"resolve.frag"}};
};

}  // namespace

SheetAnimal read_sheet_animal(std::string id, const std::vector<std::uint8_t>& glb,
                              std::vector<std::uint8_t> container) {
    SheetAnimal out{std::move(id), PaletteTexture(std::move(container)), read_skinned_mesh(glb)};
    out.palette.enter_palette(out.mesh);
    return out;
}

Sheet draw_sheet(const std::vector<SheetAnimal>& animals, const SheetOptions& options) {
    return Painter(options).paint(animals);
}

}  // namespace posepack::render
