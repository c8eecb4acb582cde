// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/scene/render_scene.h"
#include "shared/frame.h"

namespace sl {

/// Fills the block that all passes read. `view` must be there.
FrameParams frame_params(const RenderScene& scene, std::uint32_t width, std::uint32_t height, std::uint32_t frame_index);

}  // namespace sl
