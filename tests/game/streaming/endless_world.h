// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "engine/core/clock.h"
#include "engine/ecs/components.h"
#include "engine/ecs/components/water.h"
#include "engine/ecs/query.h"
#include "game/streaming/terrain_stream.h"
#include "game/voxel/generators.h"

namespace sl {

/// Endless terrain with a camera, without a window.
class EndlessWorld : public testing::Test {
  protected:
    App app_;
    Entity terrain_, camera_;

    EndlessWorld() {
        add_voxel_world(app_);
        add_terrain_streaming(app_);
        app_.world.add_resource(FrameClock{});
        app_.world.resource<TerrainView>().distance = view;
        VoxelGenerator generator;
        generator.generator = static_cast<std::size_t>(std::ranges::find(generator_names(), endless_generator) - generator_names().begin());
        terrain_ = app_.world.create(Name{"world"}, Transform{}, generator);
        camera_ = app_.world.create(Transform{.translation = {0, 20, 0}}, Camera{});
    }

    static constexpr double view = 40.0;  ///< m; two columns and a bit
    static constexpr int view_columns = 2;

    void run() { app_.schedule.run(app_.world); }
    void look_from(const dvec3& place) {
        app_.world.get<Transform>(camera_).translation = place;
        run();
    }
    TerrainStream& stream() { return app_.world.get<TerrainStream>(terrain_); }
    VoxelVolume& volume() { return app_.world.resource<VoxelVolumes>().at(stream().volume); }
    const VoxelContent& content() { return app_.world.get<VoxelContent>(terrain_); }
    std::size_t waters() {
        std::size_t count = 0;
        for ([[maybe_unused]] auto [entity, water] : Query<const WaterSurface>(app_.world)) ++count;
        return count;
    }
    /// Lets job threads finish all that is in view.
    void settle() {
        const std::size_t wanted = columns_round(ivec2(0), view_columns).size();
        for (int frame = 0; frame < 20000 && stream().loaded.size() < wanted; ++frame) {
            run();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    /// Of all blocks and meshes that are there.
    std::uint64_t checksum() {
        std::uint64_t hash = 0;
        for (const ivec3 key : volume().chunk_keys()) hash = hash_bytes(hash_bytes(hash, &key, sizeof key), volume().chunk(key)->blocks.data(), sizeof(Chunk::blocks));
        for (const auto& [key, chunk] : content().chunks) {
            const MeshData& mesh = app_.world.resource<MeshPool>().at(app_.world.get<MeshInstance>(chunk).mesh);
            hash = hash_bytes(hash_bytes(hash, key.data(), sizeof key), mesh.indices.data(), mesh.indices.size() * sizeof mesh.indices[0]);
            for (const Vertex& vertex : mesh.vertices) hash = hash_bytes(hash, &vertex.position, sizeof vertex.position);
        }
        return hash;
    }
};

}  // namespace sl
