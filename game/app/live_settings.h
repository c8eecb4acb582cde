// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/window.h"
#include "engine/ecs/app.h"
#include "game/settings/settings_file.h"

namespace sl {

/// The player's settings in a running game: what changes is applied at once, and written to the file.
class LiveSettings {
  public:
    explicit LiveSettings(std::filesystem::path path);

    /// Whoever changes them here needs do no more.
    UserSettings& values() { return file_.settings; }
    const UserSettings& values() const { return file_.settings; }

    /// Applies all that concerns a world to one just opened; indirect light only where it was not chosen by other means. Tells
    /// what was wrong with the file.
    void enter(App& app, bool with_light);
    /// Applies what has changed. With `settled` false a widget is still being moved, and the file is written later. Call once a
    /// frame, outside the drawing of it.
    void follow(App& app, Window& window, bool settled);
    /// Of the settings, or what a command line gave until a player chooses another.
    double render_scale() const { return render_scale_.value_or(values().picture.render_scale); }
    void override_render_scale(std::optional<double> scale) { render_scale_ = scale; }

  private:
    void apply(App& app, Window& window);
    void save(App& app);

    SettingsFile file_;
    UserSettings applied_;
    std::optional<double> render_scale_;
    bool unsaved_ = false;
};

}  // namespace sl
