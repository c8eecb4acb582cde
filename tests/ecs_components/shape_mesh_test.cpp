// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/shape_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace sl {
namespace {

using Kind = Shape::Kind;
constexpr std::array all_kinds{Kind::box, Kind::quad, Kind::disc, Kind::sphere, Kind::octahedron};

struct Triangle {
    std::array<Vertex, 3> corners;
    vec3 area_vector() const {
        return 0.5f * glm::cross(corners[1].position - corners[0].position,
                                 corners[2].position - corners[0].position);
    }
    vec3 normal() const {
        vec3 sum(0.0f);
        for (const Vertex& corner : corners) sum += unpack_normal(corner.normal);
        return glm::normalize(sum);
    }
};

std::vector<Triangle> triangles(const MeshData& mesh) {
    std::vector<Triangle> found;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        found.push_back({{mesh.vertices.at(mesh.indices[i]), mesh.vertices.at(mesh.indices[i + 1]),
                          mesh.vertices.at(mesh.indices[i + 2])}});
    }
    return found;
}

double area(const MeshData& mesh) {
    double sum = 0.0;
    for (const Triangle& triangle : triangles(mesh)) sum += glm::length(triangle.area_vector());
    return sum;
}

double volume(const MeshData& mesh) {
    double sum = 0.0;
    for (const Triangle& t : triangles(mesh)) sum += glm::dot(t.corners[0].position, t.area_vector()) / 3.0f;
    return sum;
}

/// Edges that are not met by exactly one in the other direction, corners compared by bits.
int open_edges(const MeshData& mesh) {
    const auto key = [](vec3 p) { return std::tuple(p.x, p.y, p.z); };
    std::map<std::pair<std::tuple<float, float, float>, std::tuple<float, float, float>>, int> balance;
    for (const Triangle& triangle : triangles(mesh)) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto a = key(triangle.corners[i].position), b = key(triangle.corners[(i + 1) % 3].position);
            ++balance[{a, b}];
            --balance[{b, a}];
        }
    }
    int open = 0;
    for (const auto& [edge, count] : balance) open += count != 0;
    return open;
}

TEST(ShapeMesh, WindingAgreesWithNormals) {
    for (const Kind kind : all_kinds) {
        const MeshData mesh = make_shape_mesh({kind, {1, 2, 3}});
        for (const Triangle& triangle : triangles(mesh)) {
            ASSERT_GT(glm::length(triangle.area_vector()), 1e-7f);
            ASSERT_GT(glm::dot(glm::normalize(triangle.area_vector()), triangle.normal()), 0.95f)
                << int(kind);
        }
    }
}

TEST(ShapeMesh, SolidsAreClosed) {
    EXPECT_EQ(open_edges(make_shape_mesh({Kind::box, {1, 2, 3}})), 0);
    EXPECT_EQ(open_edges(make_shape_mesh({Kind::sphere, {1, 2, 3}})), 0);
    EXPECT_EQ(open_edges(make_shape_mesh({Kind::disc, {1, 2, 3}})), 2 * 64);
}

TEST(ShapeMesh, BoxIsExact) {
    const MeshData box = make_shape_mesh({Kind::box, {1, 2, 3}});
    EXPECT_EQ(box.vertices.size(), 24u);
    EXPECT_EQ(box.indices.size(), 36u);
    EXPECT_FLOAT_EQ(static_cast<float>(area(box)), 22.0f);
    EXPECT_FLOAT_EQ(static_cast<float>(volume(box)), 6.0f);
    EXPECT_EQ(box.bounds.low, vec3(-0.5f, -1.0f, -1.5f));
    EXPECT_EQ(box.bounds.high, vec3(0.5f, 1.0f, 1.5f));
    for (const Vertex& vertex : box.vertices) EXPECT_EQ(glm::length(unpack_normal(vertex.normal)), 1.0f);
}

TEST(ShapeMesh, QuadAndDiscFaceUp) {
    for (const Kind kind : {Kind::quad, Kind::disc}) {
        const MeshData flat = make_shape_mesh({kind, {2, 7, 3}});
        for (const Triangle& triangle : triangles(flat)) EXPECT_GT(triangle.area_vector().y, 0.0f);
        for (const Vertex& vertex : flat.vertices) {
            EXPECT_EQ(vertex.position.y, 0.0f);
            EXPECT_EQ(unpack_normal(vertex.normal), vec3(0, 1, 0));
        }
    }
    EXPECT_NEAR(area(make_shape_mesh({Kind::quad, {2, 7, 3}})), 6.0, 1e-6);
    EXPECT_NEAR(area(make_shape_mesh({Kind::disc, {2, 7, 2}})), 3.14159, 0.006);
}

TEST(ShapeMesh, SphereLiesOnTheSphere) {
    const MeshData sphere = make_shape_mesh({Kind::sphere, vec3(2.0f)});
    for (const Vertex& vertex : sphere.vertices) {
        EXPECT_NEAR(glm::length(vertex.position), 1.0f, 1e-6f);
        EXPECT_GT(glm::dot(unpack_normal(vertex.normal), vertex.position), 0.99999f);
    }
    for (const Triangle& t : triangles(sphere)) {
        const vec3 middle = (t.corners[0].position + t.corners[1].position + t.corners[2].position) / 3.0f;
        EXPECT_GT(glm::length(middle), 1.0f - 1.0f / 400.0f);
    }
    EXPECT_NEAR(area(sphere) / (4.0 * 3.14159265), 1.0, 0.003);
    EXPECT_NEAR(volume(sphere) / (4.0 / 3.0 * 3.14159265), 1.0, 0.005);
}

TEST(ShapeMesh, EllipsoidNormalsStandOnTheSurface) {
    const MeshData mesh = make_shape_mesh({Kind::sphere, {2, 4, 6}});
    for (const Vertex& vertex : mesh.vertices) {
        const vec3 gradient = vertex.position / (vec3(1, 2, 3) * vec3(1, 2, 3));
        EXPECT_GT(glm::dot(unpack_normal(vertex.normal), glm::normalize(gradient)), 0.9999f);
    }
    EXPECT_EQ(mesh.bounds.high.y, 2.0f);
}

TEST(ShapeMesh, OddSizesAreHarmless) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    for (const Kind kind : all_kinds) {
        for (const vec3 size : {vec3(0.0f), vec3(0, 1, 1), vec3(1, 0, 0), vec3(-1.0f), vec3(infinite),
                                vec3(not_a_number, 1, 1), vec3(1e-30f), vec3(1e6f)}) {
            const MeshData mesh = make_shape_mesh({kind, size});
            for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
            for (const Vertex& vertex : mesh.vertices) {
                ASSERT_TRUE(std::isfinite(glm::dot(vertex.position, vec3(1.0f))));
                ASSERT_NEAR(glm::length(unpack_normal(vertex.normal)), 1.0f, 1e-5f);
            }
        }
    }
    EXPECT_EQ(area(make_shape_mesh({Kind::box, vec3(0.0f)})), 0.0);
}

}  // namespace
}  // namespace sl
