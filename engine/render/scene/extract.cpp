// SPDX-License-Identifier: MIT
#include "engine/render/scene/extract.h"

#include <cmath>

#include "engine/ecs/components.h"
#include "engine/ecs/components/water.h"
#include "engine/ecs/query.h"
#include "engine/render/scene/point_map.h"
#include "engine/render/scene/sun_map.h"

namespace sl {

namespace {

/// The origin moves in steps, so that positions of still things keep their bytes (and cached light maps stay valid)
/// while the camera walks; float is exact to 0.1 mm within a step.
constexpr double origin_step = 1024.0;

dvec3 snapped_origin(const dvec3& eye, const dvec3& previous) {
    if (glm::all(glm::lessThan(glm::abs(eye - previous), dvec3(0.75 * origin_step)))) return previous;
    return glm::round(eye / origin_step) * origin_step;
}

vec3 relative(const WorldTransform& transform, const dvec3& origin) { return vec3(transform.origin - origin); }

/// 1/m, of air through which 2 % of a contrast are left at that distance, m (Koschmieder 1924).
float extinction_of(float visibility) { return 3.912f / visibility; }

/// Over the distance of the land's edge, at most: there a seventh of the contrast with the sky is left.
constexpr double visibility_over_edge = 2.0;

float visibility_of(const SkyLight& sky, const LandEdge* edge) {
    return edge == nullptr ? sky.visibility : std::min(sky.visibility, static_cast<float>(visibility_over_edge * edge->distance));
}

vec3 forward_of(const WorldTransform& transform) { return glm::normalize(transform.linear * vec3(0, 0, -1)); }

/// m: beyond it, squares of lengths are no numbers. What a file places there, or nowhere, is left out.
constexpr float farthest = 1e15f;

bool is_placed(const WorldTransform& transform) {
    bool placed = glm::all(glm::lessThan(glm::abs(transform.origin), dvec3(farthest)));
    for (int axis = 0; axis < 3; ++axis) placed &= glm::all(glm::lessThan(glm::abs(transform.linear[axis]), vec3(farthest)));
    return placed;
}

/// Whether it also has a front, and what is above it: something that is scaled to nothing has neither.
bool is_turned(const WorldTransform& transform) {
    return is_placed(transform) && glm::length(glm::cross(forward_of(transform), transform.linear * vec3(0, 1, 0))) > 0.0f;
}

bool is_within_reach(const Bounds& bounds) { return glm::all(glm::lessThan(glm::max(glm::abs(bounds.low), glm::abs(bounds.high)), vec3(farthest))); }

void extract_view(World& world, RenderScene& scene) {
    scene.view.reset();
    scene.gi.reset();
    for (auto [entity, camera, transform] : Query<const Camera, const WorldTransform>(world)) {
        if (!camera.active || !is_turned(transform)) continue;
        scene.origin = snapped_origin(transform.origin, scene.origin);
        const Lens lens = lens_of(camera);
        scene.view = RenderScene::View{.position = relative(transform, scene.origin) - lens.behind * forward_of(transform),
                                       .forward = forward_of(transform),
                                       .up = transform.linear * vec3(0, 1, 0),
                                       .fov_y = lens.fov_y,
                                       .near = lens.near,
                                       .behind = lens.behind,
                                       .ev100 = camera.ev100,
                                       .auto_exposure = camera.auto_exposure,
                                       .antialias = camera.antialias,
                                       .in_water = world.has<InWater>(entity)};
        if (const auto* gi = world.find<GiSettings>(entity)) scene.gi = *gi;
        return;
    }
}

std::uint64_t material_hash(const MaterialEntry& entry) {
    const Material& m = entry.material;
    const std::array<float, 10> values{m.base_colour.x, m.base_colour.y, m.base_colour.z, m.metallic, m.roughness,
                                       m.specular, m.emission, m.emission_colour.x, m.emission_colour.y,
                                       m.emission_colour.z};
    const std::uint64_t hash = hash_mix(hash_bytes(0x5ec0d, values.data(), sizeof values), static_cast<std::uint32_t>(entry.texture_layer));
    return entry.pictures ? hash_bytes(hash_mix(hash, entry.unlit), &*entry.pictures, sizeof(PictureParams)) : hash;
}

void extract_materials(World& world, RenderScene& scene) {
    scene.materials.clear();
    scene.textures = world.find_resource<TextureLayers>();
    const auto* pictures = world.find_resource<PictureTable>();
    scene.pictures = pictures != nullptr ? *pictures : PictureTable{};
    if (const auto* table = world.find_resource<MaterialTable>()) scene.materials = table->entries;
    // Without those that entities have for themselves, of which each draw's content tells.
    scene.materials_hash = hash_mix(scene.textures != nullptr ? scene.textures->version : 0, scene.pictures.version);
    for (const MaterialEntry& entry : scene.materials) scene.materials_hash = hash_mix(scene.materials_hash, material_hash(entry));
}

mat4 placed(const WorldTransform& transform, const dvec3& origin) {
    mat4 world_from_local(transform.linear);
    world_from_local[3] = vec4(relative(transform, origin), 1.0f);
    return world_from_local;
}

bool lie_apart(const PictureParams& pictures) {
    const auto elsewhere = [&](const PicturePlace& place) { return place.axes != pictures.colour.axes || place.offset != pictures.colour.offset; };
    return pictures.layers.w != no_texture || pictures.second != uvec4(0) || elsewhere(pictures.emission) || elsewhere(pictures.data);
}

void extract_draws(World& world, RenderScene& scene) {
    scene.draws.clear();
    scene.bounds = {};
    scene.meshes = world.find_resource<MeshPool>();
    if (scene.meshes == nullptr) return;
    for (auto [entity, instance, transform] : Query<const MeshInstance, const WorldTransform>(world)) {
        const MeshData* mesh = scene.meshes->find(instance.mesh);
        if (mesh == nullptr || mesh->indices.empty()) continue;
        RenderScene::Draw draw;
        draw.mesh = instance.mesh;
        draw.entity = entity;
        draw.world_from_local = placed(transform, scene.origin);
        draw.bounds = transformed(mesh->bounds, draw.world_from_local);
        if (!is_within_reach(draw.bounds)) continue;
        std::uint64_t own_material = 0;
        if (instance.first_material == MeshInstance::own_material) {
            const auto* material = world.find<Material>(entity);
            draw.first_material = static_cast<std::uint32_t>(scene.materials.size());
            scene.materials.push_back({material != nullptr ? *material : Material{}, -1});
            own_material = material_hash(scene.materials.back());
        } else {
            draw.first_material = static_cast<std::uint32_t>(instance.first_material);
        }
        if (draw.first_material < scene.materials.size()) {
            const auto& pictures = scene.materials[draw.first_material].pictures;
            draw.pictured = pictures.has_value();
            draw.apart = draw.pictured && (lie_apart(*pictures) || scene.materials[draw.first_material].unlit);
            draw.open = draw.pictured && pictures->alpha.y != 0.0f;
        }
        // Where it is in the world: the origin may step on.
        draw.content = hash_bytes(hash_mix(own_material, draw.first_material), &transform.origin, sizeof(dvec3));
        draw.content = hash_bytes(draw.content, &transform.linear, sizeof(mat3));
        draw.content = hash_mix(hash_mix(draw.content, instance.mesh.slot), instance.mesh.generation);
        draw.content_before = hash_mix(draw.content, mesh->version - 1);
        draw.content = hash_mix(draw.content, mesh->version);
        if (!mesh->changed.empty()) draw.changed = transformed(mesh->changed, draw.world_from_local);
        scene.bounds.add(draw.bounds);
        scene.draws.push_back(draw);
    }
}

void extract_waters(World& world, RenderScene& scene) {
    scene.waters.clear();
    if (scene.meshes == nullptr) return;
    for (auto [entity, water, transform] : Query<const WaterSurface, const WorldTransform>(world)) {
        const MeshData* mesh = scene.meshes->find(water.mesh);
        if (mesh == nullptr || mesh->indices.empty()) continue;
        const mat4 world_from_local = placed(transform, scene.origin);
        scene.waters.push_back({.mesh = water.mesh, .world_from_local = world_from_local, .bounds = transformed(mesh->bounds, world_from_local), .entity = entity});
    }
}

/// The shadow map of one light: `layers` of an array, which together are so many squares of its size.
struct MapLayout {
    std::uint64_t layers = 1, squares = 1;
};

/// Lights of a kind share an array of maps, as large as the largest asks for. A file may have thousands of lights: those whose maps
/// would take more texels than `most`, or more layers than OpenGL promises, get none. Returns how many texels are left.
std::uint64_t bound_maps(RenderScene& scene, RenderScene::Light::Kind kind, MapLayout layout, std::uint64_t most) {
    constexpr std::uint64_t most_layers = 2048;
    std::uint64_t lights = 0, side = 0;
    for (RenderScene::Light& light : scene.lights) {
        if (light.kind != kind || (!light.casts_shadow && !light.bounces)) continue;
        const std::uint64_t largest = std::max<std::uint64_t>(side, light.shadow_size);
        light.mapped = (lights + 1) * layout.layers <= most_layers && (lights + 1) * layout.squares * largest * largest <= most;
        if (!light.mapped) continue;
        side = largest;
        ++lights;
    }
    return most - lights * layout.squares * side * side;
}

void extract_lights(World& world, RenderScene& scene) {
    using Light = RenderScene::Light;
    scene.lights.clear();
    for (auto [entity, light, transform] : Query<const DirectionalLight, const WorldTransform>(world)) {
        if (light.illuminance <= 0.0f || !is_turned(transform)) continue;
        scene.lights.push_back({.kind = Light::Kind::directional, .direction = forward_of(transform),
                                .intensity = light.colour * light.illuminance, .casts_shadow = light.casts_shadow,
                                .bounces = light.bounces, .shadow_size = light.shadow_size,
                                .shadow_distance = light.shadow_distance, .entity = entity});
    }
    for (auto [entity, light, transform] : Query<const SpotLight, const WorldTransform>(world)) {
        if (light.intensity <= 0.0f || !is_turned(transform)) continue;
        scene.lights.push_back({.kind = Light::Kind::spot, .position = relative(transform, scene.origin),
                                .direction = forward_of(transform), .intensity = light.colour * light.intensity,
                                .range = light.range, .inner_cone = std::min(light.inner_cone, light.outer_cone),
                                .outer_cone = light.outer_cone, .casts_shadow = light.casts_shadow,
                                .bounces = light.bounces, .shadow_size = light.shadow_size, .entity = entity});
    }
    for (auto [entity, light, transform] : Query<const PointLight, const WorldTransform>(world)) {
        if (light.intensity <= 0.0f || !is_placed(transform)) continue;
        scene.lights.push_back({.kind = Light::Kind::point, .position = relative(transform, scene.origin),
                                .intensity = light.colour * light.intensity, .range = light.range,
                                .casts_shadow = light.casts_shadow, .shadow_size = light.shadow_size, .entity = entity});
    }
    constexpr std::uint64_t most_texels = RenderScene::most_shadow_bytes / sizeof(float);
    // A sun's map may lie in tiles.
    bound_maps(scene, Light::Kind::directional, {.layers = std::uint64_t{SunSquare::most_tiles} * SunSquare::most_tiles}, most_texels);
    const std::uint64_t left = bound_maps(scene, Light::Kind::spot, {}, most_texels);
    bound_maps(scene, Light::Kind::point, {.layers = point_face_count, .squares = point_face_count}, left);
    scene.sky_radiance = vec3(0.0f);
    scene.extinction = 0.0f;
    for (auto [entity, sky] : Query<const SkyLight>(world)) {
        scene.sky_radiance += sky.colour * sky.luminance;
        if (const float visibility = visibility_of(sky, world.find_resource<LandEdge>()); visibility > 0.0f) scene.extinction += extinction_of(visibility);
    }
}

}  // namespace

void extract(World& world, RenderScene& scene) {
    extract_view(world, scene);
    extract_materials(world, scene);
    extract_draws(world, scene);
    extract_waters(world, scene);
    extract_lights(world, scene);
}

}  // namespace sl
