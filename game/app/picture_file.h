// SPDX-License-Identifier: MIT
#pragma once

#include "editor/picture_tab.h"

namespace sl {

/// Writes the last frame into the folder out, under the first free number, and returns where. An EXR needs a
/// frame that was told to keep its layers (want_linear_layers). Throws Error or a file system's exception.
std::filesystem::path save_frame(const Renderer& renderer, const FrameOutput& images, PictureFormat format);

}  // namespace sl
