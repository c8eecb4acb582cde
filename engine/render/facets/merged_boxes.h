// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/core/math.h"

namespace sl {

/// Half the surface of a box, m².
float half_surface(const Bounds& box);

/// Boxes round all of these: where some touch, as few as hold little else, and no more than `most`. None may be empty.
std::vector<Bounds> merged_boxes(std::vector<Bounds> boxes, std::size_t most);

}  // namespace sl
