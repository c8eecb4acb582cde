// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

namespace sl {

/// Makes a scene file of one version one of the next; the number itself is counted for it. The file may hold anything: what
/// a step does not know it leaves alone, and the reader says what is wrong.
using SceneUpgrade = void (*)(nlohmann::json& file);

/// The first makes a file of version 1 one of version 2, and so on. A step that has been published never changes.
inline constexpr std::array<SceneUpgrade, 0> scene_upgrades{};
inline constexpr int scene_version = 1 + static_cast<int>(scene_upgrades.size());

/// Makes a file of any known version one of the newest. Throws Error beginning with `shown`, the file's name, where it is no
/// scene or newer than that.
void upgrade_scene(nlohmann::json& file, std::string_view shown, std::span<const SceneUpgrade> upgrades);

}  // namespace sl
