// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace sl {

/// The frame's time, a resource. A capture steps it by a fixed amount; a window by what has passed.
struct FrameClock {
    std::uint64_t frame = 0;
    double seconds = 0.0;  ///< since the start
    double step = 1.0 / 60.0;

    void advance() {
        ++frame;
        seconds += step;
    }
};

}  // namespace sl
