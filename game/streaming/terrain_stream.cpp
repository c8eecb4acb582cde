// SPDX-License-Identifier: MIT
#include "game/streaming/terrain_stream.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "engine/core/clock.h"
#include "engine/ecs/active_camera.h"
#include "engine/ecs/components.h"
#include "engine/ecs/parent.h"
#include "engine/ecs/query.h"
#include "game/settings/user_settings.h"
#include "game/streaming/view_reach.h"
#include "game/voxel/generators.h"

namespace sl {

namespace {

/// Columns beyond the view distance that stay, so that going to and fro makes nothing anew.
constexpr int slack = 2;
/// Of those that job threads have finished, so many are taken in per second: each must be uploaded, and light reach it. Slow
/// frames take more, or a flight would leave the land behind.
constexpr double taken_per_second = 30.0, most_taken = 4.0;
/// Columns that go in a frame in which others come.
constexpr std::size_t most_dropped = 4;
constexpr std::size_t built_together = 64;

bool is_endless(const VoxelGenerator& generator) {
    return generator_names()[generator.generator] == endless_generator;
}

/// Streams for contents that have none, none for what is no endless terrain any more.
void follow_contents(World& world) {
    std::vector<Entity> lost;
    for (auto [entity, stream] : Query<const TerrainStream>(world)) {
        const auto* content = world.find<VoxelContent>(entity);
        if (content == nullptr || content->volume != stream.volume) lost.push_back(entity);
    }
    for (const Entity entity : lost) world.remove<TerrainStream>(entity);
    std::vector<std::pair<Entity, TerrainStream>> fresh;
    for (auto [entity, content] : Query<const VoxelContent>(world)) {
        if (!is_endless(content.made_by) || world.has<TerrainStream>(entity)) continue;
        TerrainStream stream;
        stream.volume = content.volume;
        stream.terrain = std::make_shared<EndlessTerrain>(content.made_by.seed);
        stream.jobs = std::make_unique<ColumnJobs>();
        fresh.emplace_back(entity, std::move(stream));
    }
    for (auto& [entity, stream] : fresh) world.add(entity, std::move(stream));
}

/// In the space of a terrain, which may be moved, turned and scaled, but has no parent.
dvec3 camera_position(World& world, Entity camera, const Transform& terrain) {
    const auto* in_world = world.has<Parent>(camera) ? world.find<WorldTransform>(camera) : nullptr;
    const dvec3 eye = in_world != nullptr ? in_world->origin : world.get<Transform>(camera).translation;
    return glm::inverse(glm::dquat(terrain.rotation)) * (eye - terrain.translation) / dvec3(terrain.scale);
}

struct Section {
    Entity owner;
    ivec2 centre{0};
    int radius = 0;  ///< columns
    float block_size = 0.5f;
};

/// At most so many of those that are not very far. Returns whether no more are left.
bool drop_far(World& world, const Section& section, TerrainStream& stream, std::size_t most) {
    const int reach = section.radius + slack;
    ColumnSet dropped;
    bool all = true;
    for (const ivec2 column : stream.loaded) {
        const int away = distance_squared(column, section.centre);
        if (away <= reach * reach) continue;
        // Where the camera has jumped, nothing of before is near.
        const bool goes = dropped.size() < most || away > 4 * reach * reach;
        goes ? void(dropped.insert(column)) : void(all = false);
    }
    if (dropped.empty()) return all;
    std::erase_if(stream.loaded, [&](ivec2 column) { return dropped.contains(column); });
    auto& content = world.get<VoxelContent>(section.owner);
    auto& volume = world.resource<VoxelVolumes>().at(content.volume);
    for (const ivec3 key : volume.chunk_keys()) {
        if (!dropped.contains({key.x, key.z})) continue;
        hide_chunk(world, content, key);
        volume.erase_chunk(key);
    }
    return all;
}

void take_in(World& world, const Section& section, TerrainStream& stream, BuiltColumn built) {
    auto& volume = world.resource<VoxelVolumes>().at(stream.volume);
    for (BuiltColumn::Part& part : built.parts) {
        volume.insert_chunk(part.meshed.key, part.blocks);
        show_chunk(world, section.owner, std::move(part.meshed));
    }
    stream.loaded.insert(built.column);
}

void build_at_once(World& world, const Section& section, TerrainStream& stream, std::vector<ivec2> missing) {
    std::erase_if(missing, [&](ivec2 column) { return stream.is_loaded(column); });
    for (std::size_t first = 0; first < missing.size(); first += built_together) {
        std::vector<BuiltColumn> built(std::min(built_together, missing.size() - first));
        tbb::parallel_for(std::size_t{0}, built.size(), [&](std::size_t i) {
            const ivec2 column = missing[first + i];
            built[i] = build_column(*stream.terrain, column, section.block_size, stream.edits.around(column));
        });
        for (BuiltColumn& column : built) take_in(world, section, stream, std::move(column));
    }
}

void build_in_background(World& world, const Section& section, TerrainStream& stream, const std::vector<ivec2>& near) {
    const double taken = std::clamp(world.resource<FrameClock>().step * taken_per_second, 1.0, most_taken);
    for (BuiltColumn& built : stream.jobs->take(section.centre, static_cast<std::size_t>(taken))) {
        const bool wanted = distance_squared(built.column, section.centre) <= section.radius * section.radius;
        if (wanted && !stream.is_loaded(built.column)) take_in(world, section, stream, std::move(built));
    }
    for (const ivec2 column : near) {
        if (stream.jobs->full()) return;
        if (stream.is_loaded(column) || stream.jobs->has(column)) continue;
        stream.jobs->start(column, [terrain = stream.terrain, column, size = section.block_size, edits = stream.edits.around(column)] {
            return build_column(*terrain, column, size, edits);
        });
    }
}

/// How far off land is wanted after this frame, m.
double view_distance(World& world) {
    const auto& view = world.resource<TerrainView>();
    const auto* chosen = world.find_resource<UserSettings>();
    const double distance = chosen != nullptr ? chosen->picture.view_distance : view.distance;
    if (view.at_once) return distance;
    auto& reach = world.resource<ViewReach>();
    reach.follow(world.resource<FrameClock>().step, chosen != nullptr ? chosen->picture.least_frame_rate : view.least_rate);
    return reach.share() * distance;
}

}  // namespace

void TerrainStream::keep(ivec3 cell, Block block) {
    edits.set(cell, block);
    for (const ivec2 column : columns_round(column_of(cell), 1)) jobs->outdate(column);
}

void stream_terrain(World& world) {
    follow_contents(world);
    const Entity camera = active_camera(world);
    if (!camera || !world.has<Transform>(camera)) return;
    std::vector<Entity> owners;
    for (auto [entity, stream, place] : Query<const TerrainStream, const Transform>(world)) owners.push_back(entity);
    if (owners.empty()) return;
    const double distance = view_distance(world);
    world.add_resource(LandEdge{distance});
    for (const Entity owner : owners) {
        auto& stream = world.get<TerrainStream>(owner);
        const float block_size = world.resource<VoxelVolumes>().at(stream.volume).block_size();
        const dvec3 cell = glm::floor(camera_position(world, camera, world.get<Transform>(owner)) / double{block_size});
        const double blocks = distance / block_size;
        const Section section{owner, column_of(ivec3(cell)), std::max(1, static_cast<int>(blocks / chunk_size)), block_size};
        if (stream.whole == std::pair(section.centre, section.radius)) continue;
        const bool at_once = world.resource<TerrainView>().at_once;
        const bool rid_of_far = drop_far(world, section, stream, at_once ? stream.loaded.size() : most_dropped);
        const std::vector<ivec2> near = columns_round(section.centre, section.radius);
        at_once ? build_at_once(world, section, stream, near) : build_in_background(world, section, stream, near);
        const bool is_whole = rid_of_far && std::ranges::all_of(near, [&](ivec2 column) { return stream.is_loaded(column); });
        stream.whole = is_whole ? std::optional(std::pair(section.centre, section.radius)) : std::nullopt;
    }
}

void add_terrain_streaming(App& app) {
    app.world.add_resource(TerrainView{});
    app.world.add_resource(ViewReach{});
    app.schedule.add(Stage::simulate, "stream_terrain", &stream_terrain);
}

}  // namespace sl
