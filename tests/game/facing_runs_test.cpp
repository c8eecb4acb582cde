// SPDX-License-Identifier: MIT
#include "engine/render/scene/facing_runs.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "game/voxel/mesher.h"

namespace sl {
namespace {

MeshData rough_ground(std::uint32_t seed) {
    std::mt19937 random(seed);
    VoxelVolume volume(0.5f);
    for (int i = 0; i < 400; ++i) volume.set(ivec3(random() % 32, random() % 20, random() % 32), Block::stone);
    return mesh_chunk(volume, ivec3(0));
}

bool holds(const std::vector<IndexRun>& runs, std::uint32_t index) {
    return std::ranges::any_of(runs, [&](const IndexRun& run) { return index >= run.first && index < run.first + run.count; });
}

TEST(FacingRuns, HoldWhateverShowsItsFront) {
    const MeshData mesh = rough_ground(1);
    const std::array places{mat4(1.0f), glm::scale(glm::rotate(glm::translate(mat4(1.0f), vec3(3, -9, 4)), 0.7f, vec3(0.2f, 1, 0.4f)), vec3(1, 2, -0.5f))};
    std::mt19937 random(2);
    std::uniform_real_distribution<float> coordinate(-30.0f, 40.0f);
    for (int i = 0; i < 60; ++i) {
        const mat4& place = places[static_cast<std::size_t>(i % 2)];
        const vec4 eye(coordinate(random), coordinate(random), coordinate(random), i % 3 == 0 ? 0.0f : 1.0f);
        const auto runs = facing_runs(mesh, place, eye);
        for (std::uint32_t first = 0; first < mesh.indices.size(); first += 3) {
            const auto corner = [&](std::uint32_t number) { return vec3(place * vec4(mesh.vertices[mesh.indices[first + number]].position, 1.0f)); };
            const vec3 a = corner(0), cross = glm::cross(corner(1) - a, corner(2) - a);
            // As rasterization does: a mirror does not turn fronts into backs.
            const float front = glm::dot(cross, vec3(eye) - eye.w * a) * (glm::determinant(mat3(place)) < 0.0f ? -1.0f : 1.0f);
            if (front > 1e-3f) {
                ASSERT_TRUE(holds(runs, first)) << "triangle " << first / 3 << " seen from " << i;
            }
        }
    }
}

TEST(FacingRuns, LeaveOutWhatFacesAway) {
    const MeshData mesh = rough_ground(3);
    std::size_t count = 0;
    for (const IndexRun& run : facing_runs(mesh, mat4(1.0f), vec4(100, 100, 100, 1))) count += run.count;
    EXPECT_LT(count, mesh.indices.size() * 6 / 10) << "three of six sides";
    EXPECT_EQ(facing_runs(mesh, mat4(1.0f), vec4(0, 1, 0, 0)).size(), 1u);
}

TEST(FacingRuns, OfAMeshThatTellsNothingAll) {
    MeshData mesh = rough_ground(4);
    mesh.facings.clear();
    const auto runs = facing_runs(mesh, mat4(1.0f), vec4(0, -100, 0, 1));
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs.front().count, mesh.indices.size());
}

TEST(FacingRuns, WithoutAnInverseAll) {
    const MeshData mesh = rough_ground(5);
    std::size_t count = 0;
    for (const IndexRun& run : facing_runs(mesh, glm::scale(mat4(1.0f), vec3(1, 0, 1)), vec4(0, 9, 0, 1))) count += run.count;
    EXPECT_EQ(count, mesh.indices.size());
}

}  // namespace
}  // namespace sl
