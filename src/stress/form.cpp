// SPDX-License-Identifier: MIT
#include "stress/form.hpp"

#include <fmt/format.h>

#include <array>

namespace posepack::stress {
namespace {

using recipe::Encoding;
using recipe::Space;
using recipe::TexelFormat;

Space default_space(Encoding encoding) {
    recipe::OutputOptions output;
    output.encoding = encoding;
    return output.is_normalised() ? Space::normalised : Space::model;
}

std::array<Form, 12> make_forms() {
    std::array<Form, 12> forms;
    std::size_t count = 0;
    for (const bool is_default : {true, false})
        for (const Encoding encoding : {Encoding::mat4, Encoding::affine, Encoding::dualquat})
            for (const TexelFormat format : {TexelFormat::rgba32f, TexelFormat::rgba16f}) {
                const bool is_normalised = (default_space(encoding) == Space::normalised) == is_default;
                forms[count++] = {encoding, format, is_normalised ? Space::normalised : Space::model};
            }
    return forms;
}

}  // namespace

std::span<const Form> all_forms() {
    static const std::array<Form, 12> kForms = make_forms();
    return kForms;
}

bool is_default_space(const Form& form) {
    return form.space == default_space(form.encoding);
}

unsigned bytes_of(const Form& form) {
    const unsigned texels = form.encoding == Encoding::mat4 ? 4 : form.encoding == Encoding::affine ? 3 : 2;
    return texels * (form.texel_format == TexelFormat::rgba16f ? 8 : 16);
}

std::string label_of(const Form& form) {
    const char* format = form.texel_format == TexelFormat::rgba16f ? "16F" : "32F";
    const std::string label = fmt::format("{} {}", name_of(form.encoding), format);
    return is_default_space(form) ? label : fmt::format("{}, {} space", label, name_of(form.space));
}

recipe::AnimalEntry in_form(recipe::AnimalEntry entry, const Form& form) {
    entry.output.encoding = form.encoding;
    entry.output.texel_format = form.texel_format;
    entry.output.space = form.space;
    return entry;
}

}  // namespace posepack::stress
