// SPDX-License-Identifier: MIT
#include "engine/render/trace/learn_light_paths.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace sl {

namespace {

constexpr std::size_t paths_per_run = 50000;
constexpr std::size_t most_paths_per_place = 32;
/// How often it is repeated with what was found before.
constexpr std::uint32_t runs = 3;

/// Errors are judged beside a place's own light, but for the darkest ones: each place's points count about the same.
std::vector<LitPoint> weighed(std::vector<std::vector<LitPoint>>& places) {
    const auto sum = [](const std::vector<LitPoint>& points) {
        float total = 0.0f;
        for (const LitPoint& point : points) total += point.weight;
        return total;
    };
    float mean = 0.0f;
    for (const auto& points : places) mean += sum(points) / static_cast<float>(places.size());
    std::vector<LitPoint> result;
    for (auto& points : places) {
        const float scale = 1.0f / (sum(points) + mean);
        for (LitPoint& point : points) {
            point.weight *= scale;
            result.push_back(point);
        }
    }
    return result;
}

}  // namespace

void learn_light_paths(TransportWorld& world, std::size_t places, const std::function<void(std::size_t, std::uint32_t, std::vector<LitPoint>&)>& trace) {
    if (places == 0) return;
    const Bounds bounds = world.scene.bounds();
    const auto paths = static_cast<std::uint32_t>(std::clamp(paths_per_run / places, std::size_t{1}, most_paths_per_place));
    std::vector<char> which = world.casts;
    for (std::size_t i = 0; i < which.size(); ++i) which[i] = which[i] != 0 && (world.settings.occlusion || world.bounces[i] != 0) ? 1 : 0;
    world.light_paths = LightPaths::everywhere(world.lights, bounds, which);
    for (std::uint32_t run = 0; run < runs; ++run) {
        std::vector<std::vector<LitPoint>> found(places);
        tbb::parallel_for(std::size_t{0}, places, [&](std::size_t place) {
            for (std::uint32_t number = run * paths; number < (run + 1) * paths; ++number) trace(place, number, found[place]);
        });
        world.light_paths = LightPaths(world.lights, bounds, weighed(found));
    }
}

}  // namespace sl
