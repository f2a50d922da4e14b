// SPDX-License-Identifier: MIT
#include "menagerie/shapes.hpp"

#include "menagerie/bird.hpp"
#include "menagerie/fish.hpp"
#include "menagerie/quadruped.hpp"
#include "menagerie/snake.hpp"

namespace posepack::menagerie {

Model goat() {
    QuadrupedShape shape;
    shape.name = "Goat";
    shape.horns = Horns::swept_back;
    shape.horn_length = 0.26;
    shape.beard_length = 0.12;
    return quadruped_model(shape, {}, 30);
}

Model sparrow() {
    BirdShape shape;
    shape.name = "Sparrow";
    return bird_model(shape, {}, 24);
}

Model trout() {
    FishShape shape;
    shape.name = "Trout";
    return fish_model(shape, {"Fish_Armature", 1.0, false, false}, 30);
}

Model viper() {
    SnakeShape shape;
    shape.name = "Viper";
    return snake_model(shape, {"SnakeArmature", 100.0, true, true}, 24);
}

Model wolf() {
    QuadrupedShape shape;
    shape.name = "Wolf";
    shape.hip_height = 0.68;
    shape.shoulder_height = 0.70;
    shape.body_length = 0.68;
    shape.stance_width = 0.082;
    shape.chest_radius = 0.135;
    shape.chest_depth = 0.235;
    shape.belly_radius = 0.125;
    shape.belly_depth = 0.185;
    shape.rump_radius = 0.115;
    shape.neck_length = 0.23;
    shape.neck_rise_degrees = 36.0;
    shape.neck_radius = 0.102;
    shape.neck_base_depth = 0.165;
    shape.head_length = 0.29;
    shape.head_drop_degrees = 12.0;
    shape.head_radius = 0.098;
    shape.head_depth = 0.088;
    shape.muzzle_radius = 0.041;
    shape.muzzle_depth = 0.041;
    shape.leg_radius = 0.025;
    shape.thigh_radius = 0.082;
    shape.ear_length = 0.135;
    shape.ear_width = 0.05;
    shape.ear_rise_degrees = 72.0;
    shape.tail_length = 0.46;
    shape.tail_radius = 0.038;
    shape.tail_rise_degrees = -58.0;
    shape.tail_bush = 0.9;
    shape.tail_joints = 5;
    shape.foot = Foot::paw;
    shape.coat = 0x7E7F80;
    shape.back = 0x3E4043;
    shape.belly = 0xD8D4CA;
    shape.neck = 0x8C8B88;
    shape.face = 0x9C9A94;
    shape.muzzle = 0xE2DED4;
    shape.nose = 0x1E1C1C;
    shape.leg = 0xA39C90;
    shape.sock = 0xCFC7B8;
    shape.hoof = 0xB0A595;
    shape.ear = 0x5A5856;
    shape.ear_inside = 0xB49A8C;
    shape.tail = 0x5C5C5E;
    shape.iris = 0xE0C050;
    return quadruped_model(shape, {"AnimalArmature", 100.0, true, false}, 24);
}

}  // namespace posepack::menagerie
