// SPDX-License-Identifier: MIT
#include "engine/render/passes/exposure.h"

#include <cmath>

#include "shared/exposure.h"

namespace sl {

namespace {

/// Of the way to another exposure, what is left after a second.
constexpr float left_after_a_second = 0.1f;
constexpr float least_ev = -2.0f, greatest_ev = 17.0f;

}  // namespace

BufferId adapted_exposure(const FrameInput& frame, ImageId hdr) {
    const BufferId exposure = frame.graph.persistent_buffer("exposure", sizeof(float));
    const bool first = frame.graph.needs_redraw(exposure, 0, 1);
    ExposureParams params{};
    params.adapt = vec4(first ? 1.0f : 1.0f - std::pow(left_after_a_second, frame.seconds), frame.scene.view->ev100, least_ev, greatest_ev);
    auto pass = frame.graph.compute("exposure", "passes/exposure.comp");
    pass.params("Params", params).read("hdr", hdr).dispatch(1);
    return pass.write_storage("Exposure", exposure);
}

}  // namespace sl
