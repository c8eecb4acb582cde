// SPDX-License-Identifier: MIT
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/text_file.h"
#include "engine/measure/spread.h"
#include "engine/render/trace/path_tracer.h"
#include "engine/render/scene/extract.h"
#include "game/app/commands.h"

namespace sl {

namespace {

struct RayFlags {
    SceneChoice choice;
    std::string size = "160x90";
    std::uint32_t spp = 16, rounds = 5;
    std::string json;
};

double seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Visit>
void for_pixels(uvec2 size, Visit&& visit) {
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, size.x * size.y, 32), [&](const auto& range) {
        for (std::uint32_t i = range.begin(); i < range.end(); ++i) visit(uvec2(i % size.x, i / size.x), i);
    });
}

/// Full transport against the intersections of the same rays alone, taking turns; both on all processors.
int run_rays(const RayFlags& flags) {
    const uvec2 size = parse_size(flags.size);
    App app = open_scene(flags.choice);
    RenderScene scene;
    extract(app.world, scene);
    if (!scene.view) fail("scene '{}' has no active camera to look from", flags.choice.scene);
    const PathTracer tracer(scene, size, {});
    std::vector<std::vector<TracedRay>> recorded(std::size_t{size.x} * size.y);
    for_pixels(size, [&](uvec2 pixel, std::uint32_t i) {
        for (std::uint32_t s = 0; s < flags.spp; ++s) tracer.sample_recorded(pixel, s, recorded[i]);
    });
    std::size_t rays = 0, shadow = 0;
    for (const auto& list : recorded) {
        rays += list.size();
        for (const TracedRay& ray : list) shadow += ray.shadow ? 1 : 0;
    }
    std::atomic<std::uint64_t> sink = 0;  // what is computed must be used
    std::vector<double> full, bare, ratio;
    for (std::uint32_t round = 0; round < flags.rounds; ++round) {
        full.push_back(static_cast<double>(rays) * 1e-6 / seconds_of([&] {
            for_pixels(size, [&](uvec2 pixel, std::uint32_t) {
                std::uint64_t sum = 0;
                for (std::uint32_t s = 0; s < flags.spp; ++s) sum += tracer.sample(pixel, s).rays;
                sink += sum;
            });
        }));
        bare.push_back(static_cast<double>(rays) * 1e-6 / seconds_of([&] {
            for_pixels(size, [&](uvec2, std::uint32_t i) {
                std::uint64_t hits = 0;
                for (const TracedRay& ray : recorded[i]) hits += ray.shadow ? tracer.scene().occluded(ray.ray) : tracer.scene().intersect(ray.ray).has_value();
                sink += hits;
            });
        }));
        ratio.push_back(bare.back() / full.back());
    }
    const auto row = [](const char* name, const std::vector<double>& values) {
        const Spread s = spread_of(values);
        fmt::print("{:<34}{:>8.2f}  ({:.2f} to {:.2f})\n", name, s.median, s.low, s.high);
    };
    fmt::print("{} · {} triangles · {}x{} · {} samples a pixel · {:.1f} million rays, {:.0f} % of them shadow rays\n", flags.choice.scene, tracer.scene().triangles(), size.x,
               size.y, flags.spp, static_cast<double>(rays) * 1e-6, 100.0 * static_cast<double>(shadow) / static_cast<double>(rays));
    row("path tracing, million rays / s", full);
    row("the same rays alone, million / s", bare);
    row("ratio", ratio);
    if (!flags.json.empty()) {
        const auto spread = [](const std::vector<double>& values) {
            const Spread s = spread_of(values);
            return nlohmann::json{{"median", s.median}, {"min", s.low}, {"max", s.high}};
        };
        const nlohmann::json all{{"scene", flags.choice.scene}, {"triangles", tracer.scene().triangles()}, {"rays", rays}, {"shadow_rays", shadow},
                                 {"path_tracing", spread(full)}, {"rays_alone", spread(bare)}, {"ratio", spread(ratio)}};
        write_text_file(flags.json, all.dump(2) + "\n");
    }
    return 0;
}

}  // namespace

void add_bench_rays_command(const Flags& bench) {
    auto flags = std::make_shared<RayFlags>();
    const Flags command = bench.command("rays", "Path tracing against the bare intersection rate of the same rays");
    add_scene_flags(command, flags->choice);
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    command.add("--spp", flags->spp, "Samples per pixel").within(1, 4096);
    command.add("--rounds", flags->rounds, "Times that both take turns").within(1, 1000);
    command.add("--json", flags->json, "Also write the figures into this file");
    command.runs([flags] { return run_rays(*flags); });
}

}  // namespace sl
