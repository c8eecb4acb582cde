// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "engine/core/image.h"
#include "engine/measure/flip.h"
#include "engine/measure/metrics.h"

namespace sl {

/// What `secondlight compare` is asked.
struct CompareFlags {
    std::filesystem::path image, reference;
    std::optional<std::string> layer, reference_layer;  ///< "" is the colour layer without a name
    bool no_mask = false;
    std::optional<double> ev100;
    float pixels_per_degree = usual_pixels_per_degree;
    std::string heat_map, heat = "relative";
    std::optional<double> heat_max;
    std::string json;
    std::optional<double> max_rel_mse, max_nrmse, max_p95, max_bias, max_flip;
};

/// Two images of one size, three channels each, linear, and the pixels that count.
struct ImagePair {
    Image image, reference;
    std::string image_name, reference_name;  ///< file, and layer where there are layers
    std::string layer;                       ///< of the image; empty for a picture or the unnamed layer
    std::vector<float> mask;                 ///< empty: all count
    std::size_t background_differs = 0;      ///< pixels that are background in one of the two files only
    std::optional<double> reference_noise;   ///< of a path-traced reference itself, as NRMSE; none: the file does not tell
    bool decoded = false;                    ///< from sRGB pictures: display-referred, needs no exposure
};

/// Reads what the flags name. Throws Error for files, layers or sizes that do not fit, and for pixels that count and
/// are not finite.
ImagePair load_pair(const CompareFlags& flags);

struct Comparison {
    ErrorMetrics errors;
    Flip flip;
    double ev100 = 0.0;  ///< exposure of the pictures that FLIP saw; meaningless where `decoded`
};

/// Uses no GL.
Comparison compare(const ImagePair& pair, const CompareFlags& flags);

/// The whole command: prints the figures, writes what was asked for, and returns 1 where a limit is exceeded, else 0.
/// Throws Error for bad input.
int run_compare(const CompareFlags& flags);

}  // namespace sl
