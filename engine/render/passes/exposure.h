// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/frame_input.h"

namespace sl {

/// Steps the EV at which the picture asks to be exposed (one float), as eyes adapt; the first picture gets it at once.
BufferId adapted_exposure(const FrameInput& frame, ImageId hdr);

}  // namespace sl
