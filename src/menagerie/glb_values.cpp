// SPDX-License-Identifier: MIT
#include "menagerie/glb_values.hpp"

#include "base/text.hpp"

namespace posepack::menagerie {

Json number(double value) {
    const auto single = static_cast<float>(value);
    return base::widened(single == 0.0f ? 0.0f : single);
}

Json vector_json(const Vec3& v) {
    return Json::array({number(v.x), number(v.y), number(v.z)});
}

Json quaternion_json(const Quat& q) {
    return Json::array({number(q.x), number(q.y), number(q.z), number(q.w)});
}

void put_vector(Payload& payload, const Vec3& v) {
    for (const double value : {v.x, v.y, v.z}) payload.put_f32(static_cast<float>(value));
}

void put_quaternion(Payload& payload, const Quat& q) {
    for (const double value : {q.x, q.y, q.z, q.w}) payload.put_f32(static_cast<float>(value));
}

Quat armature_turn(const ExportStyle& style) {
    return style.z_up_armature ? pitch(-90.0) : kNoTurn;
}

Local local_of(const Model& model, std::size_t index, const Quat& turn, const Vec3& shift) {
    const RigJoint& joint = model.rig.joints[index];
    const bool is_root = joint.parent < 0;
    const Vec3 origin = is_root ? Vec3(0.0) : model.rig.joints[static_cast<std::size_t>(joint.parent)].head;
    const Quat axes = glm::conjugate(is_root ? armature_turn(model.style)
                                             : model.rig.joints[static_cast<std::size_t>(joint.parent)].bone);
    return {axes * (joint.head - origin + shift) * (1.0 / model.style.armature_scale),
            glm::normalize(axes * turn * joint.bone)};
}

}  // namespace posepack::menagerie
