// SPDX-License-Identifier: MIT
#include "game/voxel/blocks.h"

#include <gtest/gtest.h>

#include <set>

namespace sl {
namespace {

TEST(Blocks, EveryNameIsFoundAndUnique) {
    std::set<std::string_view> names;
    for (std::uint32_t number = 0; number < block_count; ++number) {
        const auto block = static_cast<Block>(number);
        const BlockInfo& info = block_info(block);
        EXPECT_FALSE(info.name.empty()) << number;
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_EQ(block_by_name(info.name), block);
        EXPECT_EQ(info.opaque, block != Block::air && block != Block::water) << info.name;
        EXPECT_GE(info.roughness, 0.0f);
        EXPECT_LE(info.roughness, 1.0f);
    }
    EXPECT_EQ(block_by_name("amber_lamp"), static_cast<Block>(block_count - 1)) << "the count covers the last kind";
    EXPECT_EQ(block_by_name("glowstone"), Block::glowstone) << "the table follows the enumeration";
    EXPECT_FALSE(block_by_name("cheese").has_value());
}

TEST(Blocks, MaterialsFollowTheirIndex) {
    const std::vector<BlockMaterial> materials = block_materials();
    ASSERT_EQ(materials.size(), block_material_count);
    const BlockMaterial& side = materials[material_index(Block::grass, BlockFace::side)];
    EXPECT_EQ(side.texture_layer, static_cast<std::uint32_t>(BlockLayer::grass_side));
    const BlockMaterial& under = materials[material_index(Block::grass, BlockFace::bottom)];
    EXPECT_EQ(under.texture_layer, static_cast<std::uint32_t>(BlockLayer::dirt));
    EXPECT_GT(materials[material_index(Block::glowstone, BlockFace::top)].emissive_nit, 1000.0f);
    EXPECT_EQ(materials[material_index(Block::iron, BlockFace::top)].metallic, 1.0f);
    for (const BlockMaterial& material : materials) EXPECT_LT(material.texture_layer, block_layer_count);
}

}  // namespace
}  // namespace sl
