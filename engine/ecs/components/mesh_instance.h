// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/core/mesh_data.h"
#include "engine/ecs/components/material.h"
#include "shared/pictures.h"

namespace sl {

/// One row of what shaders know as a material: a Material, and a texture that multiplies its base colour.
struct MaterialEntry {
    Material material;
    std::int32_t texture_layer = -1;  ///< layer of the BlockTextures array; -1 is plain
    std::optional<PictureParams> pictures{};  ///< layers of a PictureTable; of meshes with one material
    /// Shown in its base colour whatever light there is; to light it is black. Needs `pictures`, be it without layers.
    bool unlit = false;
};

/// Materials shared by many meshes (a block palette, a model's material list), a resource. Vertex.material counts from
/// MeshInstance::first_material.
struct MaterialTable {
    std::vector<MaterialEntry> entries;
    std::uint32_t version = 0;
};

/// Square RGBA8 sRGB pictures of one size with their mips, as one array texture; a resource. Layer after layer, each
/// with all its mips, bottom row first.
struct TextureLayers {
    std::uint32_t size = 1;
    std::uint32_t mips = 1;
    std::vector<std::vector<std::uint8_t>> layers;
    std::uint32_t version = 0;
};

/// The pictures that materials read, a resource: colours (sRGB, alpha), and data, which are linear. Top row first.
struct PictureTable {
    std::shared_ptr<const TextureLayers> colours, data;  ///< null where there are none
    std::uint32_t version = 0;
};

/// Draws a mesh at the entity's WorldTransform. Made by systems, not by people, so it has no fields.
struct MeshInstance {
    static constexpr std::int32_t own_material = -1;
    MeshHandle mesh;
    std::int32_t first_material = own_material;  ///< row in MaterialTable, or the entity's Material component
};

}  // namespace sl
