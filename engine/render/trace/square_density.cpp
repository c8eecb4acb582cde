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
    list_leaves(0, vec2(0.0f), 1.0f, 1.0);
    first_leaf_.resize(leaves_.size());
    std::uint32_t leaf = 0;
    for (std::size_t part = 0; part < first_leaf_.size(); ++part) {
        const double start = static_cast<double>(part) / static_cast<double>(first_leaf_.size());
        while (leaf + 1 < leaves_.size() && leaves_[leaf + 1].before <= start) ++leaf;
        first_leaf_[part] = leaf;
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

void SquareDensity::list_leaves(std::uint32_t number, vec2 low, float size, double share) {
    const float half = 0.5f * size;
    for (std::size_t q = 0; q < 4; ++q) {
        const Cell& cell = cells_[number];
        const vec2 corner = low + half * vec2(q & 1, q >> 1);
        const double own = share * cell.share[q];
        if (cell.inside[q] != 0) {
            list_leaves(cell.inside[q], corner, half, own);
        } else {
            const double before = leaves_.empty() ? 0.0 : leaves_.back().before + leaves_.back().share;
            leaves_.push_back({corner, half, static_cast<float>(own), before});
        }
    }
}

vec2 SquareDensity::sample(vec2 xi) const {
    // One look into a table finds the leaf but for a step or two; descending the tree would miss the cache at each cell.
    std::uint32_t i = first_leaf_[std::min(static_cast<std::size_t>(xi.x * static_cast<float>(first_leaf_.size())), first_leaf_.size() - 1)];
    while (i + 1 < leaves_.size() && leaves_[i + 1].before <= xi.x) ++i;
    const Leaf& leaf = leaves_[i];
    // What chose the leaf, stretched back to the whole interval, is as good as a number of its own.
    xi.x = std::clamp(static_cast<float>((xi.x - leaf.before) / leaf.share), 0.0f, 0.99999994f);
    return glm::min(leaf.low + leaf.size * xi, 0.99999994f);
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
