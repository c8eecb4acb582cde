// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/app.h"
#include "game/voxel_content.h"

namespace sl {

/// What the keys 1 to 9, and the wheel, choose.
inline constexpr std::array<Block, 9> block_palette{Block::planks,    Block::stone,      Block::glowstone, Block::white_wool, Block::red_wool,
                                                    Block::blue_wool, Block::green_wool, Block::yellow_wool, Block::blue_lamp};

/// What the player builds with; a resource.
struct BlockTool {
    Block held = block_palette[0];
    float reach = 8.0f;  ///< m
    std::optional<BlockPick> aimed;  ///< what a click would meet, as long as the mouse is captured
    float turned = 0.0f;  ///< notches of the wheel that chose nothing yet
};

/// With the mouse captured: left click breaks the block in the middle of the view, right click places the
/// held one on the face that is seen, middle click takes the kind that is seen. Nothing is placed where the
/// camera or whoever walks is. Before the chunks of this frame are meshed.
void block_tool(World& world);

/// The tool as a plugin; needs the voxel world's resources.
void add_block_tool(App& app);

}  // namespace sl
