// SPDX-License-Identifier: MIT
#include "game/app/hud_blocks.h"

#include <imgui.h>

#include <cmath>

#include "editor/projection.h"
#include "engine/ecs/components.h"
#include "game/block_tool.h"
#include "game/session.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

constexpr ImU32 dark = IM_COL32(0, 0, 0, 130), frame = IM_COL32(255, 255, 255, 230), outline = IM_COL32(0, 0, 0, 170);
/// Texels per side of a block's picture here: the second level of its texture.
constexpr std::uint32_t picture_texels = 8;

/// Of the second level of a texture layer, row after row.
ImU32 texel(const TextureLayers& textures, std::size_t layer, std::uint32_t x, std::uint32_t y) {
    const std::size_t first_level = std::size_t{4} * textures.size * textures.size;
    const std::uint8_t* bytes = &textures.layers[layer][first_level + 4 * (std::size_t{y} * picture_texels + x)];
    return IM_COL32(bytes[0], bytes[1], bytes[2], 255);
}

void picture_of(const TextureLayers& textures, Block block, ImVec2 at, float size) {
    const auto layer = static_cast<std::size_t>(block_info(block).layers[static_cast<std::size_t>(BlockFace::side)]);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float step = size / picture_texels;
    for (std::uint32_t y = 0; y < picture_texels; ++y) {
        for (std::uint32_t x = 0; x < picture_texels; ++x) {
            // Rounded alike on both sides of a seam, so that none shows.
            const auto edge = [&](float start, std::uint32_t number) { return std::round(start + step * static_cast<float>(number)); };
            // The first row of a texture is the lowest.
            list.AddRectFilled(ImVec2(edge(at.x, x), edge(at.y, y)), ImVec2(edge(at.x, x + 1), edge(at.y, y + 1)), texel(textures, layer, x, picture_texels - 1 - y));
        }
    }
}

}  // namespace

void draw_hotbar(World& world) {
    const auto* textures = world.find_resource<TextureLayers>();
    if (textures == nullptr || textures->size != 2 * picture_texels || world.resource<VoxelStats>().chunks == 0) return;
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float size = std::round(ImGui::GetFontSize() * 2.0f), gap = std::round(size * 0.15f), slot = size + 2.0f * gap;
    const auto count = static_cast<float>(block_palette.size());
    const ImVec2 corner(std::round(screen.GetCenter().x - 0.5f * count * slot), std::round(screen.Size.y - slot - gap));
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(corner, ImVec2(corner.x + count * slot, corner.y + slot), dark, gap);
    for (std::size_t i = 0; i < block_palette.size(); ++i) {
        const ImVec2 at(corner.x + static_cast<float>(i) * slot, corner.y);
        picture_of(*textures, block_palette[i], ImVec2(at.x + gap, at.y + gap), size);
        if (block_palette[i] != world.resource<BlockTool>().held) continue;
        list.AddRect(at, ImVec2(at.x + slot, at.y + slot), frame, gap, 0, 2.0f);
    }
}

void draw_block_outline(World& world) {
    const auto& aimed = world.resource<BlockTool>().aimed;
    const Entity camera = active_camera(world);
    if (!aimed || !camera || !world.alive(aimed->entity) || !world.has<VoxelContent>(aimed->entity)) return;
    const auto& place = world.get<WorldTransform>(aimed->entity);
    const auto& eye = world.get<WorldTransform>(camera);
    const double size = world.resource<VoxelVolumes>().at(world.get<VoxelContent>(aimed->entity).volume).block_size();
    const glm::dmat3 linear = glm::dmat3(place.linear) * size;
    const auto corner = [&](int x, int y, int z) { return place.origin + linear * (dvec3(aimed->cell) + dvec3(x, y, z)); };
    const dvec3 eye_in_block = glm::inverse(linear) * (eye.origin - place.origin) - dvec3(aimed->cell);
    const Projection project(world.get<Camera>(camera), eye);
    // A face is seen from its own side alone, and an edge where one of its two faces is.
    const auto seen = [&](int axis, int side) { return side == 0 ? eye_in_block[axis] < 0.0 : eye_in_block[axis] > 1.0; };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int side = 0; side < 4; ++side) {
            if (!seen(u, side & 1) && !seen(v, side >> 1)) continue;
            ivec3 from(0);
            from[u] = side & 1;
            from[v] = side >> 1;
            ivec3 to = from;
            to[axis] = 1;
            project.line(corner(from.x, from.y, from.z), corner(to.x, to.y, to.z), outline, 1.5f);
        }
    }
}

}  // namespace sl
