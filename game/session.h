// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/ecs/active_camera.h"
#include "engine/ecs/app.h"
#include "engine/ecs/components.h"

namespace sl {

/// Which scene a command works on, and what is changed in it first.
struct SceneChoice {
    std::string scene = "outdoor";   ///< a name from scene_names(), or the path of a scene file or model
    std::string gi;                  ///< "method" or "method:preset"; empty keeps the scene's own
    std::vector<std::string> sets;   ///< "component.field=value", applied in order after `gi`
};

/// An engine with the game's plugins, holding the chosen scene, its systems run once. Throws Error.
App open_scene(const SceneChoice& choice);

/// Puts a GI method on the active camera and on all that have one: "method" or "method:preset". Throws Error naming the choices.
void choose_gi(App& app, const std::string& gi);

/// Side of the lights' maps that its method asks for, texels; 0 for methods without maps.
std::uint32_t map_size(const GiSettings& settings);

/// Names and one-line descriptions of the scenes that come with the game.
struct SceneListing {
    std::string name, description;
};
std::vector<SceneListing> scene_names();
/// The file of a scene by name, or the path itself. Throws Error naming the scenes.
std::filesystem::path scene_path(const std::string& scene);

}  // namespace sl
