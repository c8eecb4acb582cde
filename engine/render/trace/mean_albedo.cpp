// SPDX-License-Identifier: MIT
#include "engine/render/trace/mean_albedo.h"

#include <array>

#include "engine/render/trace/samples.h"
#include "shared/specular_lobe.h"

namespace sl {

namespace {

constexpr std::size_t steps = 32;
constexpr std::uint32_t directions = 8192, seed = 9;

/// The lobe's integrals, with view directions in proportion to their cosines.
vec2 measure(float roughness) {
    vec2 sum(0.0f);
    for (std::uint32_t i = 0; i < directions; ++i) {
        SampleSequence samples(seed, uvec2(0), i);
        const vec2 xi = samples.pair(), eye = samples.pair();
        sum += specular_lobe_sample(roughness, std::sqrt(std::max(eye.x, 1e-6f)), xi);
    }
    return sum / static_cast<float>(directions);
}

const std::array<vec2, steps + 1>& lobes() {
    static const auto table = [] {
        std::array<vec2, steps + 1> made;
        for (std::size_t i = 0; i <= steps; ++i) made[i] = measure(static_cast<float>(i) / steps);
        return made;
    }();
    return table;
}

vec2 lobe_of(float roughness) {
    const float place = std::clamp(roughness, 0.0f, 1.0f) * steps;
    const auto below = std::min(static_cast<std::size_t>(place), steps - 1);
    return glm::mix(lobes()[below], lobes()[below + 1], place - static_cast<float>(below));
}

}  // namespace

vec3 mean_albedo(const Surface& surface) { return albedo_in_even_light(surface, vec3(lobe_of(surface.base_colour.w), mean_grazing_of_diffuse)); }

}  // namespace sl
