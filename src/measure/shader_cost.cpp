// SPDX-License-Identifier: MIT
#include "measure/shader_cost.hpp"

namespace posepack::measure {

// Matrices: each number of both rows is one multiply-add with its weight folded in (24 or 32 a bone), and two
// multiplications make the weights; then 9 + 3 for the position, 9 for the normal and 7 to normalise it.
// Dual quaternions: 14 a row to take the scale out, 18 to mix, 21 to normalise and for the translation, 36
// for the rotation with its scale, 12 to add the bone to the others: about 115 a bone, and the same rest.
ShaderCost shader_cost(recipe::Encoding encoding) {
    constexpr std::uint32_t kInfluences = 4, kRows = 2;
    switch (encoding) {
        case recipe::Encoding::mat4:
            return {kInfluences * kRows * 4, 165};
        case recipe::Encoding::affine:
            return {kInfluences * kRows * 3, 130};
        case recipe::Encoding::dualquat:
            return {kInfluences * kRows * 2, 500};
    }
    return {};
}

}  // namespace posepack::measure
