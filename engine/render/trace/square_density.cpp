// SPDX-License-Identifier: MIT
#include "engine/render/trace/square_density.h"

#include <algorithm>

namespace sl {

namespace {

constexpr std::size_t most_points = 16;  ///< in a cell that is not split
constexpr int most_depth = 16;           ///< cells of 1/65536 of the side
/// What each quarter gets beyond its points, in mean points: where none was found, some may be.
constexpr float unfound_points = 0.5f;

}  // namespace

SquareDensity::SquareDensity(std::span<const WeightedPoint> points) {
    std::vector<WeightedPoint> own;
    for (const WeightedPoint& point : points) {
        if (point.weight > 0.0f) own.push_back(point);
    }
    if (own.empty()) {
        cells_.push_back({.share = {0.25f, 0.25f, 0.25f, 0.25f}});
    } else {
        split(own, vec2(0.0f), 1.0f, 0);
    }
}

std::uint32_t SquareDensity::split(std::span<WeightedPoint> points, vec2 low, float size, int depth) {
    const auto number = static_cast<std::uint32_t>(cells_.size());
    cells_.emplace_back();
    const float half = 0.5f * size;
    const vec2 middle = low + half;
    const auto lower_y = std::partition(points.begin(), points.end(), [&](const WeightedPoint& p) { return p.at.y < middle.y; });
    const auto left = [&](const WeightedPoint& p) { return p.at.x < middle.x; };
    const std::array ends{points.begin(), std::partition(points.begin(), lower_y, left), lower_y, std::partition(lower_y, points.end(), left), points.end()};

    std::array<float, 4> weight{};
    float total = 0.0f;
    for (std::size_t q = 0; q < 4; ++q) {
        for (const WeightedPoint& p : std::span(ends[q], ends[q + 1])) weight[q] += p.weight;
        total += weight[q];
    }
    const float extra = unfound_points * total / static_cast<float>(points.size());
    for (std::size_t q = 0; q < 4; ++q) {
        cells_[number].share[q] = (weight[q] + extra) / (total + 4.0f * extra);
        const std::span<WeightedPoint> own(ends[q], ends[q + 1]);
        if (own.size() <= most_points || depth + 1 >= most_depth) continue;
        const std::uint32_t inside = split(own, low + half * vec2(q & 1, q >> 1), half, depth + 1);
        cells_[number].inside[q] = inside;
    }
    return number;
}

vec2 SquareDensity::sample(vec2 xi) const {
    vec2 low(0.0f);
    float half = 0.5f;
    // Which half is taken stretches what chose it back to the whole interval, so that well-spread points stay so.
    const auto choose = [](float& x, float share) {
        const bool upper = x >= share;
        x = upper ? (x - share) / (1.0f - share) : x / share;
        x = std::clamp(x, 0.0f, 0.99999994f);
        return upper ? 1u : 0u;
    };
    for (std::uint32_t number = 0;; half *= 0.5f) {
        const Cell& cell = cells_[number];
        const std::uint32_t above = choose(xi.y, cell.share[0] + cell.share[1]);
        const float pair = cell.share[2 * above] + cell.share[2 * above + 1];
        const std::uint32_t right = choose(xi.x, cell.share[2 * above] / pair);
        low += half * vec2(right, above);
        number = cell.inside[2 * above + right];
        if (number == 0) return low + half * xi;
    }
}

float SquareDensity::density(vec2 at) const {
    if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < 1.0f && at.y < 1.0f)) return 0.0f;
    float result = 1.0f;
    for (std::uint32_t number = 0;;) {
        const Cell& cell = cells_[number];
        const std::uint32_t quarter = (at.x >= 0.5f ? 1u : 0u) + (at.y >= 0.5f ? 2u : 0u);
        at = glm::fract(2.0f * at);
        result *= 4.0f * cell.share[quarter];
        number = cell.inside[quarter];
        if (number == 0) return result;
    }
}

}  // namespace sl
