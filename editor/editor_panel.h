// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "engine/ecs/app.h"
#include "engine/render/renderer.h"

namespace sl {

/// What the editor remembers between frames.
struct EditorState {
    bool open = false;
    float scale = 1.0f;                             ///< of widgets, as in ImguiLayer
    std::string filter;                             ///< shows entities whose name contains it
    std::map<std::string, double> smoothed_passes;  ///< ms by pass
};

/// The whole panel, at the right edge: the scene and what its picture costs. Draws nothing while closed. Its
/// widgets come from visit_fields alone. Between begin and draw of an ImguiLayer, after the frame was
/// rendered.
void editor_panel(App& app, Renderer& renderer, EditorState& state);

/// GI of the active camera, lights, camera, then all named entities with their components. Inside a window.
void scene_sections(App& app, EditorState& state);
/// GPU time per pass, and the frame's table of passes. Inside a window.
void frame_sections(Renderer& renderer, EditorState& state);

}  // namespace sl
