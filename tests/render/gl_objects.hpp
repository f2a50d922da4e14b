// SPDX-License-Identifier: MIT
// OpenGL objects that free themselves, and programs made of the files in shaders/.
#pragma once

#include <epoxy/gl.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace posepack::render {

// Owns one GL name. Deleter is a function that deletes it.
template <void (*Delete)(GLuint)>
class Owned {
 public:
    Owned() = default;
    explicit Owned(GLuint name) : name_(name) {}
    Owned(Owned&& other) noexcept : name_(other.name_) { other.name_ = 0; }
    Owned& operator=(Owned&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Owned() {
        if (name_ != 0) Delete(name_);
    }
    GLuint name() const { return name_; }

 private:
    GLuint name_ = 0;
};

void delete_buffer(GLuint name);
void delete_texture(GLuint name);
void delete_vertex_array(GLuint name);
void delete_framebuffer(GLuint name);
void delete_program(GLuint name);

using Buffer = Owned<delete_buffer>;
using Texture = Owned<delete_texture>;
using VertexArray = Owned<delete_vertex_array>;
using Framebuffer = Owned<delete_framebuffer>;

Buffer make_buffer(GLenum target, const void* data, std::size_t size_bytes, GLenum usage = GL_STATIC_DRAW);
VertexArray make_vertex_array();

// A texture of one level; clamped, nearest. `data` may be null.
Texture make_texture(GLint internal_format, int width, int height, GLenum format, GLenum type,
                     const void* data = nullptr);

// A framebuffer over textures that outlive it; zero names are left out. Throws RenderError when incomplete.
Framebuffer make_framebuffer(GLuint colour_texture, GLuint depth_texture);

// One attribute of floats in the buffer that is bound. A divisor of 1 makes it one value an instance.
void use_float_attribute(GLuint location, int components, std::size_t stride_bytes, std::size_t offset_bytes,
                         GLuint divisor = 0);

class Program {
 public:
    // Each stage is the text of its files, one behind the other, behind "#version 330 core". `captured` names
    // the outputs that transform feedback writes, interleaved. Throws RenderError with the compiler's log.
    Program(const std::vector<std::string>& vertex_files, const std::vector<std::string>& fragment_files,
            const std::vector<const char*>& captured = {});

    void use() const { glUseProgram(program_.name()); }
    // Uniforms of the program in use; a name that the compiler dropped is passed over.
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const glm::vec2& value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::mat4& value) const;
    // A mat3x4 whose three columns are the rows of a 3x4 matrix.
    void set_rows(const char* name, const float rows[12]) const;
    // Binds a texture to a unit and the sampler to that unit.
    void set_texture(const char* name, int unit, GLuint texture) const;

 private:
    GLint location(const char* name) const { return glGetUniformLocation(program_.name(), name); }
    Owned<delete_program> program_;
};

// Throws RenderError when OpenGL has met an error since the last call.
void check_gl(const char* after);

}  // namespace posepack::render
