// SPDX-License-Identifier: MIT
#include "game/block_tool.h"

#include <algorithm>

#include "engine/core/input.h"
#include "engine/ecs/components/transform.h"
#include "game/notice.h"
#include "game/player/player.h"
#include "game/session.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

void hold(World& world, Block block) {
    world.resource<BlockTool>().held = block;
    world.resource<Notice>().say(std::string(block_info(block).name));
}

void choose_block(World& world, const Input& input) {
    for (std::size_t i = 0; i < block_palette.size(); ++i) {
        if (input.pressed(static_cast<Key>(static_cast<std::size_t>(Key::digit_1) + i))) hold(world, block_palette[i]);
    }
    auto& tool = world.resource<BlockTool>();
    tool.turned += input.active(Key::control) ? 0.0f : input.scroll;
    const auto notches = static_cast<std::ptrdiff_t>(tool.turned);
    if (notches == 0) return;
    tool.turned -= static_cast<float>(notches);
    const auto size = static_cast<std::ptrdiff_t>(block_palette.size());
    const auto now = std::ranges::find(block_palette, tool.held) - block_palette.begin();
    hold(world, block_palette[static_cast<std::size_t>(((now - notches) % size + size) % size)]);
}

VoxelVolume& volume_of(World& world, Entity entity) {
    return world.resource<VoxelVolumes>().at(world.get<VoxelContent>(entity).volume);
}

ivec3 cell_at(World& world, Entity entity, const dvec3& point) {
    const auto& place = world.get<WorldTransform>(entity);
    const dvec3 local = glm::inverse(glm::dmat3(place.linear)) * (point - place.origin);
    return ivec3(glm::floor(local / double{volume_of(world, entity).block_size()}));
}

/// Around a block, in world space.
BodyBox box_of(World& world, Entity entity, ivec3 cell) {
    const auto& place = world.get<WorldTransform>(entity);
    const double size = volume_of(world, entity).block_size();
    const glm::dmat3 linear(place.linear);
    const dvec3 centre = place.origin + linear * ((dvec3(cell) + 0.5) * size);
    const dvec3 reach = 0.5 * size * (glm::abs(linear[0]) + glm::abs(linear[1]) + glm::abs(linear[2]));
    return {centre - reach, centre + reach};
}

}  // namespace

void block_tool(World& world) {
    const auto& input = world.resource<Input>();
    choose_block(world, input);
    auto& tool = world.resource<BlockTool>();
    tool.aimed.reset();
    const Entity camera = active_camera(world);
    const auto* eye = camera ? world.find<WorldTransform>(camera) : nullptr;
    if (!input.mouse_captured || eye == nullptr) return;
    tool.aimed = pick_block(world, eye->origin, -eye->linear[2], tool.reach);
    const auto& pick = tool.aimed;
    if (!pick) return;

    if (input.pressed(MouseButton::left)) {
        set_block(world, pick->entity, pick->cell, Block::air);
    } else if (input.pressed(MouseButton::right)) {
        const ivec3 cell = pick->cell + pick->normal;
        if (pick->normal == ivec3(0) || cell == cell_at(world, pick->entity, eye->origin)) return;
        if (player_is_in(world, box_of(world, pick->entity, cell))) return;
        set_block(world, pick->entity, cell, tool.held);
    } else if (input.pressed(MouseButton::middle)) {
        hold(world, volume_of(world, pick->entity).get(pick->cell));
    }
}

void add_block_tool(App& app) {
    add_player_resources(app.world);
    app.world.add_resource(BlockTool{});
    app.schedule.add(Stage::input, "block_tool", &block_tool);
}

}  // namespace sl
