// SPDX-License-Identifier: MIT
#include "engine/render/trace/light_meter.h"

#include <algorithm>
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
/// The same of changes that matter little: land that comes far off, or the sun's next step of a day. Readings follow those
/// within two seconds.
constexpr std::uint32_t kept_of_little = 32;
/// Change of a light's direction, and of its strength over itself, that matters little.
constexpr float small_turn = 0.02f, small_share = 0.05f;

bool alike(vec3 a, vec3 b) { return glm::length(a - b) <= small_share * glm::length(a); }

/// Of lights that are the same but for little.
bool alike(const RenderScene::Light& before, const RenderScene::Light& now) {
    if (glm::length(before.direction - now.direction) > small_turn || !alike(before.intensity, now.intensity)) return false;
    RenderScene::Light same = now;
    same.direction = before.direction;
    same.intensity = before.intensity;
    return same == before;
}

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
    const Effect of_light = take(scene);
    for (auto& [point, measured] : points_) {
        const Effect effect = std::max(of_light, of_surfaces(point));
        if (effect == Effect::little) measured.batches = std::min(measured.batches, kept_of_little);
        if (effect == Effect::much) measured.batches = std::min(measured.batches, measured.moved ? kept_in_motion : 0);
        measured.moved = effect == Effect::much;
    }
    for (auto& entry : points_) {
        jobs_.run([this, &entry] { follow_paths(entry.first, entry.second); });
    }
}

LightMeter::Effect LightMeter::take(const RenderScene& scene) {
    const std::uint64_t geometry = scene.geometry_hash();
    const vec3 offset(std::exchange(origin_, scene.origin) - scene.origin);
    const bool other_materials = std::exchange(materials_, scene.materials_hash) != scene.materials_hash;
    const bool anew = world_ == nullptr || other_materials;
    changed_.clear();
    if (anew) {
        world_ = std::make_unique<TransportWorld>(scene, TransportSettings{});
    } else {
        if (offset != vec3(0.0f)) {
            world_->move(offset);
            surfaces_.move(offset);
        }
        if (geometry != geometry_) {
            for (const auto& change : surfaces_.since_last_look(scene)) changed_.push_back(change.box);
            world_->resurface(scene);
        }
    }
    if (std::exchange(geometry_, geometry) != geometry || anew) surfaces_.look_at(scene);
    const bool same = !anew && lights_ == scene.lights && sky_ == scene.sky_radiance;
    const bool similar = !anew && std::ranges::equal(lights_, scene.lights, [](const auto& a, const auto& b) { return alike(a, b); }) && alike(sky_, scene.sky_radiance);
    if (!same || offset != vec3(0.0f)) world_->relight(scene);
    lights_ = scene.lights;
    sky_ = scene.sky_radiance;
    return same ? Effect::none : similar ? Effect::little : Effect::much;
}

LightMeter::Effect LightMeter::of_surfaces(const Point& point) const {
    if (changed_.empty()) return Effect::none;
    const vec3 place(point.position - origin_);
    return std::ranges::all_of(changed_, [&](const Bounds& box) { return hardly_shows(box, place); }) ? Effect::little : Effect::much;
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
        if (!measured.reading) measured.reading = Reading{};
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
