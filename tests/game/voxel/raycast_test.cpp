// SPDX-License-Identifier: MIT
#include "game/voxel/raycast.h"

#include <gtest/gtest.h>

#include <limits>

#include "game/voxel/lattice_noise.h"

namespace sl {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float size = 0.5f;

VoxelVolume random_volume(int share) {
    VoxelVolume volume(size);
    for (int y = -6; y < 7; ++y) {
        for (int z = -6; z < 7; ++z) {
            for (int x = -6; x < 7; ++x) {
                if (lattice_pick(static_cast<std::uint32_t>(y + 50), x, z, 1024) < share) {
                    volume.set({x, y, z}, Block::stone);
                }
            }
        }
    }
    return volume;
}

/// Distance in metres to the nearest of all blocks, each cut by itself; negative when none is hit.
double nearest_by_slabs(const VoxelVolume& volume, vec3 origin, vec3 direction) {
    double best = -1.0;
    const dvec3 along = glm::normalize(dvec3(direction));
    for (int y = -6; y < 7; ++y) {
        for (int z = -6; z < 7; ++z) {
            for (int x = -6; x < 7; ++x) {
                if (volume.get({x, y, z}) == Block::air) continue;
                const dvec3 a = (dvec3(x, y, z) * double{size} - dvec3(origin)) / along;
                const dvec3 b = (dvec3(x + 1, y + 1, z + 1) * double{size} - dvec3(origin)) / along;
                const dvec3 near = glm::min(a, b);
                const dvec3 far = glm::max(a, b);
                const double enter = std::max({near.x, near.y, near.z, 0.0});
                const double leave = std::min({far.x, far.y, far.z});
                if (enter < leave && (best < 0.0 || enter < best)) best = enter;
            }
        }
    }
    return best;
}

/// First block met by tiny steps.
std::optional<ivec3> first_by_marching(const VoxelVolume& volume, vec3 origin, vec3 direction, double end) {
    const dvec3 along = glm::normalize(dvec3(direction));
    for (double t = 0.0; t < end; t += 2e-4) {
        const ivec3 cell(glm::floor((dvec3(origin) + t * along) / double{size}));
        if (volume.get(cell) != Block::air) return cell;
    }
    return std::nullopt;
}

vec3 random_vector(std::uint32_t number, float extent) {
    vec3 result(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = extent * (static_cast<float>(lattice_pick(number, axis, 7, 20001)) / 10000.0f - 1.0f);
    }
    return result;
}

TEST(Raycast, AgreesWithEveryBlockCutAlone) {
    for (const int share : {20, 200, 700}) {
        const VoxelVolume volume = random_volume(share);
        for (std::uint32_t number = 0; number < 1500; ++number) {
            const vec3 origin = random_vector(number, 6.0f);
            const vec3 direction = random_vector(number + 100000, 1.0f);
            const double expected = nearest_by_slabs(volume, origin, direction);
            const auto hit = raycast(volume, origin, direction, infinity);
            ASSERT_EQ(hit.has_value(), expected >= 0.0) << number;
            if (!hit) continue;
            ASSERT_NEAR(hit->distance, expected, 1e-4) << number;
            EXPECT_EQ(volume.get(hit->cell), hit->block);
            EXPECT_NEAR(glm::distance(hit->position, origin + glm::normalize(direction) * hit->distance),
                        0.0f, 1e-4f);
            if (hit->distance > 0.0f) {
                EXPECT_LT(glm::dot(vec3(hit->normal), direction), 0.0f);
                EXPECT_EQ(std::abs(hit->normal.x) + std::abs(hit->normal.y) + std::abs(hit->normal.z), 1);
            }
        }
    }
}

TEST(Raycast, AgreesWithMarching) {
    const VoxelVolume volume = random_volume(100);
    int compared = 0;
    for (std::uint32_t number = 0; number < 200; ++number) {
        const vec3 origin = random_vector(number, 3.0f);
        const vec3 direction = random_vector(number + 100000, 1.0f);
        const auto hit = raycast(volume, origin, direction, 5.0f);
        const auto marched = first_by_marching(volume, origin, direction, 5.0);
        // A march steps over corners that it cuts by less than a step: only then may the cast's block be
        // nearer.
        if (hit && marched && hit->cell == *marched) ++compared;
        if (!hit) {
            EXPECT_FALSE(marched.has_value()) << number;
        }
    }
    EXPECT_GT(compared, 90);
}

TEST(Raycast, AxisParallelFromBothSides) {
    VoxelVolume volume(size);
    volume.set({-3, 1, 2}, Block::brick);
    const vec3 middle = (vec3(-3, 1, 2) + 0.5f) * size;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.0f, 1.0f}) {
            vec3 away(0.0f);
            away[axis] = sign * 40.0f;
            const auto hit = raycast(volume, middle + away, -away, infinity);
            ASSERT_TRUE(hit.has_value());
            EXPECT_EQ(hit->cell, ivec3(-3, 1, 2));
            EXPECT_EQ(hit->block, Block::brick);
            EXPECT_EQ(hit->normal[axis], static_cast<int>(sign));
            EXPECT_NEAR(hit->distance, 40.0f - 0.5f * size, 1e-4f);
            EXPECT_FALSE(raycast(volume, middle + away, away, infinity).has_value());
        }
    }
}

TEST(Raycast, StartsInside) {
    VoxelVolume volume(size);
    volume.set({0, 0, 0}, Block::gold);
    const auto hit = raycast(volume, vec3(0.2f), {1, 2, 3}, 1.0f);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->distance, 0.0f);
    EXPECT_EQ(hit->normal, ivec3(0));
    EXPECT_EQ(hit->position, vec3(0.2f));
}

TEST(Raycast, LeavingAFaceDoesNotHitItsBlock) {
    VoxelVolume volume(size);
    volume.set({0, 0, 0}, Block::gold);
    volume.set({0, 4, 0}, Block::iron);
    const auto up = raycast(volume, {0.25f, 0.5f, 0.25f}, {0, 1, 0}, infinity);
    ASSERT_TRUE(up.has_value());
    EXPECT_EQ(up->block, Block::iron);
    const auto down = raycast(volume, {0.25f, 0.5f, 0.25f}, {0, -1, 0}, infinity);
    ASSERT_TRUE(down.has_value());
    EXPECT_EQ(down->block, Block::gold);
    EXPECT_EQ(down->distance, 0.0f);
    const auto away = raycast(volume, {0.25f, 0.0f, 0.25f}, {0, -1, 0}, infinity);
    EXPECT_FALSE(away.has_value());
}

TEST(Raycast, EndsAtTheGivenDistance) {
    VoxelVolume volume(size);
    volume.set({4, 0, 0}, Block::gold);
    const vec3 origin(0.25f);
    EXPECT_FALSE(raycast(volume, origin, {1, 0, 0}, 1.74f).has_value());
    EXPECT_TRUE(raycast(volume, origin, {1, 0, 0}, 1.76f).has_value());
    EXPECT_TRUE(raycast(volume, origin, {0.01f, 0, 0}, 1.76f).has_value())
        << "distance is metres, not multiples";
    EXPECT_FALSE(raycast(volume, origin, {1, 0, 0}, -1.0f).has_value());
}

TEST(Raycast, SenselessRaysHitNothing) {
    VoxelVolume volume(size);
    volume.set({0, 0, 0}, Block::gold);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(raycast(volume, vec3(0.2f), vec3(0.0f), 5.0f).has_value());
    EXPECT_FALSE(raycast(volume, vec3(0.2f), vec3(nan, 1, 0), 5.0f).has_value());
    EXPECT_FALSE(raycast(volume, vec3(infinity, 0, 0), vec3(1, 0, 0), 5.0f).has_value());
    EXPECT_FALSE(raycast(volume, vec3(0.2f), vec3(1, 0, 0), nan).has_value());
    EXPECT_FALSE(raycast(VoxelVolume(), vec3(0.2f), vec3(1, 0, 0), infinity).has_value());
}

TEST(Raycast, PassesThroughWhatIsFree) {
    VoxelVolume volume(1.0f);
    volume.set({0, 2, 0}, Block::water);
    volume.set({0, 0, 0}, Block::stone);
    const vec3 above(0.5f, 5.0f, 0.5f), down(0, -1, 0);
    EXPECT_EQ(raycast(volume, above, down, infinity)->cell, ivec3(0, 2, 0));
    const auto hit = raycast(volume, above, down, infinity, Block::water);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->cell, ivec3(0, 0, 0));
    EXPECT_EQ(hit->normal, ivec3(0, 1, 0));
}

}  // namespace
}  // namespace sl
