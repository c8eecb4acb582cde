// SPDX-License-Identifier: MIT
#include "game/settings/scene_defaults.h"

#include <algorithm>

#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "engine/ecs/set_field.h"
#include "game/gi_presets.h"
#include "game/session.h"

namespace sl {

namespace {

bool has_preset(std::string_view method, std::string_view preset) {
    return std::ranges::any_of(gi_presets(), [&](const GiPreset& one) { return one.method == method && one.step == preset; });
}

void restore_light(World& world) {
    for (const SceneDefaults::View& view : world.resource<SceneDefaults>().views) {
        if (!world.alive(view.camera)) continue;
        if (view.gi) {
            world.add(view.camera, *view.gi);
        } else {
            world.remove<GiSettings>(view.camera);
        }
    }
}

}  // namespace

void keep_scene_defaults(App& app) {
    SceneDefaults defaults;
    for (auto [entity, camera] : Query<const Camera>(app.world)) {
        const auto* gi = app.world.find<GiSettings>(entity);
        defaults.views.push_back({entity, camera.fov_y, gi != nullptr ? std::optional(*gi) : std::nullopt});
    }
    app.world.add_resource(std::move(defaults));
}

void apply_field_of_view(App& app, const PictureSettings& picture) {
    for (const SceneDefaults::View& view : app.world.resource<SceneDefaults>().views) {
        if (auto* camera = app.world.alive(view.camera) ? app.world.find<Camera>(view.camera) : nullptr) {
            camera->fov_y = picture.scene_field_of_view ? view.fov_y : picture.field_of_view;
        }
    }
}

void apply_light(App& app, const LightSettings& light) {
    if (light.method == 0) return restore_light(app.world);
    const std::string method(gi_method_names()[light.method - 1]);
    const std::string_view preset = preset_name(light);
    choose_gi(app, has_preset(method, preset) ? fmt::format("{}:{}", method, preset) : method);
    if (method != Facets::name || !active_camera(app.world)) return;
    set_field(app.world, app.registry(), fmt::format("gi.quality={}", light.quality));
    set_field(app.world, app.registry(), fmt::format("gi.budget_ms={}", light.budget_ms));
}

}  // namespace sl
