// SPDX-License-Identifier: MIT
#include "engine/render/capture.h"

#include <algorithm>
#include <charconv>

#include "engine/core/clock.h"
#include "engine/core/error.h"
#include "engine/render/displayable.h"
#include "engine/render/image_layers.h"
#include "engine/render/refined_share.h"
#include "engine/render/scene/extract.h"

namespace sl {

namespace {

struct ShownImage {
    std::string name;
    std::uint32_t layer = 0;
};

ShownImage parse_show(const std::string& text) {
    const std::size_t dot = text.rfind('.');
    if (dot == std::string::npos) return {text, 0};
    ShownImage shown{text.substr(0, dot), 0};
    const auto parsed = std::from_chars(text.data() + dot + 1, text.data() + text.size(), shown.layer);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size()) fail("--show '{}': the layer after the dot is not a number", text);
    return shown;
}

}  // namespace

Capture capture(App& app, Renderer& renderer, const CaptureSettings& settings) {
    Capture result;
    RenderScene scene;
    const ShownImage shown = parse_show(settings.show);
    // Eyes that adapt have had all the time they need.
    Renderer::Request request{.width = settings.width, .height = settings.height, .seconds = std::numeric_limits<float>::infinity()};
    auto& clock = app.world.resource<FrameClock>();
    for (std::uint32_t frame = 0; frame <= settings.frame; ++frame) {
        if (frame > 0) clock.advance();
        app.schedule.run(app.world);
        extract(app.world, scene);
        const bool last = frame == settings.frame;
        request.frame_index = frame;
        request.slice_budget = last ? ~0u : 0u;
        if (last) {
            request.on_step = settings.on_step;
            if (!shown.name.empty()) request.wanted.push_back(shown.name);
            if (settings.layers) want_linear_layers(request);
            if (settings.keep_refined) request.wanted_if_there.push_back(refined_image);
        }
        result.result = renderer.render(scene, request);
    }
    if (!result.result.drawn) {
        result.empty = true;
        result.picture = Image(settings.width, settings.height, 3);
        return result;
    }
    if (shown.name.empty()) {
        result.picture = without_alpha(renderer.read(result.result.images.final));
    } else {
        const ImageId image = renderer.find_image(shown.name);
        const std::uint32_t layers = std::max(renderer.graph().resources()[image.index].image.layers, 1u);
        if (shown.layer >= layers) fail("--show: '{}' has {} layers, counted from 0", shown.name, layers);
        const Image raw = at_least(renderer.read(image, shown.layer), uvec2(settings.width, settings.height));
        result.picture = displayable(shown.name, raw, renderer.exposure());
        const bool screen_sized = raw.width == settings.width && raw.height == settings.height;
        if (!settings.layers || !screen_sized) result.layers.push_back({shown.name, raw});
    }
    if (settings.layers && (shown.name.empty() || result.layers.empty())) result.layers = linear_layers(renderer, result.result.images);
    return result;
}

}  // namespace sl
