// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "engine/measure/flicker.h"
#include "game/session.h"

namespace sl {

/// A camera's path from where the scene has it: sideways and turning, the same for all who go along it.
struct CameraPath {
    std::string scene;
    uvec2 size{0};
    std::uint32_t frames = 0;
};

/// Is told how many frames are done.
using TellFrames = std::function<void(std::uint32_t)>;

/// Irradiance of a method along a path, as a window shows it: the first frame is complete, each other has the time of one.
/// Throws Error where the method makes none.
std::vector<PathFrame> drawn_along(const CameraPath& path, const std::string& gi, const std::vector<std::string>& sets, const TellFrames& tell);

/// The path-traced truth along a path, with its errors; no two frames share random numbers.
std::vector<PathFrame> traced_along(const CameraPath& path, std::uint32_t samples, const TellFrames& tell);

}  // namespace sl
