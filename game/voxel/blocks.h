// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace sl {

/// What fills one cell. Saved worlds hold these numbers: add new kinds at the end.
enum class Block : std::uint8_t {
    air,
    grass,
    dirt,
    stone,
    sand,
    water,
    log,
    planks,
    leaves,
    red_planks,
    cobblestone,
    brick,
    snow,
    glass,
    white_wool,
    green_wool,
    blue_wool,
    yellow_wool,
    red_wool,
    orange_wool,
    black_wool,
    glowstone,
    iron,
    gold,
    red_lamp,
    green_lamp,
    blue_lamp,
    amber_lamp,
};
inline constexpr std::uint32_t block_count = 28;

/// One picture of make_block_textures; the number is the layer of the texture array.
enum class BlockLayer : std::uint8_t {
    grass_top,
    grass_side,
    dirt,
    stone,
    sand,
    water,
    log_rings,
    log_bark,
    planks,
    leaves,
    red_planks,
    cobblestone,
    brick,
    snow,
    glass,
    white_wool,
    green_wool,
    blue_wool,
    yellow_wool,
    red_wool,
    orange_wool,
    black_wool,
    glowstone,
    iron,
    gold,
    red_lamp,
    green_lamp,
    blue_lamp,
    amber_lamp,
};
inline constexpr std::uint32_t block_layer_count = 29;

/// The three kinds of face that may look different: +y, the four sides, -y.
enum class BlockFace : std::uint8_t { top, side, bottom };
inline constexpr std::uint32_t block_face_count = 3;

struct BlockInfo {
    std::string_view name;
    std::array<BlockLayer, block_face_count> layers{};  ///< by BlockFace
    float roughness = 0.9f;                             ///< perceptual, 0 to 1
    float metallic = 0.0f;                              ///< 0 or 1
    float emissive_nit = 0.0f;                          ///< luminance of the face, cd/m2
    bool opaque = true;  ///< hides the faces behind it; for now glass too
};

const BlockInfo& block_info(Block block);

/// The block that block_info calls `name` ("red_planks").
std::optional<Block> block_by_name(std::string_view name);

/// What a renderer needs to know of one kind of face. Base colour comes from the texture layer.
struct BlockMaterial {
    std::uint32_t texture_layer = 0;
    float roughness = 0.0f;
    float metallic = 0.0f;
    float emissive_nit = 0.0f;
    bool operator==(const BlockMaterial&) const = default;
};

inline constexpr std::uint32_t block_material_count = block_count * block_face_count;

/// Index of a face's material in block_materials(): block * 3 + face. This is what mesh_chunk writes to
/// Vertex.material.
constexpr std::uint32_t material_index(Block block, BlockFace face) {
    return static_cast<std::uint32_t>(block) * block_face_count + static_cast<std::uint32_t>(face);
}

/// block_material_count materials, ordered by material_index. Those of air are there and unused.
std::vector<BlockMaterial> block_materials();

}  // namespace sl
