// SPDX-License-Identifier: MIT
#include "engine/render/reference/reference.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <cmath>

#include "engine/core/check.h"

namespace sl {

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr double seconds_per_pass = 2.0;
constexpr std::uint32_t tile = 8;  // pixels

double since(SteadyClock::time_point start) { return std::chrono::duration<double>(SteadyClock::now() - start).count(); }

void trace_pass(const PathTracer& tracer, Film& film, const FilmBlock& block, std::atomic<std::uint64_t>& rays) {
    using Range = tbb::blocked_range2d<std::uint32_t>;
    tbb::parallel_for(Range(block.low.y, block.high.y, tile, block.low.x, block.high.x, tile), [&](const Range& range) {
        std::uint64_t traced = 0;
        for (std::uint32_t y = range.rows().begin(); y < range.rows().end(); ++y) {
            for (std::uint32_t x = range.cols().begin(); x < range.cols().end(); ++x) {
                PixelSums& sums = film.at({x, y});
                if (sums.samples == 0.0) film.first_surface({x, y}) = tracer.first_surface({x, y});
                for (std::uint32_t number = block.first; number < block.last; ++number) {
                    const PathSample sample = tracer.sample({x, y}, number);
                    traced += sample.rays;
                    sums.add(sample, number % 2 == 1);
                }
            }
        }
        rays += traced;
    });
}

/// The first sample number of the block that the film lacks.
std::uint32_t first_missing(const Film& film, const FilmBlock& block) {
    for (const FilmBlock& known : film.blocks()) {
        if (known.low == block.low && known.high == block.high && known.first <= block.first && known.last > block.first) {
            return std::min(known.last, block.last);
        }
        CHECK(!known.overlaps(block), "a film continues with another region or range of samples than it began with");
    }
    return block.first;
}

}  // namespace

ReferenceProgress trace_reference(const PathTracer& tracer, Film& film, const ReferencePlan& plan,
                                  const std::function<bool(const ReferenceProgress&)>& tell, const std::function<void()>& save) {
    const auto start = SteadyClock::now();
    auto saved = start;
    std::atomic<std::uint64_t> rays = 0;
    std::uint32_t next = first_missing(film, plan.block);
    const std::uint32_t begun = next;
    std::uint32_t per_pass = 2;  // even: both halves get as much
    ReferenceProgress progress;
    const auto refresh = [&] {
        const double asked = plan.block.last - plan.block.first;
        progress = {.samples = next - plan.block.first, .share = asked > 0.0 ? (next - plan.block.first) / asked : 1.0, .noise = film.noise(), .rays = rays, .seconds = since(start)};
        // Noise falls with the root of the samples.
        if (plan.noise > 0.0) progress.share = std::max(progress.share, std::min(1.0, std::pow(plan.noise / std::max(progress.noise, 1e-30), 2.0)));
    };
    refresh();
    bool go_on = true, saved_once = false;
    double seconds_to_save = 0.0;
    while (go_on && next < plan.block.last && !(plan.noise > 0.0 && progress.noise <= plan.noise)) {
        const auto pass_start = SteadyClock::now();
        FilmBlock pass = plan.block;
        pass.first = next;
        pass.last = std::min(plan.block.last, next + per_pass);
        trace_pass(tracer, film, pass, rays);
        film.add_block(pass);
        next = pass.last;
        if (since(pass_start) < 0.4 * seconds_per_pass) per_pass = std::min(per_pass * 2, 1024u);
        if (since(pass_start) > seconds_per_pass) per_pass = std::max(per_pass / 4 * 2, 2u);
        refresh();
        go_on = !tell || tell(progress);
        if (save && (!saved_once || since(saved) > std::max(plan.seconds_between, 20.0 * seconds_to_save))) {
            const auto before = SteadyClock::now();
            save();
            saved = SteadyClock::now();
            saved_once = true;
            seconds_to_save = since(before);
        }
    }
    if (save && next > begun) save();
    return progress;
}

Film trace_film(const RenderScene& scene, uvec2 size, const TransportSettings& settings, std::uint32_t samples) {
    Film film(size);
    const PathTracer tracer(scene, size, settings);
    trace_reference(tracer, film, {.block = {.high = size, .last = samples}}, {});
    return film;
}

}  // namespace sl
