// SPDX-License-Identifier: MIT
#include "game/model_scene.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/core/log.h"
#include "engine/ecs/active_camera.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "engine/ecs/scene_file.h"

namespace sl {

namespace {

constexpr float fov_y = 1.0f, daylight_ev100 = 14.0f, lamplight_ev100 = 7.0f;

template <class Light>
bool any(World& world) {
    bool found = false;
    Query<const Light>(world).each([&](const Light&) { found = true; });
    return found;
}

/// The greatest that a function of materials is of those that are shown, from 0: blocks that glow are in the table of every world.
template <class F>
float greatest_shown(World& world, const F& of) {
    const auto& entries = world.resource<MaterialTable>().entries;
    // Many entities may show one mesh.
    std::set<std::pair<MeshHandle, std::int32_t>> shown;
    Query<const MeshInstance>(world).each([&](const MeshInstance& instance) { shown.emplace(instance.mesh, instance.first_material); });
    float greatest = 0.0f;
    for (const auto& [mesh, first] : shown) {
        const auto row = static_cast<std::size_t>(std::max(first, 0));
        for (const Vertex& vertex : world.resource<MeshPool>().at(mesh).vertices) {
            if (row + vertex.material < entries.size()) greatest = std::max(greatest, of(entries[row + vertex.material]));
        }
    }
    return greatest;
}

/// nit, of its strongest channel.
float glow_of(const MaterialEntry& entry) {
    const vec3 colour = entry.material.emission_colour;
    return entry.unlit ? 0.0f : entry.material.emission * std::max({colour.x, colour.y, colour.z});
}

/// From a little above and to the right, just so far off that the corners of a box round everything fit in a picture of 3 : 2 or wider.
Transform place_to_see(const Bounds& bounds) {
    const vec3 forward = -glm::normalize(vec3(0.5f, 0.35f, 1.0f));
    const mat3 view_from_world_turn(view_from_world(vec3(0.0f), forward, vec3(0, 1, 0)));
    const vec3 half = 0.5f * (bounds.high - bounds.low);
    const float slope = std::tan(0.5f * fov_y);
    float distance = 1e-3f;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 sign(corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f);
        const vec3 seen = view_from_world_turn * (sign * half);
        distance = std::max(distance, seen.z + std::max(std::abs(seen.y), std::abs(seen.x) / 1.5f) / slope);
    }
    return {.translation = dvec3(bounds.centre() - forward * (1.05f * distance)), .rotation = glm::normalize(glm::quat_cast(glm::transpose(view_from_world_turn)))};
}

/// The active one, or the first: those of models begin inactive.
Entity shown_camera(World& world) {
    if (const Entity active = active_camera(world)) return active;
    for (auto [entity, camera] : Query<const Camera>(world)) return entity;
    return {};
}

}  // namespace

Bounds bounds_of_meshes(World& world) {
    Bounds bounds;
    for (auto [entity, instance, transform] : Query<const MeshInstance, const WorldTransform>(world)) {
        const MeshData* mesh = world.resource<MeshPool>().find(instance.mesh);
        if (mesh == nullptr || mesh->bounds.empty()) continue;
        mat4 place(transform.linear);
        place[3] = vec4(vec3(transform.origin), 1.0f);
        bounds.add(transformed(mesh->bounds, place));
    }
    return bounds;
}

std::size_t triangles_of_meshes(World& world) {
    std::size_t triangles = 0;
    Query<const MeshInstance>(world).each([&](const MeshInstance& instance) {
        if (const MeshData* mesh = world.resource<MeshPool>().find(instance.mesh)) triangles += mesh->indices.size() / 3;
    });
    return triangles;
}

void add_model_scene(App& app, const std::filesystem::path& path) {
    app.world.add_resource(SceneInfo{.description = path.filename().string(), .path = path});
    app.world.create(Name{"model"}, Transform{}, ModelFile{.file = path.filename().string()});
}

void complete_model_scene(App& app) {
    World& world = app.world;
    const std::filesystem::path path = world.resource<SceneInfo>().path;
    const Bounds bounds = bounds_of_meshes(world);
    const bool lamps = any<DirectionalLight>(world) || any<SpotLight>(world) || any<PointLight>(world);
    const float glow = greatest_shown(world, glow_of);
    if (!lamps && glow <= 0.0f) {
        log::info("{}: it has no light, so a sun and a sky were added", path.string());
        // Over the left shoulder of the camera below, so that what it sees is lit.
        world.create(Name{"sun"}, Transform{}, DirectionalLight{.colour = vec3(1.0f, 0.96f, 0.9f)}, SunAngles{.azimuth = 3.5f, .elevation = 0.8f});
        world.create(Name{"sky"}, SkyLight{});
    }
    Entity camera = shown_camera(world);
    if (!camera) {
        if (!bounds.empty()) log::info("{}: it has no camera, so one was placed that sees all of it", path.string());
        camera = world.create(Name{"camera"}, bounds.empty() ? Transform{} : place_to_see(bounds), Camera{.fov_y = fov_y});
        world.get<Camera>(camera).near = std::max(1e-3f * bounds.radius(), 1e-6f);
    }
    auto& view = world.get<Camera>(camera);
    view.active = true;
    // What is unlit has its colours at the exposure that is set.
    view.auto_exposure = greatest_shown(world, [](const MaterialEntry& entry) { return entry.unlit ? 0.0f : 1.0f; }) > 0.0f;
    // Eyes that have adapted to a glow see it as white, be it as faint as a file's that says nothing of its strength: 1 nit.
    view.ev100 = lamps ? lamplight_ev100 : glow > 0.0f ? std::clamp(std::log2(glow), -5.0f, lamplight_ev100) : daylight_ev100;
    world.add(camera, GiSettings{make_gi_method("facets")});
}

}  // namespace sl
