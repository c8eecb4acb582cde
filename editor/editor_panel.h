// SPDX-License-Identifier: MIT
#pragma once

#include "editor/compare/compare_view.h"
#include "editor/frame_tab.h"
#include "editor/light_tab.h"
#include "editor/picture_tab.h"
#include "editor/scene_tab.h"
#include "editor/see/see_view.h"
#include "engine/ecs/app.h"

namespace sl {

/// What the editor remembers between frames.
struct EditorState {
    bool open = false;
    float scale = 1.0f;  ///< of widgets, as in ImguiLayer
    EditHistory history;
    LightTab light;
    SceneTab scene;
    PictureTab picture;
    FrameTab frame;
    CompareView compare;
    SeeView see;
};

/// The whole panel, at the right edge, and lines over the picture for the chosen light. Draws nothing while
/// closed. Its widgets for components come from visit_fields alone. Between begin and draw of an ImguiLayer,
/// after the frame was rendered.
void editor_panel(App& app, const FrameReport& report, EditorState& state);

/// A click into the picture, the mouse being free and over no widget. True where it was for the panel, and not for the game.
bool click_picture(EditorState& state);

}  // namespace sl
