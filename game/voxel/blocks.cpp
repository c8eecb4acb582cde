// SPDX-License-Identifier: MIT
#include "game/voxel/blocks.h"

#include "engine/core/check.h"

namespace sl {
namespace {

using Layer = BlockLayer;

constexpr std::array<Layer, block_face_count> all(Layer layer) {
    return {layer, layer, layer};
}

constexpr BlockInfo plain(std::string_view name, Layer layer, float roughness) {
    return {name, all(layer), roughness};
}

constexpr BlockInfo lamp(std::string_view name, Layer layer) {
    return {.name = name, .layers = all(layer), .roughness = 0.9f, .emissive_nit = 4000.0f};
}

constexpr std::array<BlockInfo, block_count> table{{
    {.name = "air", .layers = all(Layer::dirt), .opaque = false},
    {.name = "grass", .layers = {Layer::grass_top, Layer::grass_side, Layer::dirt}, .roughness = 0.95f},
    plain("dirt", Layer::dirt, 0.95f),
    plain("stone", Layer::stone, 0.85f),
    plain("sand", Layer::sand, 0.95f),
    {.name = "water", .layers = all(Layer::water), .roughness = 0.1f, .opaque = false},
    {.name = "log", .layers = {Layer::log_rings, Layer::log_bark, Layer::log_rings}, .roughness = 0.9f},
    plain("planks", Layer::planks, 0.8f),
    plain("leaves", Layer::leaves, 0.9f),
    plain("red_planks", Layer::red_planks, 0.8f),
    plain("cobblestone", Layer::cobblestone, 0.9f),
    plain("brick", Layer::brick, 0.9f),
    plain("snow", Layer::snow, 0.9f),
    plain("glass", Layer::glass, 0.1f),
    plain("white_wool", Layer::white_wool, 1.0f),
    plain("green_wool", Layer::green_wool, 1.0f),
    plain("blue_wool", Layer::blue_wool, 1.0f),
    plain("yellow_wool", Layer::yellow_wool, 1.0f),
    plain("red_wool", Layer::red_wool, 1.0f),
    plain("orange_wool", Layer::orange_wool, 1.0f),
    plain("black_wool", Layer::black_wool, 1.0f),
    lamp("glowstone", Layer::glowstone),
    {.name = "iron", .layers = all(Layer::iron), .roughness = 0.4f, .metallic = 1.0f},
    {.name = "gold", .layers = all(Layer::gold), .roughness = 0.3f, .metallic = 1.0f},
    lamp("red_lamp", Layer::red_lamp),
    lamp("green_lamp", Layer::green_lamp),
    lamp("blue_lamp", Layer::blue_lamp),
    lamp("amber_lamp", Layer::amber_lamp),
}};

}  // namespace

const BlockInfo& block_info(Block block) {
    const auto index = static_cast<std::size_t>(block);
    CHECK(index < table.size(), "block number {} of {}", index, table.size());
    return table[index];
}

std::optional<Block> block_by_name(std::string_view name) {
    for (std::size_t index = 0; index < table.size(); ++index) {
        if (table[index].name == name) return static_cast<Block>(index);
    }
    return std::nullopt;
}

std::vector<BlockMaterial> block_materials() {
    std::vector<BlockMaterial> materials;
    materials.reserve(block_material_count);
    for (const BlockInfo& info : table) {
        for (const Layer layer : info.layers) {
            materials.push_back(
                {static_cast<std::uint32_t>(layer), info.roughness, info.metallic, info.emissive_nit});
        }
    }
    return materials;
}

}  // namespace sl
