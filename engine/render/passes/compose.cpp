// SPDX-License-Identifier: MIT
#include "engine/render/passes/compose.h"

#include <algorithm>

#include "engine/render/passes/exposure.h"
#include "shared/specular_lobe.h"

namespace sl {

namespace {

/// Whether some surface is not matte.
bool has_gloss(const RenderScene& scene) {
    return std::ranges::any_of(scene.materials, [](const MaterialEntry& entry) { return entry.material.specular > 0.0f || entry.material.metallic > 0.0f; });
}

/// How such surfaces reflect even light. It is the same for all, and drawn once.
ImageId specular_lobe(const FrameInput& frame) {
    const ImageId image = frame.graph.persistent("specular_lobe", {.width = specular_lobe_size, .height = specular_lobe_size, .format = Format::rg32f});
    if (!frame.graph.needs_redraw(image, 0, 1)) return image;
    auto pass = frame.graph.fullscreen("specular_lobe", "passes/specular_lobe.frag");
    return pass.write("lobe", image, Load::discard);
}

}  // namespace

ImageId compose(const FrameInput& frame, const GBuffer& gbuffer, ImageId direct, ImageId irradiance) {
    const bool gloss = has_gloss(frame.scene);
    const ImageId lobe = gloss ? specular_lobe(frame) : ImageId{};
    auto pass = frame.graph.fullscreen("compose", gloss ? "passes/compose_gloss.frag" : "passes/compose.frag");
    pass.params("Frame", frame.params)
        .read("depth", gbuffer.depth)
        .read("albedo", gbuffer.albedo)
        .read("material", gbuffer.material)
        .read("direct", direct)
        .read("irradiance", irradiance);
    if (gloss) pass.read("normal", gbuffer.normal).read("specular_lobe", lobe, Sampling::linear);
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
