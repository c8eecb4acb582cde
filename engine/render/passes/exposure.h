// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"
#include "engine/render/passes/frame_input.h"

namespace sl {

/// The persistent buffer that holds the EV.
inline constexpr const char* adapted_ev_buffer = "exposure";

/// Steps the EV at which the picture asks to be exposed (one float), as eyes adapt; the first picture gets it at once.
BufferId adapted_exposure(const FrameInput& frame, ImageId hdr);

/// What a view multiplies nit with, once its eyes have adapted to a picture of linear radiance where they do that: as the pass
/// that shows it does.
float exposure_for(const RenderScene::View& view, const Image& radiance);

}  // namespace sl
