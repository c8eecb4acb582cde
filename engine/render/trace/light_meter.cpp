// SPDX-License-Identifier: MIT
#include "engine/render/trace/light_meter.h"

#include <bit>
#include <cmath>

namespace sl {

namespace {

constexpr std::uint32_t paths_per_frame = 64;
/// Frames after which a point is forgotten: a second, and longer than any pause between two questions should be.
constexpr std::uint32_t forgotten_after = 60;
/// What is left of a reading, in batches, while something changes in each frame, so that a moving light gives steady
/// readings; of light that is long out, a hundredth after 16 frames. A change after rest leaves nothing.
constexpr std::uint32_t kept_in_motion = 3;

}  // namespace

std::size_t LightMeter::Hash::operator()(const Point& point) const {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) hash = hash_mix(hash_mix(hash, std::bit_cast<std::uint64_t>(point.position[axis])), std::bit_cast<std::uint32_t>(point.normal[axis]));
    return hash;
}

LightMeter::~LightMeter() noexcept { jobs_.wait(); }

std::optional<LightMeter::Reading> LightMeter::irradiance_at(const dvec3& position, vec3 normal) {
    Measured& measured = points_[{position, normal}];
    measured.unasked = 0;
    return measured.reading;
}

void LightMeter::update(const RenderScene& scene) {
    jobs_.wait();
    take_over_batches();
    for (auto& [point, measured] : points_) ++measured.unasked;
    std::erase_if(points_, [](const auto& entry) { return entry.second.unasked > forgotten_after; });
    if (points_.empty()) return world_.reset();
    const bool changed = take(scene);
    if (changed) {
        for (auto& [point, measured] : points_) measured.batches = std::min(measured.batches, moved_ ? kept_in_motion : 0);
    }
    moved_ = changed;
    for (auto& entry : points_) {
        jobs_.run([this, &entry] { follow_paths(entry.first, entry.second); });
    }
}

/// True where something is another than it was.
bool LightMeter::take(const RenderScene& scene) {
    const std::uint64_t geometry = scene.geometry_hash();
    const bool anew = world_ == nullptr || origin_ != scene.origin, other_surfaces = anew || geometry != geometry_;
    const bool other_light = other_surfaces || lights_ != scene.lights || sky_ != scene.sky_radiance;
    if (anew) {
        world_ = std::make_unique<TransportWorld>(scene, TransportSettings{});
    } else {
        if (other_surfaces) world_->resurface(scene);
        if (other_light) world_->relight(scene);
    }
    origin_ = scene.origin;
    geometry_ = geometry;
    lights_ = scene.lights;
    sky_ = scene.sky_radiance;
    return other_light;
}

void LightMeter::follow_paths(const Point& point, Measured& measured) const {
    SurfacePoint surface{};
    surface.position = vec3(point.position - origin_);
    surface.face = point.normal;
    surface.surface.normal = vec4(point.normal, 0.0f);
    measured.batch = {};
    const auto seed = static_cast<std::uint32_t>(Hash{}(point));
    for (std::uint32_t i = 0; i < paths_per_frame; ++i) {
        PathSample sample;
        gather_path(*world_, surface, SampleSequence(seed, uvec2(0), measured.paths + i), sample);
        measured.batch.irradiance += sample.irradiance();
        measured.batch.bounced += sample.bounced_irradiance();
    }
    measured.batch.paths = paths_per_frame;
}

void LightMeter::take_over_batches() {
    for (auto& [point, measured] : points_) {
        const Batch batch = std::exchange(measured.batch, {});
        if (batch.paths == 0) continue;
        if (!measured.reading) measured.reading.emplace();
        Reading& reading = *measured.reading;
        const float share = 1.0f / static_cast<float>(++measured.batches), scale = 1.0f / static_cast<float>(batch.paths);
        const float light = luminance(batch.bounced) * scale;
        reading.irradiance += (batch.irradiance * scale - reading.irradiance) * share;
        reading.bounced += (batch.bounced * scale - reading.bounced) * share;
        measured.squares += (light * light - measured.squares) * share;
        measured.paths += batch.paths;
        reading.paths = measured.batches * paths_per_frame;
        const float mean = luminance(reading.bounced), variance = std::max(measured.squares - mean * mean, 0.0f);
        reading.noise = measured.batches > 1 && mean > 0.0f ? std::sqrt(variance / static_cast<float>(measured.batches - 1)) / mean : 1.0f;
    }
}

}  // namespace sl
