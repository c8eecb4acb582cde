// SPDX-License-Identifier: MIT
#include "editor/compare/compare_figures.h"

#include "engine/measure/flip.h"
#include "shared/tonemap.h"

namespace sl {

namespace {

std::vector<float> surfaces_of(const Image& depth) {
    std::vector<float> mask(depth.data.size());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = depth.data[i] > 0.0f ? 1.0f : 0.0f;
    return mask;
}

}  // namespace

Image shown(const Image& radiance, float exposure) {
    Image result(radiance.width, radiance.height, 3);
    for (std::size_t i = 0; i < std::size_t{radiance.width} * radiance.height; ++i) {
        const float* from = &radiance.data[i * radiance.channels];
        const vec3 pixel = display_from_radiance(vec3(from[0], from[1], from[2]), exposure);
        for (std::size_t c = 0; c < 3; ++c) result.data[3 * i + c] = pixel[static_cast<int>(c)];
    }
    return result;
}

CompareFigures compare_figures(const CompareInput& input) {
    const Image& truth = input.reference->layer("irradiance");
    const std::vector<float> mask = surfaces_of(input.reference->layer("depth"));
    CompareFigures figures;
    figures.irradiance = image_errors(input.irradiance, truth, mask);
    figures.error = relative_error_map(input.irradiance, truth, mask);
    figures.flip = flip(input.picture, shown(input.reference->layer(""), input.exposure)).mean;
    figures.truth_noise = input.reference->noise;
    figures.samples = input.reference->samples;
    return figures;
}

void CompareWorker::begin(CompareInput input) {
    forgotten_ = false;
    future_ = std::async(std::launch::async, [input = std::move(input)] { return compare_figures(input); });
}

const std::optional<CompareFigures>& CompareWorker::figures() {
    if (!future_.valid() || future_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return figures_;
    try {
        CompareFigures made = future_.get();
        if (!forgotten_) figures_ = std::move(made);
    } catch (const std::exception& error) {
        if (!forgotten_) problem_ = error.what();
    }
    return figures_;
}

}  // namespace sl
