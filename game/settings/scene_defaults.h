// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "engine/ecs/app.h"
#include "engine/ecs/components/gi_settings.h"
#include "game/settings/user_settings.h"

namespace sl {

/// How the scene wants its cameras, so that settings can be taken back; a resource.
struct SceneDefaults {
    struct View {
        Entity camera;
        float fov_y;
        std::optional<GiSettings> gi;
    };
    std::vector<View> views;
};

/// Remembers how the scene's cameras are now.
void keep_scene_defaults(App& app);

/// Give the cameras what the settings say, or give them back what the scene has. After keep_scene_defaults.
void apply_field_of_view(App& app, const PictureSettings& picture);
void apply_light(App& app, const LightSettings& light);

}  // namespace sl
