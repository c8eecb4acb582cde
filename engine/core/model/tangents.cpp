// SPDX-License-Identifier: MIT
#include "engine/core/model/tangents.h"

#include <cmath>

namespace sl {

namespace {

constexpr std::uint32_t none = ~0u;

vec3 unit_or_zero(vec3 v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : vec3(0.0f);
}

/// How the texture lies on a triangle: where its right is, unit, and whether it is seen mirrored. Zero where it has no extent.
struct TextureAxes {
    vec3 right{0.0f};
    float hand = 1.0f;
};

class TangentMaker {
  public:
    TangentMaker(ModelPrimitive& primitive, const ModelTexture& texture)
        : primitive_(primitive), mesh_(primitive.mesh), texture_(texture), hands_(mesh_.vertices.size(), 0.0f),
          twins_(mesh_.vertices.size(), none), sums_(mesh_.vertices.size(), vec3(0.0f)) {}

    void run() {
        for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) add_triangle(i);
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            const vec3 normal = unpack_normal(mesh_.vertices[i].normal);
            const vec3 tangent = unit_or_zero(along(sums_[i], normal));
            mesh_.pictured[i].tangent = pack_normal(tangent != vec3(0.0f) ? tangent : any_along(normal));
            mesh_.pictured[i].hand = hands_[i] < 0.0f ? -1.0f : 1.0f;
        }
    }

  private:
    static vec3 along(vec3 v, vec3 normal) { return v - normal * glm::dot(v, normal); }
    static vec3 any_along(vec3 normal) {
        return glm::normalize(along(std::abs(normal.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 0, 1), normal));
    }
    vec2 place(std::uint32_t vertex) const {
        const vec2 uv = texture_.second_uv ? mesh_.pictured[vertex].uv : mesh_.vertices[vertex].uv;
        return texture_.transform[0] * uv.x + texture_.transform[1] * uv.y;
    }
    TextureAxes axes_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const vec3 origin = mesh_.vertices[a].position, to_b = mesh_.vertices[b].position - origin, to_c = mesh_.vertices[c].position - origin;
        const vec2 uv_b = place(b) - place(a), uv_c = place(c) - place(a);
        const float area = uv_b.x * uv_c.y - uv_b.y * uv_c.x;
        // v runs down: seen as the texture is, corners turn the other way.
        const float hand = area < 0.0f ? 1.0f : -1.0f;
        return {.right = unit_or_zero((to_c * uv_b.y - to_b * uv_c.y) * hand), .hand = hand};
    }
    void add_triangle(std::size_t first) {
        const std::array<std::uint32_t, 3> corners{mesh_.indices[first], mesh_.indices[first + 1], mesh_.indices[first + 2]};
        const TextureAxes axes = axes_of(corners[0], corners[1], corners[2]);
        if (axes.right == vec3(0.0f)) return;
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3 at = mesh_.vertices[corners[k]].position, normal = unpack_normal(mesh_.vertices[corners[k]].normal);
            const vec3 one = unit_or_zero(along(mesh_.vertices[corners[(k + 1) % 3]].position - at, normal));
            const vec3 other = unit_or_zero(along(mesh_.vertices[corners[(k + 2) % 3]].position - at, normal));
            const std::uint32_t vertex = vertex_with(corners[k], axes.hand);
            mesh_.indices[first + k] = vertex;
            // Weighed by the angle, so that it does not matter how a surface is cut into triangles.
            sums_[vertex] += unit_or_zero(along(axes.right, normal)) * std::acos(glm::clamp(glm::dot(one, other), -1.0f, 1.0f));
        }
    }
    /// The vertex itself, or its twin where triangles of the other hand have it.
    std::uint32_t vertex_with(std::uint32_t vertex, float hand) {
        if (hands_[vertex] == 0.0f) hands_[vertex] = hand;
        if (hands_[vertex] == hand) return vertex;
        if (twins_[vertex] == none) {
            twins_[vertex] = static_cast<std::uint32_t>(mesh_.vertices.size());
            primitive_.visit_vertex_arrays([&](auto& values) {
                if (values.empty()) return;
                const auto copy = values[vertex];
                values.push_back(copy);
            });
            hands_.push_back(hand);
            twins_.push_back(vertex);
            sums_.emplace_back(0.0f);
        }
        return twins_[vertex];
    }

    ModelPrimitive& primitive_;
    MeshData& mesh_;
    const ModelTexture& texture_;
    std::vector<float> hands_;          ///< 0: no triangle has it yet
    std::vector<std::uint32_t> twins_;
    std::vector<vec3> sums_;
};

}  // namespace

void make_tangents(ModelPrimitive& primitive, const ModelTexture& normal_texture) { TangentMaker(primitive, normal_texture).run(); }

}  // namespace sl
