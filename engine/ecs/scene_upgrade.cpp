// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_upgrade.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/ecs/scene_document.h"

namespace sl {

void upgrade_scene(nlohmann::json& file, std::string_view shown, std::span<const SceneUpgrade> upgrades) {
    const std::size_t newest = 1 + upgrades.size();
    if (!file.is_object() || !file.contains(scene_key::version)) {
        fail("{}: is no scene: it must begin with {{\"{}\": {}, …", shown, scene_key::version, newest);
    }
    nlohmann::json& version = file[std::string(scene_key::version)];
    const double number = version.is_number() ? version.get<double>() : 0.0;
    if (number < 1.0 || std::trunc(number) != number) {
        fail("{}: /{}: is {}, must be a whole number, at least 1", shown, scene_key::version, for_message(version.dump()));
    }
    if (number > static_cast<double>(newest)) {
        fail("{}: /{}: is {}, but this program knows versions up to {}; open the file with a newer one", shown,
             scene_key::version, for_message(version.dump()), newest);
    }
    for (auto from = static_cast<std::size_t>(number); from < newest; ++from) upgrades[from - 1](file);
    file[std::string(scene_key::version)] = newest;
}

}  // namespace sl
