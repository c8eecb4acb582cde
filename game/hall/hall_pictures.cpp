// SPDX-License-Identifier: MIT
#include "game/hall/hall_pictures.h"

#include <cmath>

namespace sl {

namespace {

constexpr float tau = 2.0f * pi;

/// 0 to 1, smooth, with `cells` cells along each side of a picture that it repeats with.
class Noise {
  public:
    Noise(std::uint64_t seed, std::uint32_t cells) : seed_(seed), cells_(cells) {}

    float at(vec2 uv) const {
        const vec2 place = uv * static_cast<float>(cells_), cell = glm::floor(place), in = place - cell, weight = in * in * (3.0f - 2.0f * in);
        return glm::mix(glm::mix(corner(cell), corner(cell + vec2(1, 0)), weight.x), glm::mix(corner(cell + vec2(0, 1)), corner(cell + vec2(1, 1)), weight.x), weight.y);
    }

  private:
    float corner(vec2 cell) const {
        const auto x = static_cast<std::uint32_t>(cell.x) % cells_, y = static_cast<std::uint32_t>(cell.y) % cells_;
        return static_cast<float>(hash_mix(hash_mix(seed_, x), y) >> 40) / static_cast<float>(1 << 24);
    }
    std::uint64_t seed_;
    std::uint32_t cells_;
};

/// Four octaves, 0 to 1.
float layered_noise(std::uint64_t seed, vec2 uv, std::uint32_t cells) {
    float sum = 0.0f, weight = 0.5f;
    for (std::uint64_t octave = 0; octave < 4; ++octave, cells *= 2, weight *= 0.5f) sum += weight * Noise(hash_mix(seed, octave), cells).at(uv);
    return sum / 0.9375f;
}

template <class Colour>
Image painted(std::uint32_t side, const Colour& colour) {
    Image picture(side, side, 3);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const vec3 here = colour((vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) / static_cast<float>(side));
            std::copy_n(&here.x, 3, picture.pixel(x, y));
        }
    }
    return picture;
}

}  // namespace

Image tile_picture(std::uint64_t seed) {
    return painted(256, [=](vec2 uv) {
        const bool dark = (uv.x < 0.5f) != (uv.y < 0.5f);
        const float cloud = layered_noise(seed, uv, 4);
        const float vein = std::pow(1.0f - std::abs(2.0f * layered_noise(seed + 1, uv, 3) - 1.0f), 12.0f);
        const vec3 marble = dark ? vec3(0.50f, 0.36f, 0.29f) : vec3(0.84f, 0.79f, 0.71f);
        return marble * (0.85f + 0.3f * cloud) + (dark ? 0.18f : -0.12f) * vein;
    });
}

Image stone_picture(std::uint64_t seed) {
    return painted(256, [=](vec2 uv) {
        // Four courses of two stones, each course shifted by half of one.
        const float course = std::floor(4.0f * uv.y), along = 2.0f * uv.x + 0.5f * std::fmod(course, 2.0f);
        const auto stone = static_cast<std::uint64_t>(along) % 2;
        const vec2 in(along - std::floor(along), 4.0f * uv.y - course);
        const float to_edge = std::min(std::min(in.x, 1.0f - in.x) * 2.0f, std::min(in.y, 1.0f - in.y));
        const float joint = glm::smoothstep(0.02f, 0.05f, to_edge);
        const float shade = Noise(hash_mix(hash_mix(seed, static_cast<std::uint64_t>(course)), stone), 1).at(vec2(0.0f));
        const float grain = layered_noise(seed, uv, 8);
        return vec3(0.84f, 0.78f, 0.68f) * (0.84f + 0.12f * shade + 0.14f * grain) * glm::mix(0.82f, 1.0f, joint);
    });
}

Image cloth_picture(std::uint64_t seed) {
    return painted(128, [=](vec2 uv) {
        const float weave = 0.5f + 0.25f * (std::sin(64.0f * tau * uv.x) + std::sin(64.0f * tau * uv.y));
        const float stripe = glm::smoothstep(0.35f, 0.45f, std::sin(4.0f * tau * uv.y));
        const float worn = layered_noise(seed, uv, 6);
        return vec3((0.8f + 0.06f * weave + 0.12f * worn) * glm::mix(1.0f, 0.72f, stripe));
    });
}

}  // namespace sl
