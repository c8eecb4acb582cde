// SPDX-License-Identifier: MIT
#include "engine/render/passes/exposure.h"

#include <cmath>

#include "shared/exposure.h"

namespace sl {

namespace {

/// Of the way to another exposure, what is left after a second.
constexpr float left_after_a_second = 0.1f;
constexpr float least_ev = -2.0f, greatest_ev = 17.0f;

/// Of a step that goes this share of its way.
ExposureParams params_of(const RenderScene::View& view, float share) { return {.adapt = vec4(share, view.ev100, least_ev, greatest_ev)}; }

}  // namespace

BufferId adapted_exposure(const FrameInput& frame, ImageId hdr) {
    const BufferId exposure = frame.graph.persistent_buffer(adapted_ev_buffer, sizeof(float));
    const bool first = frame.graph.needs_redraw(exposure, 0, 1);
    const ExposureParams params = params_of(*frame.scene.view, first ? 1.0f : 1.0f - std::pow(left_after_a_second, frame.seconds));
    auto pass = frame.graph.compute("exposure", "passes/exposure.comp");
    pass.params("Params", params).read("hdr", hdr).dispatch(1);
    return pass.write_storage("Exposure", exposure);
}

float exposure_for(const RenderScene::View& view, const Image& radiance) {
    if (!view.auto_exposure) return view.exposure();
    vec2 sum(0.0f);
    for (std::uint32_t y = 0; y < metered_points; ++y) {
        for (std::uint32_t x = 0; x < metered_points; ++x) {
            const vec2 at = (vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) / static_cast<float>(metered_points);
            const uvec2 texel(at * vec2(static_cast<float>(radiance.width), static_cast<float>(radiance.height)));
            const float* pixel = radiance.pixel(texel.x, texel.y);
            const float light = luminance({pixel[0], pixel[1], pixel[2]});
            const float weight = metering_weight(at, light);
            if (weight > 0.0f) sum += weight * vec2(std::log2(light), 1.0f);
        }
    }
    return sum.y > 0.0f ? exposure_of(adapted_ev(sum.x / sum.y, params_of(view, 1.0f))) : view.exposure();
}

}  // namespace sl
