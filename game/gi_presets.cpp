// SPDX-License-Identifier: MIT
#include "game/gi_presets.h"

#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/json_text.h"
#include "engine/core/text_file.h"
#include "engine/render/data_folder.h"

namespace sl {

std::vector<GiPreset> gi_presets() {
    const auto file = data_folder() / "game/gi_presets.json";
    const nlohmann::json json = parse_json(read_text_file(file, 1u << 20), file.string());
    std::vector<GiPreset> presets;
    try {
        for (const auto& [method, steps] : json.at("methods").items()) {
            for (const auto& [step, preset] : steps.items()) {
                GiPreset one{.method = method, .step = step, .settings = {}, .gi_ms = preset.at("gi_ms"), .nrmse = preset.at("nrmse")};
                for (const auto& [field, value] : preset.at("settings").items()) one.settings.push_back(field + "=" + value.get<std::string>());
                presets.push_back(std::move(one));
            }
        }
    } catch (const nlohmann::json::exception& error) {
        fail("{}: it is no presets file ({})", file.string(), error.what());
    }
    return presets;
}

}  // namespace sl
