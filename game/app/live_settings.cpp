// SPDX-License-Identifier: MIT
#include "game/app/live_settings.h"

#include "engine/core/log.h"
#include "game/notice.h"
#include "game/settings/scene_defaults.h"

namespace sl {

namespace {

constexpr double notice_seconds = 20.0;

void tell(App& app, const std::string& sentence) {
    log::warn("{}", sentence);
    app.world.resource<Notice>().say(sentence, notice_seconds);
}

void try_light(App& app, const LightSettings& light) {
    try {
        apply_light(app, light);
    } catch (const std::exception& error) {
        tell(app, error.what());
    }
}

}  // namespace

LiveSettings::LiveSettings(std::filesystem::path path) : file_(std::move(path)), applied_(file_.settings) {}

void LiveSettings::enter(App& app, bool with_light) {
    app.world.add_resource(values());
    keep_scene_defaults(app);
    apply_field_of_view(app, values().picture);
    if (with_light) try_light(app, values().light);
    for (const std::string& warning : file_.warnings()) tell(app, warning);
    if (!file_.fault().empty()) tell(app, file_.fault() + "\nThe usual settings are in use.");
}

void LiveSettings::follow(App& app, Window& window, bool settled) {
    if (values() != applied_) {
        apply(app, window);
        applied_ = values();
        unsaved_ = true;
    }
    if (unsaved_ && settled) save(app);
}

void LiveSettings::apply(App& app, Window& window) {
    const PictureSettings &before = applied_.picture, &now = values().picture;
    app.world.resource<UserSettings>() = values();
    if (now.vsync != before.vsync) window.set_vsync(now.vsync);
    if (now.fullscreen != before.fullscreen && now.fullscreen != window.fullscreen()) window.toggle_fullscreen();
    if (now.render_scale != before.render_scale) render_scale_.reset();
    if (now != before) apply_field_of_view(app, now);
    if (values().light != applied_.light) try_light(app, values().light);
}

void LiveSettings::save(App& app) {
    unsaved_ = false;
    try {
        const std::filesystem::path kept = file_.save();
        if (!kept.empty()) tell(app, fmt::format("The settings that could not be read are kept in {}", kept.string()));
    } catch (const std::exception& error) {
        tell(app, fmt::format("the settings are not saved: {}", error.what()));
    }
}

}  // namespace sl
