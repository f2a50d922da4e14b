// SPDX-License-Identifier: MIT
#include "render/herd_renderer.hpp"

#include <cstddef>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "render/error.hpp"
#include "render/prop_meshes.hpp"
#include "render/terrain.hpp"

namespace posepack::render {
namespace {

constexpr int kShadowMapSide = 8192;
constexpr int kShadowUnit = 2;  // units 0 and 1 belong to the palette
constexpr glm::vec3 kEye(0.0f, 2.1f, 0.0f);
constexpr glm::vec3 kTarget(0.0f, 1.42f, -10.0f);
constexpr float kFieldOfViewDegrees = 36.0f;  // vertical

struct Matrices {
    glm::mat4 clip_from_world, shadow_from_world;
    glm::vec3 to_sun;
};

Matrices make_matrices(const PictureOptions& options) {
    Matrices out{};
    const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
    out.clip_from_world = glm::perspective(glm::radians(kFieldOfViewDegrees), aspect, 0.5f, 1500.0f) *
                          glm::lookAt(kEye, kTarget, glm::vec3(0, 1, 0));
    out.to_sun = glm::normalize(glm::vec3(-0.80f, 0.50f, 0.16f));
    // The map covers the part of the meadow where shadows can be told apart.
    const glm::vec3 middle(0.0f, 1.0f, -36.0f);
    out.shadow_from_world = glm::ortho(-37.0f, 37.0f, -26.0f, 26.0f, 10.0f, 230.0f) *
                            glm::lookAt(middle + 110.0f * out.to_sun, middle, glm::vec3(0, 1, 0));
    return out;
}

struct StaticMesh {
    VertexArray vertex_array;
    Buffer vertices, indices;
    int index_count = 0;
};

StaticMesh upload_ground() {
    const GroundMesh ground = make_ground();
    StaticMesh out;
    out.vertex_array = make_vertex_array();
    out.vertices =
        make_buffer(GL_ARRAY_BUFFER, ground.vertices.data(), ground.vertices.size() * sizeof(GroundVertex));
    use_float_attribute(0, 3, sizeof(GroundVertex), offsetof(GroundVertex, position));
    use_float_attribute(1, 3, sizeof(GroundVertex), offsetof(GroundVertex, normal));
    use_float_attribute(2, 1, sizeof(GroundVertex), offsetof(GroundVertex, trodden));
    out.indices = make_buffer(GL_ELEMENT_ARRAY_BUFFER, ground.indices.data(),
                              ground.indices.size() * sizeof ground.indices[0]);
    out.index_count = static_cast<int>(ground.indices.size());
    return out;
}

struct PropCrowd {
    MeshBuffers mesh;
    Buffer props;
    int prop_count = 0;
};

PropCrowd upload_props(const SkinnedMesh& mesh, const std::vector<Prop>& props) {
    PropCrowd out;
    out.mesh = upload_mesh(mesh);
    out.props = make_buffer(GL_ARRAY_BUFFER, props.data(), props.size() * sizeof(Prop));
    use_float_attribute(5, 4, sizeof(Prop), offsetof(Prop, position), 1);
    use_float_attribute(6, 1, sizeof(Prop), offsetof(Prop, scale), 1);
    use_float_attribute(7, 3, sizeof(Prop), offsetof(Prop, tint), 1);
    out.prop_count = static_cast<int>(props.size());
    return out;
}

class Painter {
 public:
    Painter(const HerdScene& scene, const std::vector<AnimalCrowd>& crowds, const PictureOptions& options)
        : crowds_(crowds),
          options_(options),
          matrices_(make_matrices(options)),
          ground_(upload_ground()),
          empty_(make_vertex_array()) {
        props_.push_back(upload_props(make_tuft(), scene.tufts));
        props_.push_back(upload_props(make_flower(), scene.flowers));
        props_.push_back(upload_props(make_tree(), scene.trees));
    }

    Picture paint() {
        draw_shadow_map();
        const int width = options_.width * options_.samples_a_side;
        const int height = options_.height * options_.samples_a_side;
        const Texture colour = make_texture(GL_RGBA16F, width, height, GL_RGBA, GL_FLOAT);
        const Texture depth =
            make_texture(GL_DEPTH_COMPONENT32F, width, height, GL_DEPTH_COMPONENT, GL_FLOAT);
        const Framebuffer framebuffer = make_framebuffer(colour.name(), depth.name());
        glViewport(0, 0, width, height);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glClear(GL_DEPTH_BUFFER_BIT);
        Picture picture;
        picture.draw_calls = draw_animals(animal_program_, matrices_.clip_from_world);
        draw_props(prop_program_, matrices_.clip_from_world);
        draw_ground();
        draw_sky();
        glDisable(GL_DEPTH_TEST);
        picture.rgb = resolve(colour.name());
        check_gl("drawing the herd");
        return picture;
    }

 private:
    void draw_shadow_map() {
        const Framebuffer framebuffer = make_framebuffer(0, shadow_map_.name());
        glViewport(0, 0, kShadowMapSide, kShadowMapSide);
        glEnable(GL_DEPTH_TEST);
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_animals(animal_shadow_program_, matrices_.shadow_from_world);
        draw_props(prop_shadow_program_, matrices_.shadow_from_world);
    }

    // The light is that of every program; those that only write depth have none of its uniforms.
    void use(const Program& program, const glm::mat4& clip_from_world) const {
        program.use();
        program.set("clip_from_world", clip_from_world);
        program.set("eye", kEye);
        program.set("to_sun", matrices_.to_sun);
        program.set("shadow_from_world", matrices_.shadow_from_world);
        program.set("shadow_texel", glm::vec2(1.0f / kShadowMapSide));
        if (&program != &animal_shadow_program_ && &program != &prop_shadow_program_)
            program.set_texture("shadow_map", kShadowUnit, shadow_map_.name());
    }

    int draw_animals(const Program& program, const glm::mat4& clip_from_world) const {
        use(program, clip_from_world);
        program.set("time_s", options_.time_s);
        int calls = 0;
        for (const AnimalCrowd& crowd : crowds_) {
            crowd.palette->bind(program);
            program.set("radius_m", crowd.palette->view().header.radius_m);
            glBindVertexArray(crowd.mesh.vertex_array.name());
            glDrawElementsInstanced(GL_TRIANGLES, crowd.mesh.index_count, GL_UNSIGNED_INT, nullptr,
                                    crowd.instance_count);
            ++calls;
        }
        return calls;
    }

    void draw_props(const Program& program, const glm::mat4& clip_from_world) const {
        use(program, clip_from_world);
        for (const PropCrowd& crowd : props_) {
            glBindVertexArray(crowd.mesh.vertex_array.name());
            glDrawElementsInstanced(GL_TRIANGLES, crowd.mesh.index_count, GL_UNSIGNED_INT, nullptr,
                                    crowd.prop_count);
        }
    }

    void draw_ground() const {
        use(ground_program_, matrices_.clip_from_world);
        glBindVertexArray(ground_.vertex_array.name());
        glDrawElements(GL_TRIANGLES, ground_.index_count, GL_UNSIGNED_INT, nullptr);
    }

    void draw_sky() const {
        use(sky_program_, matrices_.clip_from_world);
        sky_program_.set("world_from_clip", glm::inverse(matrices_.clip_from_world));
        glBindVertexArray(empty_.name());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    std::vector<std::uint8_t> resolve(GLuint samples) const {
        const Texture colour =
            make_texture(GL_RGBA8, options_.width, options_.height, GL_RGBA, GL_UNSIGNED_BYTE);
        const Framebuffer framebuffer = make_framebuffer(colour.name(), 0);
        glViewport(0, 0, options_.width, options_.height);
        resolve_program_.use();
        resolve_program_.set_texture("samples", 0, samples);
        resolve_program_.set("samples_a_side", options_.samples_a_side);
        resolve_program_.set("picture_size", glm::vec2(options_.width, options_.height));
        glBindVertexArray(empty_.name());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<std::uint8_t> rgb(static_cast<std::size_t>(options_.width) *
                                      static_cast<std::size_t>(options_.height) * 3);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, options_.width, options_.height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
        return rgb;
    }

    const std::vector<AnimalCrowd>& crowds_;
    PictureOptions options_;
    Matrices matrices_;
    StaticMesh ground_;
    VertexArray empty_;
    std::vector<PropCrowd> props_;
    Texture shadow_map_ =
        make_texture(GL_DEPTH_COMPONENT32F, kShadowMapSide, kShadowMapSide, GL_DEPTH_COMPONENT, GL_FLOAT);
    Program animal_program_{{"palette.glsl", "animal.vert"}, {"light.glsl", "surface.frag"}};
    Program animal_shadow_program_{{"palette.glsl", "animal.vert"}, {"nothing.frag"}};
    Program prop_program_{{"prop.vert"}, {"light.glsl", "surface.frag"}};
    Program prop_shadow_program_{{"prop.vert"}, {"nothing.frag"}};
    Program ground_program_{{"ground.vert"}, {"light.glsl", "ground.frag"}};
    Program sky_program_{{"screen.vert"}, {"light.glsl", "sky.frag"}};
    Program resolve_program_{{"screen.vert"}, {"resolve.frag"}};
};

}  // namespace

AnimalCrowd upload_crowd(const Crowd& crowd, const std::vector<std::uint8_t>& glb,
                         std::vector<std::uint8_t> container) {
    AnimalCrowd out;
    out.palette = std::make_unique<PaletteTexture>(std::move(container));
    SkinnedMesh mesh = read_skinned_mesh(glb);
    out.palette->enter_palette(mesh);
    std::vector<Instance> instances;
    for (const Actor& actor : crowd.actors) {
        instances.push_back(actor.instance);
        instances.back().clip = static_cast<float>(out.palette->find_clip(actor.clip));
    }
    out.mesh = upload_mesh(mesh);
    out.instances = make_buffer(GL_ARRAY_BUFFER, instances.data(), instances.size() * sizeof(Instance));
    use_float_attribute(5, 4, sizeof(Instance), offsetof(Instance, position), 1);
    use_float_attribute(6, 4, sizeof(Instance), offsetof(Instance, scale), 1);
    use_float_attribute(7, 3, sizeof(Instance), offsetof(Instance, tint), 1);
    out.instance_count = static_cast<int>(instances.size());
    return out;
}

Picture draw_herd(const HerdScene& scene, const std::vector<AnimalCrowd>& crowds,
                  const PictureOptions& options) {
    return Painter(scene, crowds, options).paint();
}

}  // namespace posepack::render
