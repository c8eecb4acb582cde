// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/image.h"

namespace sl {

/// How far a linear image is from its reference. All ratios are fractions: 0.05 is 5 %.
struct ErrorMetrics {
    double rel_mse = 0.0;  ///< mean of (x−r)² / (r² + ε), ε = (1 % of the mean of r)²; over pixels and channels
    double nrmse = 0.0;    ///< √(mean of (x−r)²) / mean of r; over pixels and channels
    double p95 = 0.0;      ///< 95 % of the pixels have at most this relative error (see relative_error_map)
    double bias = 0.0;     ///< mean of (x−r) / mean of r, signed: positive where the image is too bright
    std::size_t pixels = 0;  ///< how many were compared
};

/// Compares the first three channels of two images of one size. `mask` is empty or has one value per pixel, and pixels
/// where it is 0 are ignored, whatever they hold. A reference whose mean is not positive counts as black, with mean 0:
/// an error of 0 over 0 is 0, and any other over 0 infinite. Throws Error when no pixel is left to compare, or where
/// one is not finite (see check_finite).
ErrorMetrics image_errors(const Image& image, const Image& reference, const std::vector<float>& mask);

/// One channel: |x−r| / (|r| + 1 % of the mean of r) on Rec. 709 luminance; 0 where masked. The small addend keeps a
/// dark pixel's error from being infinite; on a black reference, 0/0 is 0 and the rest infinite.
Image relative_error_map(const Image& image, const Image& reference, const std::vector<float>& mask);

/// Throws Error when one of the first three channels holds an infinity or no number in a pixel that `mask` leaves: says
/// `name`, how many pixels, and where the first one is (column and row from 0 at the top left).
void check_finite(const std::string& name, const Image& image, const std::vector<float>& mask);

/// Rec. 709 luminance of a pixel's first three channels; pixels are counted row by row.
double luminance_at(const Image& image, std::size_t pixel);

/// Mean of a one-channel image over the pixels where `mask` is not 0 (all, where it is empty); 0 when there are none.
double masked_mean(const Image& map, const std::vector<float>& mask);

}  // namespace sl
