// SPDX-License-Identifier: MIT
#include "game/voxel/block_textures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "game/voxel/lattice_noise.h"

namespace sl {
namespace {

vec3 albedo(const std::vector<BlockTexture>& textures, BlockLayer layer) {
    return average_albedo(textures[static_cast<std::size_t>(layer)]);
}

std::uint64_t checksum(const std::vector<BlockTexture>& textures) {
    std::uint64_t hash = 0;
    for (const BlockTexture& texture : textures) {
        for (const auto& level : texture.mips) hash = hash_bytes(hash, level.data(), level.size());
    }
    return hash;
}

TEST(BlockTextures, HaveTheirMipChain) {
    const auto textures = make_block_textures(1);
    ASSERT_EQ(textures.size(), block_layer_count);
    for (const BlockTexture& texture : textures) {
        std::size_t size = block_texture_size;
        for (const auto& level : texture.mips) {
            EXPECT_EQ(level.size(), size * size * 4);
            for (std::size_t alpha = 3; alpha < level.size(); alpha += 4) EXPECT_EQ(level[alpha], 255);
            size /= 2;
        }
        EXPECT_EQ(size, 0u);
    }
}

TEST(BlockTextures, AreTheSameEverywhere) {
    EXPECT_EQ(checksum(make_block_textures(1)), 8173599922658585837ull);
    EXPECT_NE(checksum(make_block_textures(2)), checksum(make_block_textures(1)));
}

TEST(BlockTextures, ReflectWhatTheRealThingReflects) {
    const auto textures = make_block_textures(1);
    const struct {
        BlockLayer layer;
        vec3 expected;
    } cases[] = {
        {BlockLayer::grass_top, {0.10f, 0.22f, 0.05f}},  {BlockLayer::planks, {0.45f, 0.33f, 0.19f}},
        {BlockLayer::red_planks, {0.75f, 0.05f, 0.04f}}, {BlockLayer::snow, {0.86f, 0.87f, 0.87f}},
        {BlockLayer::stone, {0.29f, 0.29f, 0.30f}},      {BlockLayer::sand, {0.60f, 0.51f, 0.33f}},
        {BlockLayer::white_wool, {0.80f, 0.80f, 0.79f}}, {BlockLayer::dirt, {0.19f, 0.12f, 0.07f}},
    };
    for (const auto& [layer, expected] : cases) {
        const vec3 mean = albedo(textures, layer);
        for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(mean[channel], expected[channel], 0.015f);
    }
    for (const BlockTexture& texture : textures) {
        const vec3 mean = average_albedo(texture);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_GT(mean[channel], 0.015f);
            EXPECT_LT(mean[channel], 0.92f);
        }
    }
}

TEST(BlockTextures, SmallestLevelIsTheLinearMean) {
    for (const BlockTexture& texture : make_block_textures(5)) {
        const vec3 mean = average_albedo(texture);
        for (int channel = 0; channel < 3; ++channel) {
            const double linear = mean[channel];
            const double encoded =
                linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
            EXPECT_NEAR(texture.mips[4][static_cast<std::size_t>(channel)], 255.0 * encoded, 1.0);
        }
    }
}

TEST(BlockTextures, RowZeroIsTheBottom) {
    const auto textures = make_block_textures(1);
    const auto& side = textures[static_cast<std::size_t>(BlockLayer::grass_side)].mips[0];
    const std::size_t top_row = 15 * 16 * 4;
    for (std::size_t texel = 0; texel < 16 * 4; texel += 4) {
        EXPECT_GT(side[top_row + texel + 1], side[top_row + texel]) << "green on top";
        EXPECT_LT(side[texel + 1], side[texel]) << "brown below";
    }
}

TEST(LatticeNoise, RepeatsAndStaysInRange) {
    for (int y = -20; y < 20; ++y) {
        for (int x = -20; x < 20; ++x) {
            const int here = value_noise(9, x, y, 4, 2, 16);
            EXPECT_GE(here, 0);
            EXPECT_LT(here, 1024);
            EXPECT_EQ(here, value_noise(9, x + 16, y - 32, 4, 2, 16));
            EXPECT_LT(lattice_pick(3, x, y, 7), 7);
        }
    }
}

TEST(LatticeNoise, IsContinuousAcrossZero) {
    for (int x = -40; x < 40; ++x) {
        EXPECT_LT(std::abs(value_noise(4, x, 3, 16, 16) - value_noise(4, x + 1, 3, 16, 16)), 110);
    }
}

}  // namespace
}  // namespace sl
