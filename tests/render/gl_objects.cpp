// SPDX-License-Identifier: MIT
#include "render/gl_objects.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <glm/gtc/type_ptr.hpp>
#include <sstream>

#include "render/error.hpp"

namespace posepack::render {
namespace {

std::string shader_text(const std::vector<std::string>& files) {
    std::string text = "#version 330 core\n";
    for (const std::string& file : files) {
        std::ifstream stream(std::string(POSEPACK_SHADER_FOLDER "/") + file);
        require(stream.good(), fmt::format("expected the shader {} in {}", file, POSEPACK_SHADER_FOLDER));
        std::ostringstream content;
        content << stream.rdbuf();
        text += content.str();
    }
    return text;
}

GLuint compile(GLenum stage, const std::vector<std::string>& files) {
    const std::string text = shader_text(files);
    const char* data = text.c_str();
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &data, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::array<char, 2048> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    require(compiled == GL_TRUE, fmt::format("{} does not compile: {}", files.back(), log.data()));
    return shader;
}

}  // namespace

void delete_buffer(GLuint name) {
    glDeleteBuffers(1, &name);
}
void delete_texture(GLuint name) {
    glDeleteTextures(1, &name);
}
void delete_vertex_array(GLuint name) {
    glDeleteVertexArrays(1, &name);
}
void delete_framebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}
void delete_program(GLuint name) {
    glDeleteProgram(name);
}

Buffer make_buffer(GLenum target, const void* data, std::size_t size_bytes, GLenum usage) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, static_cast<GLsizeiptr>(size_bytes), data, usage);
    return Buffer(name);
}

VertexArray make_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    glBindVertexArray(name);
    return VertexArray(name);
}

Texture make_texture(GLint internal_format, int width, int height, GLenum format, GLenum type,
                     const void* data) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, type, data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return Texture(name);
}

Framebuffer make_framebuffer(GLuint colour_texture, GLuint depth_texture) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    if (colour_texture != 0)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_texture, 0);
    else
        glDrawBuffer(GL_NONE);
    if (depth_texture != 0)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_texture, 0);
    Framebuffer framebuffer(name);
    require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
            "expected a complete framebuffer; the driver lacks one of its formats or sizes");
    return framebuffer;
}

void use_float_attribute(GLuint location, int components, std::size_t stride_bytes, std::size_t offset_bytes,
                         GLuint divisor) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride_bytes),
                          reinterpret_cast<const void*>(offset_bytes));
    glVertexAttribDivisor(location, divisor);
}

Program::Program(const std::vector<std::string>& vertex_files, const std::vector<std::string>& fragment_files,
                 const std::vector<const char*>& captured)
    : program_(glCreateProgram()) {
    const std::array<GLuint, 2> shaders = {compile(GL_VERTEX_SHADER, vertex_files),
                                           compile(GL_FRAGMENT_SHADER, fragment_files)};
    for (const GLuint shader : shaders) {
        glAttachShader(program_.name(), shader);
        glDeleteShader(shader);
    }
    if (!captured.empty())
        glTransformFeedbackVaryings(program_.name(), static_cast<GLsizei>(captured.size()), captured.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program_.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
    std::array<char, 2048> log{};
    glGetProgramInfoLog(program_.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    require(linked == GL_TRUE,
            fmt::format("{} and {} do not link: {}", vertex_files.back(), fragment_files.back(), log.data()));
}

void Program::set(const char* name, int value) const {
    glUniform1i(location(name), value);
}
void Program::set(const char* name, float value) const {
    glUniform1f(location(name), value);
}
void Program::set(const char* name, const glm::vec2& value) const {
    glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::vec3& value) const {
    glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set_rows(const char* name, const float rows[12]) const {
    glUniformMatrix3x4fv(location(name), 1, GL_FALSE, rows);
}

void Program::set_texture(const char* name, int unit, GLuint texture) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    set(name, unit);
}

void check_gl(const char* after) {
    const GLenum error = glGetError();
    require(error == GL_NO_ERROR, fmt::format("OpenGL error {:#x} after {}", error, after));
}

}  // namespace posepack::render
