// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include "engine/core/error.h"
#include "engine/ecs/query.h"
#include "engine/ecs/scene_file.h"
#include "game/app/commands.h"
#include "game/saved_world.h"
#include "game/streaming/terrain_stream.h"
#include "game/voxel/generators.h"
#include "game/voxel/region_text.h"

namespace sl {

namespace {

struct ExportFlags {
    std::filesystem::path world, output;
    std::string scene, low, high, entity = "world";
};

App opened(const ExportFlags& flags) {
    if (flags.world.empty()) return open_scene({.scene = flags.scene});
    auto file = WorldFile::open(flags.world);
    App app = open_scene({.scene = file->scene()});
    attach_world(app, std::move(file));
    return app;
}

Entity blocks_named(World& world, const std::string& wanted) {
    std::vector<std::string> names;
    for (auto [entity, generator, name] : Query<const VoxelGenerator, const Name>(world)) {
        if (name.value == wanted) return entity;
        names.push_back(name.value);
    }
    fail("no entity with blocks is called '{}'; --entity takes one of: {}", wanted, fmt::join(names, ", "));
}

/// The scene's systems run with the camera in the middle of the region, so that land without end is there.
void load_region(App& app, Entity owner, ivec3 low, ivec3 high) {
    World& world = app.world;
    const Entity camera = active_camera(world);
    if (!camera || !world.has<Transform>(camera) || !world.has<Transform>(owner)) return;
    const float side = world.get<VoxelGenerator>(owner).block_size;
    const Transform before = world.get<Transform>(camera);
    world.get<Transform>(camera).translation = world.get<Transform>(owner).translation + 0.5 * side * dvec3(low + high);
    world.resource<TerrainView>().distance = 0.5 * side * glm::length(dvec3(high - low)) + 2.0 * side * chunk_size;
    app.schedule.run(world);
    world.get<Transform>(camera) = before;
}

int run_export(const ExportFlags& flags) {
    if (flags.world.empty() == flags.scene.empty()) fail("give either --world or --scene");
    check_output(flags.output.string(), ".json");
    constexpr const char* form = "X,Y,Z in blocks, for example -16,0,-16";
    App app = opened(flags);
    World& world = app.world;
    const Entity owner = blocks_named(world, flags.entity);
    auto& generator = world.get<VoxelGenerator>(owner);
    const auto corner = [&](const std::string& text, const char* flag, auto whole) {
        if (text.empty() && generator_names()[generator.generator] == endless_generator) fail("'{}' has no end: {} says how much of it is wanted, {}", flags.entity, flag, form);
        const auto& volume = world.resource<VoxelVolumes>().at(world.get<VoxelContent>(owner).volume);
        if (text.empty()) return whole(volume);
        const auto numbers = whole_numbers<std::int32_t>(text, ',', 3, flag, form);
        return ivec3(numbers[0], numbers[1], numbers[2]);
    };
    const ivec3 low = corner(flags.low, "--low", [](const VoxelVolume& volume) { return volume.low(); });
    const ivec3 high = corner(flags.high, "--high", [](const VoxelVolume& volume) { return volume.high(); });
    (void)region_text(VoxelVolume(), low, high);  // what is wrong with the box, before land is made
    load_region(app, owner, low, high);
    generator.blocks = region_text(world.resource<VoxelVolumes>().at(world.get<VoxelContent>(owner).volume), low, high);
    generator.generator = static_cast<std::size_t>(std::ranges::find(generator_names(), region_generator) - generator_names().begin());
    write_scene(world, app.registry(), flags.output);
    const ivec3 size = high - low;
    fmt::print("{}: {} x {} x {} blocks of '{}'; open it with --scene {}\n", flags.output.string(), size.x, size.y, size.z, flags.entity, flags.output.string());
    return 0;
}

}  // namespace

void add_export_command(const Flags& program) {
    auto flags = std::make_shared<ExportFlags>();
    const Flags command = program.command("export", "Write a world's scene with the blocks of a region as a scene file of its own");
    command.footer("Everything else in the scene stays as it is: lights, sky, camera, crystals. Such a file is a scene like any other: `play --scene FILE`\n"
                   "makes a world of it, and other scenes may include it.");
    command.add("--world", flags->world, "World file");
    command.add("--scene,PATH", flags->scene, scene_flag_help);
    command.add("--entity", flags->entity, "Name of the entity whose blocks are wanted");
    command.add("--low", flags->low, "X,Y,Z of the lowest block; default: of all blocks that there are");
    command.add("--high", flags->high, "X,Y,Z, each one past the highest block");
    command.add("--output,-o", flags->output, "Scene file to write").required();
    command.runs([flags] { return run_export(*flags); });
}

}  // namespace sl
