// SPDX-License-Identifier: MIT
#include "engine/render/passes/compose.h"

#include "engine/render/passes/exposure.h"

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
