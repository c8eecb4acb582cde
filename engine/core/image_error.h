// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"

namespace sl {

/// Root mean square difference over the reference's mean, over the first three channels of pixels where `mask` is not
/// zero (all, where it is empty; it has one value per pixel). 0 for two equal images, infinite for a black reference.
double nrmse(const Image& image, const Image& reference, const std::vector<float>& mask);

}  // namespace sl
