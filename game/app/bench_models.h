// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "game/app/commands.h"
#include "game/app/find_models.h"

namespace sl {

/// What `secondlight bench models` is asked.
struct ModelsFlags {
    std::vector<std::string> paths;
    std::string size = "640x360", reference_size = "160x90", gi;
    std::string folder = "out/bench_models";
    std::uint32_t spp = 256;
    double minutes = 10.0;
};

/// Figures of all models as a table in Markdown. A row is {"model", "triangles", "load_s", "capture_s", "peak_mb", "nrmse", "bias",
/// "reference_noise", "flip"}; where it has an "error", figures may be missing.
std::string models_table(const nlohmann::json& rows);

/// Measures each model in processes of its own, and writes report.json, report.md and the pictures below the flags' folder.
/// Returns 1 where a model could not be measured, else 0. Throws Error for wrong flags.
int run_bench_models(const GlobalFlags& global, const ModelsFlags& flags);

}  // namespace sl
