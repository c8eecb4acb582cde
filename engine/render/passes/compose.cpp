// SPDX-License-Identifier: MIT
#include "engine/render/passes/compose.h"

#include <cmath>

#include "shared/exposure.h"

namespace sl {

ImageId compose(const FrameInput& frame, const GBuffer& gbuffer, ImageId direct, ImageId irradiance) {
    auto pass = frame.graph.fullscreen("compose", "passes/compose.frag");
    pass.params("Frame", frame.params)
        .read("depth", gbuffer.depth)
        .read("albedo", gbuffer.albedo)
        .read("material", gbuffer.material)
        .read("direct", direct)
        .read("irradiance", irradiance);
    return pass.create("hdr", frame.screen(Format::rgba32f));
}

namespace {

/// Of the way to another exposure, what is left after a second.
constexpr float left_after_a_second = 0.1f;
constexpr float least_ev = -2.0f, greatest_ev = 17.0f;

/// Steps the exposure that the picture asks for; the first picture gets it at once.
BufferId adapted_exposure(const FrameInput& frame, ImageId hdr) {
    const BufferId exposure = frame.graph.persistent_buffer("exposure", sizeof(float));
    const bool first = frame.graph.needs_redraw(exposure, 0, 1);
    ExposureParams params{};
    params.adapt = vec4(first ? 1.0f : 1.0f - std::pow(left_after_a_second, frame.seconds), frame.scene.view->ev100, least_ev, greatest_ev);
    auto pass = frame.graph.compute("exposure", "passes/exposure.comp");
    pass.params("Params", params).read("hdr", hdr).dispatch(1);
    return pass.write_storage("Exposure", exposure);
}

}  // namespace

ImageId tonemap(const FrameInput& frame, ImageId hdr) {
    if (frame.scene.view->auto_exposure) {
        const BufferId exposure = adapted_exposure(frame, hdr);
        auto pass = frame.graph.fullscreen("tonemap", "passes/tonemap_adapted.frag");
        pass.storage("Exposure", exposure).read("hdr", hdr);
        return pass.create("ldr", frame.screen(Format::rgba8));
    }
    auto pass = frame.graph.fullscreen("tonemap", "passes/tonemap.frag");
    pass.params("Frame", frame.params).read("hdr", hdr);
    return pass.create("ldr", frame.screen(Format::rgba8));
}

ImageId antialias(const FrameInput& frame, ImageId ldr) {
    auto pass = frame.graph.fullscreen("antialias", "passes/antialias.frag");
    pass.read("ldr", ldr, Sampling::linear);
    return pass.create("final", frame.screen(Format::rgba8));
}

}  // namespace sl
