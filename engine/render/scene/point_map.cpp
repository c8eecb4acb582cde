// SPDX-License-Identifier: MIT
#include "engine/render/scene/point_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/render/scene/light_map.h"
#include "shared/lights.h"

namespace sl {

namespace {

using Light = RenderScene::Light;

/// A face shows a point that was moved off its surface, by fewer texels than this.
constexpr float most_texels_moved = 8.0f;

/// Straight lines from one point, and the volume between them; w = 0: a line without end.
struct Pyramid {
    std::array<vec4, 5> planes;   ///< positive inside
    std::array<vec4, 5> corners;
};

/// Whether one of its planes has all of the other on its outer side.
bool divides(const Pyramid& pyramid, const Pyramid& other) {
    return std::ranges::any_of(pyramid.planes, [&](const vec4& plane) {
        return std::ranges::all_of(other.corners, [&](const vec4& corner) { return glm::dot(plane, corner) <= 0.0f; });
    });
}

/// Its inverse is its transpose.
mat3 face_from_world(std::uint32_t face) {
    return {in_point_face(vec3(1, 0, 0), face), in_point_face(vec3(0, 1, 0), face), in_point_face(vec3(0, 0, 1), face)};
}

mat4 clip_from_world_of(const Light& light, std::uint32_t face, float tangent, float near) {
    // A face looks along z, a view along -z.
    const mat3 turn = mat3(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, -1)) * face_from_world(face);
    mat4 view_from_world(turn);
    view_from_world[3] = vec4(-(turn * light.position), 1.0f);
    return reversed_infinite_perspective(2.0f * std::atan(tangent), 1.0f, near) * view_from_world;
}

Pyramid seen_by(const FrameParams& frame) {
    const vec3 ahead(frame.ray_forward), right(frame.ray_right), up(frame.ray_up);
    return {view_planes(frame.clip_from_world),
            {vec4(vec3(frame.camera_position), 1.0f), vec4(ahead - right - up, 0.0f), vec4(ahead + right - up, 0.0f), vec4(ahead - right + up, 0.0f), vec4(ahead + right + up, 0.0f)}};
}

Pyramid lit_through(const Light& light, std::uint32_t face, float near) {
    const float tangent = 1.0f + 2.0f * most_texels_moved / static_cast<float>(light.shadow_size);
    const mat4 clip_from_world = clip_from_world_of(light, face, tangent, near);
    Pyramid lit{view_planes(clip_from_world), {vec4(light.position, 1.0f)}};
    const mat3 world_from_face = glm::transpose(face_from_world(face));
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const vec3 line = world_from_face * vec3(corner % 2 == 0 ? -tangent : tangent, corner < 2 ? -tangent : tangent, 1.0f);
        lit.corners[corner + 1] = light.range > 0.0f ? vec4(light.position + light.range * line, 1.0f) : vec4(line, 0.0f);
    }
    return lit;
}

bool is_out_of_range(const Light& light, const Bounds& box) {
    const vec3 nearest = glm::clamp(light.position, box.low, box.high) - light.position;
    return light.range > 0.0f && glm::dot(nearest, nearest) > light.range * light.range;
}

/// Whether a box, seen from the light, has a share in a face.
bool lies_in(const Bounds& from_light, std::uint32_t face, float tangent) {
    const vec3 a = in_point_face(from_light.low, face), b = in_point_face(from_light.high, face);
    const float along = tangent * std::max(a.z, b.z);
    return along > 0.0f && std::min(a.x, b.x) <= along && std::max(a.x, b.x) >= -along && std::min(a.y, b.y) <= along && std::max(a.y, b.y) >= -along;
}

}  // namespace

float point_face_tangent(const Light& light) { return 1.0f + 2.0f / static_cast<float>(light.shadow_size); }

float point_near_plane(const RenderScene& scene, const Light& light) {
    const vec3 farthest = glm::max(glm::abs(scene.bounds.low - light.position), glm::abs(scene.bounds.high - light.position));
    const float to_scene = glm::length(farthest), reach = light.range > 0.0f ? std::min(light.range, to_scene) : to_scene;
    // As near as a spot's. A power of two: a scene that grows a little leaves the maps as they are.
    return std::exp2(std::floor(std::log2(std::max(1e-5f * reach, 1e-12f))));
}

std::vector<ShadowLayer> point_faces(const RenderScene& scene, const Light& light, const FrameParams& frame) {
    const float near = point_near_plane(scene, light), tangent = point_face_tangent(light);
    const Pyramid seen = seen_by(frame);
    std::vector<ShadowLayer> faces(point_face_count);
    for (std::uint32_t face = 0; face < point_face_count; ++face) {
        const Pyramid lit = lit_through(light, face, near);
        faces[face].in_view = !divides(seen, lit) && !divides(lit, seen);
        faces[face].size = light.shadow_size;
        faces[face].clip_from_world = clip_from_world_of(light, face, tangent, near);
    }
    if (std::ranges::none_of(faces, &ShadowLayer::in_view)) return faces;
    std::array<std::uint64_t, point_face_count> contents{};
    for (std::uint32_t i = 0; i < scene.draws.size(); ++i) {
        const RenderScene::Draw& draw = scene.draws[i];
        if (is_out_of_range(light, draw.bounds)) continue;
        const Bounds from_light = draw.bounds.moved(-light.position);
        for (std::uint32_t face = 0; face < point_face_count; ++face) {
            if (!faces[face].in_view || !lies_in(from_light, face, tangent)) continue;
            faces[face].draws.push_back(i);
            // A sum: in which order the draws stand is not seen.
            contents[face] += hash_mix(0x901a7, draw.content);
        }
    }
    for (std::uint32_t face = 0; face < point_face_count; ++face) {
        if (!faces[face].in_view) continue;
        // How bright the light is, is not seen either.
        std::uint64_t key = hash_bytes(hash_mix(scene.materials_hash, light.shadow_size), &scene.origin, sizeof scene.origin);
        key = hash_bytes(key, &faces[face].clip_from_world, sizeof(mat4));
        faces[face].key = hash_mix(key, contents[face]);
    }
    return faces;
}

}  // namespace sl
