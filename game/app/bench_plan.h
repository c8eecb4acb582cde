// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/core/math.h"

namespace sl {

/// One way to compute indirect light: a method with some of its settings changed.
struct BenchCandidate {
    std::string method;
    std::vector<std::string> sets;  ///< "field=value" of the method

    /// "rsm_disc samples=64 low_resolution=8"
    std::string label() const;
    /// What `--set` takes.
    std::vector<std::string> assignments() const;
};

/// What `secondlight bench gi` runs.
struct BenchPlan {
    uvec2 size{320, 180};
    std::vector<std::string> scenes;
    std::vector<BenchCandidate> candidates;
    std::uint32_t rounds = 7;
    std::uint32_t spp = 1024;  ///< of the references
    /// A candidate whose frame takes longer than this is drawn once, s.
    double longest_repeated = 3.0;
};

/// About a minute, and about an hour, on two cores without a GPU.
BenchPlan quick_plan();
BenchPlan full_plan();

}  // namespace sl
