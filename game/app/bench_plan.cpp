// SPDX-License-Identifier: MIT
#include "game/app/bench_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sl {

std::string BenchCandidate::label() const { return sets.empty() ? method : fmt::format("{} {}", method, fmt::join(sets, " ")); }

std::vector<std::string> BenchCandidate::assignments() const {
    std::vector<std::string> result;
    for (const std::string& set : sets) result.push_back("gi." + set);
    return result;
}

BenchPlan quick_plan() {
    return {.size = {160, 90},
            .scenes = {"outdoor", "indoor", "cornell"},
            .candidates = {{"off", {}},
                           {"rsm_grid", {"step=4"}},
                           {"rsm_disc", {"rsm_size=128", "samples=64"}},
                           {"rsm_disc", {"rsm_size=128", "samples=256"}},
                           {"rsm_exact", {"rsm_size=32"}},
                           {"facets", {"quality=0", "noise=0.3"}}},
            .rounds = 5,
            .spp = 128};
}

BenchPlan full_plan() {
    BenchPlan plan;
    plan.scenes = {"outdoor", "indoor", "hills", "night", "cornell", "plates"};
    plan.candidates.push_back({"off", {}});
    // Each method first as it is shipped, which is what people get.
    plan.candidates.push_back({"rsm_grid", {}});
    plan.candidates.push_back({"rsm_grid", {"preset=paper-artefact"}});
    for (const int step : {8, 4, 2}) plan.candidates.push_back({"rsm_grid", {fmt::format("step={}", step)}});
    plan.candidates.push_back({"rsm_disc", {}});
    for (const int samples : {16, 64, 256, 1024}) plan.candidates.push_back({"rsm_disc", {"rsm_size=128", fmt::format("samples={}", samples)}});
    for (const int spacing : {16, 4}) plan.candidates.push_back({"rsm_disc", {"rsm_size=128", "samples=256", fmt::format("low_resolution={}", spacing)}});
    for (const char* radius : {"0.25", "1"}) plan.candidates.push_back({"rsm_disc", {"rsm_size=128", "samples=256", fmt::format("radius={}", radius)}});
    plan.candidates.push_back({"rsm_disc", {"rsm_size=128", "samples=64", "interpolate=false"}});
    plan.candidates.push_back({"rsm_disc", {"rsm_size=128", "samples=64", "interpolate=false", "rotate=true"}});
    for (const int size : {16, 32, 64}) plan.candidates.push_back({"rsm_exact", {fmt::format("rsm_size={}", size)}});
    plan.candidates.push_back({"facets", {}});
    for (const char* quality : {"0", "0.75"}) plan.candidates.push_back({"facets", {fmt::format("quality={}", quality)}});
    // What it makes of one bounce, beside the truth of one.
    plan.candidates.push_back({"facets", {"bounces=1"}});
    return plan;
}

}  // namespace sl
