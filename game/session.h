// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/ecs/active_camera.h"
#include "engine/ecs/app.h"
#include "engine/ecs/components.h"
#include "engine/ecs/systems/load_models.h"

namespace sl {

/// Which scene a command works on, and what is changed in it first.
struct SceneChoice {
    std::string scene = "outdoor";   ///< a name from scene_names(), or the path of a scene file or model
    std::string gi;                  ///< "method" or "method:preset"; empty keeps the scene's own
    std::vector<std::string> sets;   ///< "component.field=value", applied in order after `gi`
    std::string camera = {};         ///< its name, or its number from 0; empty keeps the scene's own, of a model the first

    /// Whether it says what indirect light is like.
    bool chooses_light() const;
};

/// An engine with the game's plugins and an empty world.
App empty_game();

/// A scene on its way, in an engine with the game's plugins. It is there at once, but for models, whose files are read on threads
/// of their own.
class SceneOpening {
  public:
    /// Throws Error for what is wrong already.
    explicit SceneOpening(SceneChoice choice);

    /// Whether it is a model, or has any.
    bool shows_models();

    /// Takes in what has been read, or waits for it; whether the scene is there, its systems run once. Throws Error where it
    /// cannot be shown.
    bool advance(bool wait);
    std::vector<ModelBeingRead> being_read() const { return app.world.resource<ModelLibrary>().being_read(); }

    App app;

  private:
    void apply_choice();

    SceneChoice choice_;
    bool is_model_;
};

/// Lets models of all scenes that are opened from now on name files outside their own folder: whoever runs the program says so.
void allow_outside_files(bool allowed);

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
