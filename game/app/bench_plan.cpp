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
                           {"rsm_exact", {"rsm_size=32"}}},
            .rounds = 5,
            .spp = 128};
}

BenchPlan full_plan() {
    BenchPlan plan;
    plan.scenes = {"outdoor", "indoor", "hills", "night", "cornell", "plates"};
    plan.candidates.push_back({"off", {}});
    for (const int step : {8, 4, 2}) plan.candidates.push_back({"rsm_grid", {fmt::format("step={}", step)}});
    for (const int spacing : {16, 8, 4}) {
        for (const int samples : {16, 64, 256, 1024}) {
            plan.candidates.push_back({"rsm_disc", {"rsm_size=128", fmt::format("samples={}", samples), fmt::format("low_resolution={}", spacing)}});
        }
    }
    plan.candidates.push_back({"rsm_disc", {"rsm_size=128", "samples=64", "interpolate=false"}});
    for (const int size : {16, 32, 64}) plan.candidates.push_back({"rsm_exact", {fmt::format("rsm_size={}", size)}});
    return plan;
}

}  // namespace sl
