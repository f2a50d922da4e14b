// SPDX-License-Identifier: MIT
// The forms that a palette can have: encoding, texel format and space.
#pragma once

#include <span>
#include <string>

#include "recipe/catalog.hpp"

namespace posepack::stress {

struct Form {
    recipe::Encoding encoding = recipe::Encoding::dualquat;
    recipe::TexelFormat texel_format = recipe::TexelFormat::rgba16f;
    recipe::Space space = recipe::Space::normalised;  // never automatic

    bool operator==(const Form&) const = default;
};

// Every form there is: mat4, affine and dualquat, RGBA32F before RGBA16F; first all in the space that the
// encoding has by default, then all in the other.
std::span<const Form> all_forms();

// Whether a form lies in the space that its encoding has by default.
bool is_default_space(const Form& form);

// Bytes of a bone and row.
unsigned bytes_of(const Form& form);

// "dualquat 16F", and ", model space" behind it where that is not the default.
std::string label_of(const Form& form);

// The wishes of `entry`, but in this form.
recipe::AnimalEntry in_form(recipe::AnimalEntry entry, const Form& form);

}  // namespace posepack::stress
