// SPDX-License-Identifier: MIT
#include "editor/see/pixel_probe.h"

#include "editor/see/rsm_normals.h"

namespace sl {

namespace {

constexpr double seconds_between = 0.25;

std::optional<vec4> value_at(const Renderer& renderer, ImageId image, uvec2 pixel) {
    if (!renderer.readable(image)) return std::nullopt;
    return renderer.read_pixel(image, pixel);
}

std::optional<std::vector<RsmLayer>> rsm_layers(const Renderer& renderer) {
    const ImageId position = renderer.graph().find_image("rsm_position"), flux = renderer.graph().find_image(rsm_flux_image);
    if (!renderer.readable(position) || !renderer.readable(flux)) return std::nullopt;
    std::vector<RsmLayer> result;
    const std::uint32_t layers = renderer.graph().resources()[position.index].image.layers;
    for (std::uint32_t layer = 0; layer < layers; ++layer) result.push_back({renderer.read(position, layer), renderer.read(flux, layer)});
    return result;
}

}  // namespace

void PixelProbe::prepare(Renderer::Request& request) const {
    if (!picked_ && !reading_) return;
    request.wanted_if_there.insert(request.wanted_if_there.end(), {"depth", "normal", "albedo", "direct", "hdr", "rsm_position", rsm_flux_image});
    request.want_irradiance = true;
}

void PixelProbe::update(const SeenFrame& frame) {
    if (!frame.result.drawn) return;
    if (const auto place = picked_; place && frame.renderer.readable(frame.result.images.gbuffer.depth)) {
        picked_.reset();
        take(frame, *place);
    }
    if (!reading_) return;
    until_read_ -= frame.seconds;
    const ProbedPoint& point = reading_->point;
    // In every frame, because what nobody asks for is forgotten.
    const dvec3 off_the_surface = point.position + dvec3(point.normal * clearance(vec3(point.position - frame.scene.origin)));
    if (frame.meter != nullptr) reading_->truth = frame.meter->irradiance_at(off_the_surface, point.normal);
    if (until_read_ <= 0.0) read(frame);
}

void PixelProbe::take(const SeenFrame& frame, vec2 place) {
    const uvec2 pixel = glm::min(uvec2(glm::max(place, vec2(0.0f)) * vec2(frame.size)), frame.size - 1u);
    const GBuffer& gbuffer = frame.result.images.gbuffer;
    const auto depth = value_at(frame.renderer, gbuffer.depth, pixel), normal = value_at(frame.renderer, gbuffer.normal, pixel);
    const auto point = depth && normal ? point_under(frame.params(), frame.scene.origin, pixel, depth->x, vec2(*normal)) : std::nullopt;
    reading_.reset();
    missed_ = !point;
    if (!point) return;
    reading_.emplace(ProbeReading{.point = *point, .entity = entity_at(frame.scene, vec3(point->position - frame.scene.origin))});
    until_read_ = 0.0;
}

void PixelProbe::read(const SeenFrame& frame) {
    until_read_ = seconds_between;
    ProbeReading& reading = *reading_;
    const TransportWorld* world = frame.meter != nullptr ? frame.meter->world() : nullptr;
    reading.distance = static_cast<float>(glm::length(reading.point.position - frame.scene.origin - dvec3(frame.scene.view->place())));
    reading.live = live_values(frame, reading.point);
    reading.lights = light_shares(frame.scene, reading.point, world);
    reading.shadowed = world != nullptr;
    reading.texels.reset();
    if (const auto layers = rsm_layers(frame.renderer)) reading.texels = texel_shares(*layers, reading.point, frame.scene.origin, most_texels);
}

std::optional<LiveValues> PixelProbe::live_values(const SeenFrame& frame, const ProbedPoint& point) const {
    const FrameParams params = frame.params();
    const auto place = seen_at(params, frame.scene.origin, point.position);
    if (!place) return std::nullopt;
    const FrameOutput& images = frame.result.images;
    const auto at = [&](ImageId image) { return value_at(frame.renderer, image, place->pixel); };
    const auto depth = at(images.gbuffer.depth), albedo = at(images.gbuffer.albedo), direct = at(images.direct), irradiance = at(images.irradiance), radiance = at(images.hdr);
    if (!depth || !albedo || !direct || !irradiance || !radiance || !is_visible(params, *place, depth->x)) return std::nullopt;
    return LiveValues{vec3(*albedo), vec3(*direct), vec3(*irradiance), vec3(*radiance)};
}

}  // namespace sl
