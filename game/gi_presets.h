// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sl {

/// Settings of a method that a run of `secondlight bench gi --write-presets` chose, not a person.
struct GiPreset {
    std::string method, step;           ///< "rsm_disc", "medium"
    std::vector<std::string> settings;  ///< "field=value"
    double gi_ms = 0.0, nrmse = 0.0;    ///< as that run measured
};

/// All of game/gi_presets.json. Throws Error naming the file and what is wrong.
std::vector<GiPreset> gi_presets();

}  // namespace sl
