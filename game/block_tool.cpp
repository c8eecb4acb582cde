// SPDX-License-Identifier: MIT
#include "game/block_tool.h"

#include "engine/core/input.h"
#include "engine/ecs/components/transform.h"
#include "game/notice.h"
#include "game/session.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

void choose_block(World& world, const Input& input) {
    auto& tool = world.resource<BlockTool>();
    for (std::size_t i = 0; i < block_palette.size(); ++i) {
        if (!input.pressed(static_cast<Key>(static_cast<std::size_t>(Key::digit_1) + i))) continue;
        tool.held = block_palette[i];
        world.resource<Notice>().say(std::string(block_info(tool.held).name));
    }
}

VoxelVolume& volume_of(World& world, Entity entity) {
    return world.resource<VoxelVolumes>().at(world.get<VoxelContent>(entity).volume);
}

ivec3 cell_at(World& world, Entity entity, const dvec3& point) {
    const auto& place = world.get<WorldTransform>(entity);
    const dvec3 local = glm::inverse(glm::dmat3(place.linear)) * (point - place.origin);
    return ivec3(glm::floor(local / double{volume_of(world, entity).block_size()}));
}

}  // namespace

void block_tool(World& world) {
    const auto& input = world.resource<Input>();
    choose_block(world, input);
    if (!input.mouse_captured || input.buttons_pressed.none()) return;
    const Entity camera = active_camera(world);
    const auto* eye = camera ? world.find<WorldTransform>(camera) : nullptr;
    if (eye == nullptr) return;
    auto& tool = world.resource<BlockTool>();
    const auto pick = pick_block(world, eye->origin, -eye->linear[2], tool.reach);
    if (!pick) return;

    if (input.pressed(MouseButton::left)) {
        set_block(world, pick->entity, pick->cell, Block::air);
    } else if (input.pressed(MouseButton::right)) {
        const ivec3 cell = pick->cell + pick->normal;
        if (pick->normal == ivec3(0) || cell == cell_at(world, pick->entity, eye->origin)) return;
        set_block(world, pick->entity, cell, tool.held);
    } else if (input.pressed(MouseButton::middle)) {
        tool.held = volume_of(world, pick->entity).get(pick->cell);
        world.resource<Notice>().say(std::string(block_info(tool.held).name));
    }
}

void add_block_tool(App& app) {
    add_player_resources(app.world);
    app.world.add_resource(BlockTool{});
    app.schedule.add(Stage::input, "block_tool", &block_tool);
}

}  // namespace sl
