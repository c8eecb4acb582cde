// SPDX-License-Identifier: MIT
#include "editor/see/probed_point.h"

#include <cmath>

#include "shared/octahedral.h"

namespace sl {

namespace {

/// What is farther behind a pixel's surface than this share of its distance is hidden by it: slanted surfaces change that
/// much within a pixel.
constexpr float hidden_behind = 0.02f;
/// How far from a mesh's triangles a depth buffer may put a point, over the coordinates' size.
constexpr float tolerance = 1e-3f;

/// Squared distance from a point to a triangle (Ericson 2005, 5.1.5, by clamping to edges).
float squared_distance(vec3 point, const std::array<vec3, 3>& corners) {
    const vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    bool inside = glm::dot(normal, normal) > 0.0f;
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < 3; ++i) {
        const vec3 from = corners[i], edge = corners[(i + 1) % 3] - from, offset = point - from;
        const float along = glm::clamp(glm::dot(offset, edge) / std::max(glm::dot(edge, edge), 1e-30f), 0.0f, 1.0f);
        const vec3 beside = offset - along * edge;
        nearest = std::min(nearest, glm::dot(beside, beside));
        inside &= glm::dot(glm::cross(edge, offset), normal) >= 0.0f;
    }
    if (!inside) return nearest;
    const float height = glm::dot(point - corners[0], normal);
    return height * height / glm::dot(normal, normal);
}

float squared_distance(const RenderScene& scene, const RenderScene::Draw& draw, vec3 point) {
    const MeshData& mesh = scene.meshes->at(draw.mesh);
    const auto corner = [&](std::size_t index) { return vec3(draw.world_from_local * vec4(mesh.vertices[mesh.indices[index]].position, 1.0f)); };
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) nearest = std::min(nearest, squared_distance(point, {corner(i), corner(i + 1), corner(i + 2)}));
    return nearest;
}

}  // namespace

std::optional<ProbedPoint> point_under(const FrameParams& frame, const dvec3& origin, uvec2 pixel, float depth, vec2 encoded_normal) {
    if (!(depth > 0.0f)) return std::nullopt;
    const vec2 at = (vec2(pixel) + 0.5f) / vec2(frame.ray_right.w, frame.ray_up.w);
    const vec3 ray = view_ray(frame, vec2(2.0f * at.x - 1.0f, 1.0f - 2.0f * at.y));
    const vec3 position = vec3(frame.camera_position) + ray * view_distance(depth, frame.camera_position.w);
    return ProbedPoint{origin + dvec3(position), octahedral_decode(encoded_normal * 2.0f - 1.0f)};
}

std::optional<SeenAt> seen_at(const FrameParams& frame, const dvec3& origin, const dvec3& position) {
    const vec3 offset = vec3(position - origin) - vec3(frame.camera_position);
    const float distance = glm::dot(offset, vec3(frame.ray_forward));
    if (distance <= frame.camera_position.w) return std::nullopt;
    const auto share = [&](const vec4& ray) { return glm::dot(offset, vec3(ray)) / (glm::dot(vec3(ray), vec3(ray)) * distance); };
    const vec2 at(0.5f + 0.5f * share(frame.ray_right), 0.5f - 0.5f * share(frame.ray_up));
    if (!(glm::all(glm::greaterThanEqual(at, vec2(0.0f))) && glm::all(glm::lessThan(at, vec2(1.0f))))) return std::nullopt;
    return SeenAt{uvec2(at * vec2(frame.ray_right.w, frame.ray_up.w)), distance};
}

bool is_visible(const FrameParams& frame, const SeenAt& place, float depth) {
    return !(depth > 0.0f) || place.distance <= view_distance(depth, frame.camera_position.w) * (1.0f + hidden_behind);
}

float clearance(vec3 position) { return 1e-3f + 1e-5f * glm::length(position); }

Entity entity_at(const RenderScene& scene, vec3 position) {
    const float reach = tolerance * std::max(1.0f, glm::length(position));
    float nearest = reach * reach;
    Entity result;
    for (const RenderScene::Draw& draw : scene.draws) {
        if (!draw.bounds.grown(reach).contains(position)) continue;
        if (const float distance = squared_distance(scene, draw, position); distance < nearest) {
            nearest = distance;
            result = draw.entity;
        }
    }
    return result;
}

}  // namespace sl
