// SPDX-License-Identifier: MIT
#include "engine/render/capture.h"

#include <algorithm>
#include <charconv>

#include "engine/core/clock.h"
#include "engine/core/error.h"
#include "engine/render/scene/extract.h"
#include "shared/octahedral.h"

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

ImageLayer layer_of(const Renderer& renderer, const std::string& name, const std::string& image) {
    return {name, renderer.read(renderer.find_image(image))};
}

Image without_alpha(const Image& image) {
    Image result(image.width, image.height, 3);
    for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i) {
        for (std::size_t c = 0; c < 3; ++c) result.data[i * 3 + c] = image.data[i * image.channels + c];
    }
    return result;
}

/// Without indirect light a frame holds one black pixel of it; a capture shows a black picture.
Image at_least(Image image, const CaptureSettings& settings) {
    const bool single = image.width == 1 && image.height == 1;
    return single ? Image(settings.width, settings.height, image.channels) : image;
}

std::vector<ImageLayer> read_layers(const Renderer& renderer, const FrameOutput& images, const CaptureSettings& settings) {
    std::vector<ImageLayer> layers;
    layers.push_back({"", without_alpha(renderer.read(images.hdr))});
    layers.push_back({"direct", without_alpha(renderer.read(images.direct))});
    layers.push_back({"irradiance", without_alpha(at_least(renderer.read(images.irradiance), settings))});
    layers.push_back({"albedo", without_alpha(renderer.read(images.gbuffer.albedo))});
    layers.push_back({"normal", decoded_normals(renderer.read(images.gbuffer.normal))});
    layers.push_back(layer_of(renderer, "depth", "depth"));
    return layers;
}

}  // namespace

Image decoded_normals(const Image& encoded) {
    Image result(encoded.width, encoded.height, 3);
    for (std::size_t i = 0; i < std::size_t{encoded.width} * encoded.height; ++i) {
        const vec3 n = octahedral_decode(vec2(encoded.data[i * 2], encoded.data[i * 2 + 1]) * 2.0f - 1.0f);
        for (int c = 0; c < 3; ++c) result.data[i * 3 + static_cast<std::size_t>(c)] = n[c];
    }
    return result;
}

Capture capture(App& app, Renderer& renderer, const CaptureSettings& settings) {
    Capture result;
    RenderScene scene;
    const ShownImage shown = parse_show(settings.show);
    Renderer::Request request{.width = settings.width, .height = settings.height};
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
            if (settings.layers) request.wanted.insert(request.wanted.end(), {"hdr", "direct", "albedo", "normal", "depth"});
            request.want_irradiance = settings.layers;
            if (settings.keep_refined) request.wanted_if_there.push_back("refined");
        }
        result.result = renderer.render(scene, request);
    }
    if (!result.result.drawn) {
        result.empty = true;
        result.picture = Image(settings.width, settings.height, 3);
        return result;
    }
    const float exposure = scene.view->exposure();
    if (shown.name.empty()) {
        result.picture = without_alpha(renderer.read(result.result.images.final));
    } else {
        const ImageId image = renderer.find_image(shown.name);
        const std::uint32_t layers = std::max(renderer.graph().resources()[image.index].image.layers, 1u);
        if (shown.layer >= layers) fail("--show: '{}' has {} layers, counted from 0", shown.name, layers);
        const Image raw = at_least(renderer.read(image, shown.layer), settings);
        result.picture = displayable(shown.name, raw, exposure);
        const bool screen_sized = raw.width == settings.width && raw.height == settings.height;
        if (!settings.layers || !screen_sized) result.layers.push_back({shown.name, raw});
    }
    if (settings.layers && (shown.name.empty() || result.layers.empty())) result.layers = read_layers(renderer, result.result.images, settings);
    return result;
}

}  // namespace sl
