// SPDX-License-Identifier: MIT
#include "game/hall/hall.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include "engine/core/error.h"
#include "engine/core/model/read_model.h"
#include "engine/core/text_file.h"
#include "game/hall/hall_glb.h"

namespace sl {
namespace {

/// Coarse enough for many rays.
constexpr double coarse = 0.02;

mat4 matrix_of(const HallPlace& place) {
    mat4 matrix = glm::mat4_cast(glm::angleAxis(static_cast<float>(place.turn), vec3(0, 1, 0)));
    matrix[3] = vec4(vec3(place.position), 1.0f);
    return matrix;
}

struct Triangle {
    vec3 a, b, c;

    vec3 across() const { return glm::cross(b - a, c - a); }
    /// How far along a ray, in its lengths; negative where it passes by (Möller and Trumbore 1997).
    float hit(vec3 origin, vec3 direction) const {
        const vec3 p = glm::cross(direction, c - a), from = origin - a, q = glm::cross(from, b - a);
        const float inverse = 1.0f / glm::dot(b - a, p), u = glm::dot(from, p) * inverse, v = glm::dot(direction, q) * inverse;
        return u >= 0.0f && v >= 0.0f && u + v <= 1.0f ? glm::dot(c - a, q) * inverse : -1.0f;
    }
};

Triangle triangle_of(const HallMesh& mesh, std::size_t number) {
    const auto corner = [&](std::size_t i) { return mesh.positions[mesh.indices[3 * number + i]]; };
    return {corner(0), corner(1), corner(2)};
}

/// A part of a hall in world space.
struct PlacedPart {
    Bounds bounds;
    std::vector<Triangle> triangles;
};

std::vector<PlacedPart> placed_parts(const Hall& hall) {
    std::vector<PlacedPart> all;
    for (const HallPart& part : hall.parts) {
        for (const HallPlace& place : part.places) {
            const mat4 matrix = matrix_of(place);
            const auto moved = [&](vec3 point) { return vec3(matrix * vec4(point, 1.0f)); };
            PlacedPart& placed = all.emplace_back();
            for (std::size_t i = 0; i < part.mesh.triangles(); ++i) {
                const Triangle local = triangle_of(part.mesh, i);
                placed.triangles.push_back({moved(local.a), moved(local.b), moved(local.c)});
                for (const vec3 corner : {local.a, local.b, local.c}) placed.bounds.add(moved(corner));
            }
        }
    }
    return all;
}

/// The nearest triangle that a ray meets, on either side, and where; null where it leaves the hall.
const Triangle* nearest(const std::vector<PlacedPart>& parts, vec3 origin, vec3 direction, float& distance) {
    const Triangle* found = nullptr;
    distance = 1e9f;
    for (const PlacedPart& part : parts) {
        if (!part.bounds.grown(1e-3f).meets(origin, direction, distance)) continue;
        for (const Triangle& triangle : part.triangles) {
            const float at = triangle.hit(origin, direction);
            if (at <= 1e-4f || at >= distance) continue;
            distance = at;
            found = &triangle;
        }
    }
    return found;
}

/// Points on a sphere, evenly spread (a golden spiral).
vec3 spread_direction(int number, int count) {
    const float y = 1.0f - (2.0f * static_cast<float>(number) + 1.0f) / static_cast<float>(count), round = std::sqrt(1.0f - y * y), angle = 2.3999632f * static_cast<float>(number);
    return {round * std::cos(angle), y, round * std::sin(angle)};
}

bool through_opening(vec3 origin, vec3 direction) {
    if (direction.y <= 0.0f) return false;
    const auto within = [&](double height) {
        const dvec3 at = dvec3(origin) + dvec3(direction) * ((height - origin.y) / direction.y);
        return at.x >= hall_opening_low.x && at.x <= hall_opening_high.x && at.z >= hall_opening_low.z && at.z <= hall_opening_high.z;
    };
    return within(hall_opening_low.y) && within(hall_opening_high.y);
}

TEST(Hall, HasTheTrianglesThatAreAskedFor) {
    EXPECT_NEAR(static_cast<double>(make_hall(1.0, 1).triangles()), static_cast<double>(usual_hall_triangles), 0.01 * usual_hall_triangles);
    for (const std::uint64_t wanted : {40000ull, 100000ull, 260000ull, 1000000ull}) {
        EXPECT_NEAR(static_cast<double>(make_hall_of(wanted, 1).triangles()), static_cast<double>(wanted), 0.05 * static_cast<double>(wanted));
    }
    EXPECT_THROW((void)make_hall_of(10, 1), Error);
    EXPECT_THROW((void)make_hall_of(10'000'000'000, 1), Error);
}

TEST(Hall, FinerHallsHaveMoreTriangles) {
    std::uint64_t last = 0;
    for (double detail = 0.001; detail < 5.0; detail *= 1.3) {
        const std::uint64_t now = make_hall(detail, 1).triangles();
        EXPECT_GE(now, last) << detail;
        last = now;
    }
}

TEST(Hall, TrianglesHaveAnAreaAndUnitNormalsOnTheirFront) {
    for (const double detail : {0.001, coarse, 1.0, 4.0}) {
        for (const HallPart& part : make_hall(detail, 3).parts) {
            const HallMesh& mesh = part.mesh;
            ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
            ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
            for (const vec3 normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f) << part.name;
            for (std::size_t i = 0; i < mesh.triangles(); ++i) {
                const vec3 across = triangle_of(mesh, i).across();
                ASSERT_GT(glm::length(across), 1e-10f) << part.name << ", detail " << detail;
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    ASSERT_GT(glm::dot(across, mesh.normals[mesh.indices[3 * i + corner]]), 0.0f) << part.name << ", detail " << detail << ", triangle " << i;
                }
            }
        }
    }
}

TEST(Hall, LightLeavesItThroughItsRoofAlone) {
    const Hall hall = make_hall(coarse, 1);
    const std::vector<PlacedPart> parts = placed_parts(hall);
    // In the court, in the walks below the gallery and their corners, and on the gallery.
    const std::vector<vec3> places{{0.3f, 1.7f, 0.2f}, {6.1f, 1.7f, 1.9f}, {-6.3f, 2.9f, -13.8f}, {1.8f, 1.4f, 14.2f}, {-6.2f, 7.1f, 3.3f}, {0.9f, 9.2f, -14.1f}};
    constexpr int rays = 2000;
    int open = 0;
    for (const vec3 place : places) {
        for (int i = 0; i < rays; ++i) {
            const vec3 direction = spread_direction(i, rays);
            float distance = 0.0f;
            const Triangle* hit = nearest(parts, place, direction, distance);
            if (hit != nullptr) continue;
            ++open;
            EXPECT_TRUE(through_opening(place, direction)) << fmt::format("from {} {} {} towards {} {} {}", place.x, place.y, place.z, direction.x, direction.y, direction.z);
        }
    }
    EXPECT_GT(open, rays / 50) << "the roof is open";
}

TEST(Hall, WhatIsSeenFromInsideIsAFront) {
    const Hall hall = make_hall(coarse, 1);
    Hall without_cloth = hall;
    std::erase_if(without_cloth.parts, [&](const HallPart& part) { return hall.materials[static_cast<std::size_t>(part.material)].two_sided; });
    const std::vector<PlacedPart> parts = placed_parts(without_cloth);
    constexpr int rays = 1500;
    for (const vec3 place : {vec3(0.3f, 1.7f, 0.2f), vec3(6.1f, 1.7f, 1.9f), vec3(-6.3f, 2.6f, -13.8f), vec3(-6.2f, 7.1f, 3.3f)}) {
        for (int i = 0; i < rays; ++i) {
            const vec3 direction = spread_direction(i, rays);
            float distance = 0.0f;
            const Triangle* hit = nearest(parts, place, direction, distance);
            if (hit == nullptr) continue;
            EXPECT_LT(glm::dot(hit->across(), direction), 0.0f) << fmt::format("at {} {} {}", hit->a.x, hit->a.y, hit->a.z);
        }
    }
}

TEST(Hall, TheSunFallsInAndCamerasStandInTheOpen) {
    const Hall hall = make_hall(coarse, 1);
    const std::vector<PlacedPart> parts = placed_parts(hall);
    int lit = 0;
    constexpr int points = 400;
    for (int i = 0; i < points; ++i) {
        const vec3 floor(-3.4f + 6.8f * static_cast<float>(i % 20) / 20.0f, 0.02f, -11.0f + 22.0f * static_cast<float>(i / 20) / 20.0f);
        float distance = 0.0f;
        lit += nearest(parts, floor, -vec3(glm::normalize(hall.sun.towards)), distance) == nullptr ? 1 : 0;
    }
    EXPECT_GT(lit, points / 20);
    EXPECT_LT(lit, points * 3 / 4);
    ASSERT_EQ(hall.cameras.size(), 3u);
    for (const HallCamera& camera : hall.cameras) {
        for (int i = 0; i < 200; ++i) {
            float distance = 0.0f;
            (void)nearest(parts, vec3(camera.eye), spread_direction(i, 200), distance);
            EXPECT_GT(distance, 0.25f) << camera.name;
        }
    }
}

TEST(Hall, TheSameNumbersGiveTheSameBytes) {
    const std::string first = hall_glb(make_hall(coarse, 7));
    EXPECT_TRUE(first == hall_glb(make_hall(coarse, 7)));
    EXPECT_FALSE(first == hall_glb(make_hall(coarse, 8)));
}

TEST(Hall, IsReadAsItWasMade) {
    const auto path = std::filesystem::temp_directory_path() / fmt::format("sl_hall_{}.glb", ::getpid());
    const Hall hall = make_hall(coarse, 1);
    write_text_file(path, hall_glb(hall));
    const Model model = read_model(path);
    std::filesystem::remove(path);
    EXPECT_THAT(model.warnings, testing::IsEmpty());
    std::uint64_t triangles = 0;
    for (const ModelNode& node : model.nodes) {
        if (node.mesh < 0) continue;
        for (const ModelPrimitive& primitive : model.meshes[static_cast<std::size_t>(node.mesh)].primitives) triangles += primitive.mesh.indices.size() / 3;
    }
    EXPECT_EQ(triangles, hall.triangles());
    EXPECT_EQ(model.cameras.size(), hall.cameras.size());
    ASSERT_EQ(model.lights.size(), 1u);
    EXPECT_EQ(model.lights[0].kind, ModelLight::Kind::directional);
    EXPECT_FLOAT_EQ(model.lights[0].intensity, static_cast<float>(hall.sun.illuminance));
    EXPECT_EQ(model.images.size(), hall.pictures.size());
    // Cameras look along -z of their nodes.
    const auto places = places_of(model, model.scene);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i].camera < 0) continue;
        const HallCamera& camera = hall.cameras[static_cast<std::size_t>(model.nodes[i].camera)];
        const vec3 forward = -vec3((*places[i])[2]), wanted(glm::normalize(camera.target - camera.eye));
        EXPECT_LT(glm::length(forward - wanted), 1e-5f) << camera.name;
    }
}

}  // namespace
}  // namespace sl
