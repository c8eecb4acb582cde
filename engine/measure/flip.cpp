// SPDX-License-Identifier: MIT
#include "engine/measure/flip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/measure/flip_colour.h"
#include "engine/measure/flip_filters.h"
#include "engine/measure/metrics.h"

namespace sl {

namespace {

constexpr float colour_exponent = 0.7f;   // q_c: compresses large colour differences
constexpr float knee_share = 0.4f;        // p_c: up to this share of the largest difference …
constexpr float knee_value = 0.95f;       // p_t: … is spread over this part of the scale
constexpr float feature_exponent = 0.5f;  // q_f

template <class Body>
void each_pixel(std::size_t count, Body&& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
                      });
}

std::array<Plane, 3> opponent_planes(const Image& image, const std::vector<float>& mask) {
    std::array<Plane, 3> planes;
    planes.fill(Plane(image.width, image.height));
    each_pixel(planes[0].data.size(), [&](std::size_t i) {
        const float* p = &image.data[i * image.channels];
        const bool masked = !mask.empty() && mask[i] == 0.0f;
        const vec3 encoded = masked ? vec3(0.0f) : glm::clamp(vec3(p[0], p[1], p[2]), 0.0f, 1.0f);
        const vec3 opponent = opponent_from_linear(linear_from_srgb(encoded));
        for (int c = 0; c < 3; ++c) planes[static_cast<std::size_t>(c)].data[i] = opponent[c];
    });
    return planes;
}

/// What is seen of one picture: the colours that are left, and the edges and points that stand out.
struct Seen {
    std::array<Plane, 3> opponent;
    Features features;
};

Seen see(const Image& image, const std::vector<float>& mask, double pixels_per_degree) {
    std::array<Plane, 3> planes = opponent_planes(image, mask);
    Seen seen{.opponent = through_the_eye(planes, pixels_per_degree), .features = {}};
    for (float& y : planes[0].data) y = (y + 16.0f) / 116.0f;
    seen.features = features_of(planes[0], pixels_per_degree);
    return seen;
}

vec3 lab_at(const Seen& seen, std::size_t i) {
    const vec3 opponent(seen.opponent[0].data[i], seen.opponent[1].data[i], seen.opponent[2].data[i]);
    return hunt_lab_from_linear(glm::clamp(linear_from_opponent(opponent), 0.0f, 1.0f));
}

/// Most of the scale goes to differences that occur in renderings; the rest up to green against blue, the largest.
float spread(float difference, float largest) {
    const float knee = knee_share * largest;
    if (difference < knee) return difference * knee_value / knee;
    return std::min(knee_value + (difference - knee) / (largest - knee) * (1.0f - knee_value), 1.0f);
}

float feature_difference(const Features& a, const Features& b, std::size_t i) {
    const float edges = std::abs(a.edges.data[i] - b.edges.data[i]);
    const float points = std::abs(a.points.data[i] - b.points.data[i]);
    // Both lie in [0, √2]: a unit step along each axis.
    return std::pow(std::min(std::max(edges, points) / std::sqrt(2.0f), 1.0f), feature_exponent);
}

}  // namespace

Flip flip(const Image& image, const Image& reference, const std::vector<float>& mask, float pixels_per_degree) {
    CHECK(image.width == reference.width && image.height == reference.height, "{}x{} against {}x{}", image.width,
          image.height, reference.width, reference.height);
    CHECK(image.channels >= 3 && reference.channels >= 3, "{} channels against {}", image.channels, reference.channels);
    CHECK(mask.empty() || mask.size() == std::size_t{image.width} * image.height, "{} mask values for {}x{}",
          mask.size(), image.width, image.height);
    CHECK(pixels_per_degree >= 1.0f, "{} pixels per degree", pixels_per_degree);
    check_finite("the picture", image, mask);
    check_finite("the reference's picture", reference, mask);
    const Seen a = see(image, mask, double{pixels_per_degree}), b = see(reference, mask, double{pixels_per_degree});
    const float largest =
        std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), colour_exponent);
    Flip result{.map = Image(image.width, image.height, 1)};
    each_pixel(result.map.data.size(), [&](std::size_t i) {
        const float colour = spread(std::pow(hyab(lab_at(a, i), lab_at(b, i)), colour_exponent), largest);
        result.map.data[i] = std::pow(colour, 1.0f - feature_difference(a.features, b.features, i));
    });
    result.mean = masked_mean(result.map, mask);
    return result;
}

}  // namespace sl
