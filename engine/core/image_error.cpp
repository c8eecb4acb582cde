// SPDX-License-Identifier: MIT
#include "engine/core/image_error.h"

#include <cmath>
#include <limits>

#include "engine/core/check.h"

namespace sl {

double nrmse(const Image& image, const Image& reference, const std::vector<float>& mask) {
    CHECK(image.width == reference.width && image.height == reference.height, "{}x{} against {}x{}", image.width, image.height,
          reference.width, reference.height);
    double squares = 0.0, sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i) {
        if (!mask.empty() && mask[i] == 0.0f) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const double r = reference.data[i * reference.channels + c];
            const double d = image.data[i * image.channels + c] - r;
            squares += d * d;
            sum += r;
            count += 1.0;
        }
    }
    if (squares == 0.0) return 0.0;
    return sum > 0.0 ? std::sqrt(squares / count) / (sum / count) : std::numeric_limits<double>::infinity();
}

}  // namespace sl
