// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/frame_input.h"

namespace sl {

/// Draws whose materials read pictures are drawn by programs of their own, after the others, and only where there are any.
struct ByPictures {
    std::vector<std::uint32_t> plain, together, apart;
};
/// Divides numbers of the scene's draws.
ByPictures by_pictures(const RenderScene& scene, const std::vector<std::uint32_t>& draws);

/// Binds what shader/lib/picture_colours.glsl reads.
void read_picture_colours(PassBuilder& pass, const SceneInputs& inputs);
/// The same of shader/lib/pictured.glsl and pictured_apart.glsl.
void read_pictures(PassBuilder& pass, const SceneInputs& inputs);

}  // namespace sl
