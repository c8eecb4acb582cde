// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/render/renderer.h"

namespace sl {

/// Name of the image in which rsm_disc marks the pixels that it gathered in full.
inline constexpr const char* refined_image = "refined";

/// Share of the last frame's pixels that were gathered in full. Nothing where its method marks none. The image
/// must have been wanted; reading it waits for the frame.
std::optional<double> refined_share(const Renderer& renderer);

}  // namespace sl
