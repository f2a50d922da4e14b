// SPDX-License-Identifier: MIT
#include "render/herd_scene.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>
#include <utility>

#include "render/terrain.hpp"

namespace posepack::render {
namespace {

constexpr float kTwoPi = 2.0f * glm::pi<float>();

// A small generator of our own: equal pictures need equal numbers from every standard library.
class Dice {
 public:
    explicit Dice(std::uint32_t seed) : state_(seed) {}
    float share() {  // 0 .. 1
        state_ = state_ * 1664525u + 1013904223u;
        return static_cast<float>(state_ >> 8) / 16777216.0f;
    }
    float between(float low, float high) { return low + (high - low) * share(); }
    float around(float middle, float spread) { return middle + spread * (share() + share() - 1.0f); }

 private:
    std::uint32_t state_;
};

// Keeps animals out of each other.
class Room {
 public:
    bool claim(glm::vec2 place, float radius) {
        for (const auto& [other, other_radius] : taken_)
            if (glm::distance(place, other) < radius + other_radius) return false;
        taken_.push_back({place, radius});
        return true;
    }

 private:
    std::vector<std::pair<glm::vec2, float>> taken_;
};

glm::vec3 on_ground(glm::vec2 place, float above = 0.0f) {
    return {place.x, ground_height(place.x, place.y) + above, place.y};
}

float heading_of(glm::vec2 way) {
    return std::atan2(way.x, way.y);
}

// Coats of a herd: mostly tan, some dark, some nearly white.
glm::vec3 coat(Dice& dice) {
    constexpr std::array<glm::vec3, 6> kCoats = {{{1.0f, 1.0f, 1.0f},
                                                  {0.72f, 0.66f, 0.62f},
                                                  {1.35f, 1.38f, 1.42f},
                                                  {1.1f, 0.95f, 0.82f},
                                                  {0.5f, 0.46f, 0.45f},
                                                  {1.6f, 1.68f, 1.78f}}};
    const float shade = dice.between(0.9f, 1.1f);
    return shade * kCoats[static_cast<std::size_t>(dice.share() * 5.999f)];
}

class Composer {
 public:
    HerdScene compose() {
        scene_.crowds = {{"goat", {}}, {"wolf", {}}, {"sparrow", {}}, {"viper", {}}};
        place_vipers();
        lead_the_way();
        chase();
        walk_the_path();
        graze();
        fly();
        hop();
        plant();
        return std::move(scene_);
    }

 private:
    enum Kind : std::size_t { goat, wolf, sparrow, viper };

    void add(Kind kind, const char* clip, const Instance& instance) {
        scene_.crowds[kind].actors.push_back({clip, instance});
    }

    Instance grown_goat(glm::vec2 place, float heading) {
        Instance out{on_ground(place), heading};
        const bool is_kid = dice_.share() < 0.14f;
        out.scale = is_kid ? dice_.between(0.55f, 0.66f) : dice_.between(0.92f, 1.1f);
        out.rate = dice_.between(0.92f, 1.1f) / std::sqrt(out.scale);
        out.tint = coat(dice_);
        return out;
    }

    void place_vipers() {
        const auto at = [this](float x, float z, float heading, const char* clip) {
            Instance snake{on_ground({x, z}, 0.004f), heading, 1.5f};
            add(viper, clip, snake);
            room_.claim({x, z}, 0.6f);
        };
        at(-1.9f, -6.15f, 1.25f, "Slither");
        at(2.55f, -6.5f, -1.0f, "Rise");
    }

    // A few animals in front, placed by hand.
    void lead_the_way() {
        struct Lead {
            float x, z, heading, scale;
            const char* clip;
            glm::vec3 tint;
        };
        const std::array<Lead, 7> leads = {{{1.7f, -8.0f, 0.75f, 1.06f, "Walk", {1.0f, 1.0f, 1.0f}},
                                            {0.1f, -9.6f, 0.70f, 1.0f, "Walk", {1.6f, 1.66f, 1.75f}},
                                            {0.35f, -8.2f, 0.8f, 0.58f, "Trot", {1.2f, 1.15f, 1.1f}},
                                            {-1.5f, -11.4f, 0.6f, 1.08f, "Walk", {0.55f, 0.5f, 0.5f}},
                                            {-3.3f, -7.9f, 2.2f, 1.0f, "Eat", {1.1f, 0.98f, 0.85f}},
                                            {-5.9f, -12.3f, 0.5f, 1.04f, "Idle", {0.75f, 0.68f, 0.64f}},
                                            {5.0f, -10.6f, -2.1f, 0.97f, "Eat", {1.35f, 1.36f, 1.4f}}}};
        for (const Lead& lead : leads) {
            Instance out{on_ground({lead.x, lead.z}), lead.heading, lead.scale};
            out.tint = lead.tint;
            add(goat, lead.clip, out);
            room_.claim({lead.x, lead.z}, 0.75f * lead.scale);
        }
    }

    void walk_the_path() {
        for (int attempt = 0; attempt < 2200; ++attempt) {
            const float along = dice_.between(0.02f, 0.93f);
            const glm::vec2 way = glm::normalize(path_place(along + 0.01f) - path_place(along - 0.01f));
            const glm::vec2 side(way.y, -way.x);
            const glm::vec2 place = path_place(along) + side * dice_.around(0.0f, 3.1f);
            Instance out = grown_goat(place, heading_of(way) + dice_.around(0.0f, 0.22f));
            if (!room_.claim(place, 0.85f * out.scale)) continue;
            add(goat, out.scale < 0.7f || dice_.share() < 0.15f ? "Trot" : "Walk", out);
        }
    }

    static bool is_hunted(glm::vec2 place) { return place.x > 2.5f && place.y < -17.0f && place.y > -36.0f; }

    void graze() {
        for (int attempt = 0; attempt < 900; ++attempt) {
            const float away = 11.0f + 80.0f * dice_.share() * dice_.share();
            const glm::vec2 place(dice_.between(-0.62f, 0.62f) * (away + 3.0f), -away);
            // Loose groups: the noise opens clearings between them.
            if (smooth_noise(place * 0.16f) < 0.56f || is_hunted(place)) continue;
            Instance out = grown_goat(place, dice_.between(0.0f, kTwoPi));
            if (!room_.claim(place, 1.0f * out.scale)) continue;
            const float mood = dice_.share();
            add(goat, mood < 0.62f ? "Eat" : mood < 0.86f ? "Idle" : "Sleep", out);
        }
    }

    // Wolves cut some goats off from the herd and drive them to the right.
    void chase() {
        for (const glm::vec2 place :
             {glm::vec2(2.9f, -21.5f), {5.6f, -25.0f}, {6.5f, -21.0f}, {9.3f, -24.0f}}) {
            Instance out{on_ground(place), heading_of({1.0f, 0.12f}) + dice_.around(0.0f, 0.2f), 1.15f};
            out.tint = glm::vec3(dice_.between(0.75f, 1.15f));
            add(wolf, "Gallop", out);
            room_.claim(place, 1.3f);
        }
        for (int attempt = 0; attempt < 160; ++attempt) {
            const glm::vec2 place(dice_.between(9.8f, 22.0f), dice_.around(-26.0f, 6.0f));
            Instance out = grown_goat(place, heading_of({1.0f, 0.1f}) + dice_.around(0.0f, 0.35f));
            if (room_.claim(place, 1.05f * out.scale)) add(goat, "Gallop", out);
        }
    }

    void fly() {
        for (int i = 0; i < 58; ++i) {
            const float t = dice_.share();
            const glm::vec2 place(-7.5f + 15.0f * t + dice_.around(0.0f, 1.6f),
                                  -9.0f - 9.0f * t + dice_.around(0.0f, 3.0f));
            Instance out{on_ground(place, 3.0f + 1.6f * t + dice_.around(0.0f, 0.8f)),
                         0.9f + dice_.around(0.0f, 0.4f)};
            out.scale = 1.7f;
            out.rate = dice_.between(0.9f, 1.15f);
            out.bank = dice_.around(0.0f, 0.35f);
            add(sparrow, dice_.share() < 0.24f ? "Glide" : "Fly", out);
        }
    }

    void hop() {
        constexpr std::array<const char*, 4> kClips = {"Peck", "Hop", "Idle", "Peck"};
        for (int attempt = 0; attempt < 60; ++attempt) {
            const glm::vec2 place(dice_.around(0.5f, 1.2f), dice_.around(-6.3f, 0.75f));
            if (!room_.claim(place, 0.17f)) continue;
            Instance out{on_ground(place), dice_.between(0.0f, kTwoPi), 1.3f};
            add(sparrow, kClips[static_cast<std::size_t>(attempt) % 4], out);
        }
    }

    void plant() {
        for (int attempt = 0; attempt < 7400; ++attempt) {
            const float away = 4.0f + 24.0f * dice_.share() * dice_.share();
            const glm::vec2 place(dice_.between(-0.66f, 0.66f) * (away + 2.0f), -away);
            if (smooth_noise(place * 0.55f) < dice_.between(0.45f, 0.8f) || trodden_at(place) > 0.3f)
                continue;
            Prop tuft{on_ground(place), dice_.between(0.0f, kTwoPi), dice_.between(0.6f, 1.15f)};
            tuft.tint = glm::mix(glm::vec3(0.8f, 1.0f, 0.7f), glm::vec3(1.35f, 1.15f, 0.8f), dice_.share());
            scene_.tufts.push_back(tuft);
            if (dice_.share() < 0.10f && away < 22.0f) {
                tuft.tint =
                    dice_.share() < 0.5f ? glm::vec3(1.0f, 0.95f, 0.85f) : glm::vec3(1.0f, 0.72f, 0.12f);
                scene_.flowers.push_back(tuft);
            }
        }
        for (int attempt = 0; attempt < 4200; ++attempt) {
            const float away = 135.0f + 420.0f * dice_.share();
            const glm::vec2 place(dice_.between(-0.7f, 0.7f) * away, -away);
            if (smooth_noise(place * glm::vec2(0.017f, 0.012f) + 4.0f) < 0.69f) continue;
            const float size = dice_.share();
            Prop tree{on_ground(place, -0.3f), dice_.between(0.0f, kTwoPi), 0.45f + 0.9f * size * size};
            tree.tint = glm::vec3(dice_.between(0.8f, 1.2f));
            scene_.trees.push_back(tree);
        }
    }

    HerdScene scene_;
    Room room_;
    Dice dice_{2024};
};

}  // namespace

HerdScene compose_herd() {
    return Composer().compose();
}

}  // namespace posepack::render
