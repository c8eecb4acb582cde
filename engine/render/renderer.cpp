// SPDX-License-Identifier: MIT
#include "engine/render/renderer.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/render/pass_times.h"
#include "engine/render/passes/exposure.h"
#include "shared/exposure.h"

namespace sl {

Renderer::Renderer(const std::filesystem::path& folder) : executor_(folder) {}

Renderer::Result Renderer::render(const RenderScene& given, const Request& request) {
    Result result;
    graph_ = FrameGraph(states_);
    steps_.clear();
    times_.begin();
    if (!given.view) return result;
    CHECK(request.width > 0 && request.height > 0, "a frame of {}x{}", request.width, request.height);

    const RenderScene& scene = suns_.hold(given, request.slice_budget == ~0u);
    LightTable lights = build_light_table(scene);
    suns_.add_next_layers(lights);
    times_.done("suns");
    const SceneInputs inputs = gpu_scene_.upload(graph_, scene, lights);
    times_.done("upload");
    const FrameInput frame{.graph = graph_,
                           .scene = scene,
                           .lights = lights,
                           .inputs = inputs,
                           .facets = facets_,
                           .params = frame_params(scene, request.width, request.height, request.frame_index),
                           .width = request.width,
                           .height = request.height,
                           .slice_budget = request.slice_budget,
                           .gi_gpu_seconds = 1e-3 * gi_milliseconds(executor_.timers().newest()),
                           .seconds = request.seconds,
                           .time = request.time};
    images_ = build_frame(frame, passes_);
    exposure_ = scene.view->exposure();
    adapts_ = scene.view->auto_exposure;
    times_.done("build");
    result.images = images_;
    graph_.want(result.images.final);
    if (request.want_irradiance) graph_.want(result.images.irradiance);
    for (const std::string& name : request.wanted) {
        const ImageId image = find_image(name);
        if (!image) fail("this frame has no image '{}'; it has {}", name, fmt::join(image_names(graph_), ", "));
        graph_.want(image);
    }
    for (const std::string& name : request.wanted_if_there) {
        if (const ImageId image = graph_.find_image(name)) graph_.want(image);
    }
    steps_ = graph_.compile();
    times_.done("compile");
    executor_.run(graph_, steps_, request.on_step);
    times_.done("run");
    result.drawn = true;
    result.lights_without_maps = scene.lights_without_maps();
    if (result.lights_without_maps > told_without_maps_) {
        told_without_maps_ = result.lights_without_maps;
        log::warn("{} of {} lights cast no shadow in the picture: the shadow maps of all would take more than {} MB; lower shadow_size, or switch casts_shadow off where it hardly shows",
                  told_without_maps_, scene.lights.size(), RenderScene::most_shadow_bytes >> 20);
    }
    if (result.images.next_suns_are_drawn) suns_.next_is_drawn();

    const DrawList drawn = inputs.list_facing(visible_draws(scene, frame.params.clip_from_world), vec4(vec3(frame.params.camera_position), 1.0f));
    for (const DrawCall& call : *drawn) result.triangles_drawn += call.index_count / 3;
    result.triangles_culled = inputs.triangles - result.triangles_drawn;
    times_.done("count");
    return result;
}

ImageId Renderer::find_image(std::string_view name) const {
    const ImageId image = graph_.find_image(name);
    return !image && name == "irradiance" ? images_.irradiance : image;
}

Image Renderer::read(ImageId image, std::uint32_t layer) const {
    const TextureDesc& desc = graph_.resources()[image.index].image;
    const std::uint32_t channels = gl::channel_count(desc.format);
    const std::vector<float> bottom_first = executor_.read(graph_, image, layer);
    Image result(desc.width, desc.height, channels);
    const std::size_t row = std::size_t{desc.width} * channels;
    for (std::uint32_t y = 0; y < desc.height; ++y) {
        std::copy_n(&bottom_first[(desc.height - 1 - y) * row], row, &result.data[y * row]);
    }
    return result;
}

float Renderer::exposure() const { return adapts_ ? exposure_of(executor_.read_number(adapted_ev_buffer)) : exposure_; }

vec4 Renderer::read_pixel(ImageId image, uvec2 pixel, std::uint32_t layer) const {
    const TextureDesc& desc = graph_.resources()[image.index].image;
    const uvec2 inside = glm::min(pixel, uvec2(desc.width, desc.height) - 1u);
    const std::vector<float> values = executor_.read_texel(graph_, image, {inside.x, desc.height - 1 - inside.y}, layer);
    vec4 result(0.0f);
    for (std::size_t channel = 0; channel < values.size(); ++channel) result[static_cast<int>(channel)] = values[channel];
    return result;
}

std::vector<std::string> image_names(const FrameGraph& graph) {
    std::set<std::string> names;
    for (const ResourceRecord& resource : graph.resources()) {
        if (!resource.is_buffer && resource.lifetime != Lifetime::external) names.insert(resource.name);
    }
    return {names.begin(), names.end()};
}

}  // namespace sl
