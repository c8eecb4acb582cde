// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace sl {

/// The parts of a frame, run in this order. Recorded commands are applied at the end of each.
enum class Stage {
    input,     ///< window and devices into resources
    simulate,  ///< game rules
    derive,    ///< what follows from what people and rules set: world transforms, bounds
    mesh,      ///< geometry from changed data
    extract,   ///< the renderer's plain arrays
    present,   ///< drawing
};

inline constexpr std::array<std::string_view, 6> stage_names{"input", "simulate", "derive",
                                                             "mesh",  "extract",  "present"};
inline constexpr std::size_t stage_count = stage_names.size();

/// As `capture --print-schedule` shows it.
constexpr std::string_view stage_name(Stage stage) {
    return stage_names[static_cast<std::size_t>(stage)];
}

}  // namespace sl
