// SPDX-License-Identifier: MIT
#include "engine/render/trace/mean_albedo.h"

#include <array>

#include "engine/render/trace/samples.h"

namespace sl {

namespace {

/// Of the specular lobe without Fresnel's term, and of the lobe times that term's (1 - cos θ)⁵.
struct Lobe {
    float whole = 0.0f, grazing = 0.0f;
};

constexpr std::size_t steps = 32;
constexpr std::uint32_t directions = 8192, seed = 9;

/// Sampled along microfacet normals of Trowbridge and Reitz, with view directions in proportion to their cosines.
Lobe measure(float roughness) {
    const float alpha = std::max(roughness * roughness, 1e-3f);
    const vec3 normal(0, 0, 1);
    Lobe sum;
    for (std::uint32_t i = 0; i < directions; ++i) {
        SampleSequence samples(seed, uvec2(0), i);
        const vec2 xi = samples.pair(), eye = samples.pair();
        const float n_dot_v = std::sqrt(std::max(eye.x, 1e-6f)), tangent = alpha * std::sqrt(xi.x / (1.0f - xi.x));
        const vec3 to_eye(std::sqrt(1.0f - n_dot_v * n_dot_v), 0.0f, n_dot_v);
        const float cosine = 1.0f / std::sqrt(1.0f + tangent * tangent), angle = 2.0f * pi * xi.y;
        const vec3 halfway = cosine * vec3(tangent * std::cos(angle), tangent * std::sin(angle), 1.0f);
        const float v_dot_h = glm::dot(to_eye, halfway);
        const vec3 to_light = 2.0f * v_dot_h * halfway - to_eye;
        if (v_dot_h <= 0.0f || to_light.z <= 0.0f) continue;
        const float a2 = alpha * alpha, spread = cosine * cosine * (tangent * tangent + a2), density = a2 * cosine / (pi * spread * spread) / (4.0f * v_dot_h);
        const float weight = ggx_specular(alpha, normal, halfway, to_light.z, n_dot_v) * to_light.z / density;
        const float away = 1.0f - v_dot_h;
        sum.whole += weight / static_cast<float>(directions);
        sum.grazing += weight * away * away * away * away * away / static_cast<float>(directions);
    }
    return sum;
}

const std::array<Lobe, steps + 1>& lobes() {
    static const auto table = [] {
        std::array<Lobe, steps + 1> made;
        for (std::size_t i = 0; i <= steps; ++i) made[i] = measure(static_cast<float>(i) / steps);
        return made;
    }();
    return table;
}

Lobe lobe_of(float roughness) {
    const float place = std::clamp(roughness, 0.0f, 1.0f) * steps;
    const auto below = std::min(static_cast<std::size_t>(place), steps - 1);
    const float part = place - static_cast<float>(below);
    const Lobe &a = lobes()[below], &b = lobes()[below + 1];
    return {glm::mix(a.whole, b.whole, part), glm::mix(a.grazing, b.grazing, part)};
}

/// Mean of (1 - v·h)⁵ over pairs of directions that are each weighted with their cosine: what Fresnel's term takes from the
/// diffuse part. By 400,000 samples.
constexpr float grazing_between_directions = 0.0037f;

}  // namespace

vec3 mean_albedo(const Surface& surface) {
    const float metallic = surface.normal.w, specular = glm::mix(surface.specular.x, 1.0f, metallic);
    const vec3 diffuse = diffuse_albedo(surface);
    if (specular <= 0.0f) return diffuse;
    const vec3 f0 = glm::mix(vec3(0.04f * specular), vec3(surface.base_colour), metallic);
    const Lobe lobe = lobe_of(surface.base_colour.w);
    return diffuse * (1.0f - f0 - (specular - f0) * grazing_between_directions) + f0 * lobe.whole + (specular - f0) * lobe.grazing;
}

}  // namespace sl
