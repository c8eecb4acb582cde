// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "game/voxel/voxel_volume.h"

namespace sl {

/// What a generator may be told besides its name.
struct GeneratorSettings {
    std::uint32_t seed = 1;
    ivec3 size{8, 6, 8};  ///< interior of the rooms, extent of "terrain" in x and z; blocks, each at least 1
    std::string blocks{};  ///< of "region"
};

/// The generator whose blocks come and go with the camera.
inline constexpr std::string_view endless_generator = "endless";

/// The generator of blocks that are written down.
inline constexpr std::string_view region_generator = "region";

/// The names that generate() knows.
std::span<const std::string_view> generator_names();

/// Builds blocks into a volume, on top of what is there. The same settings give the same blocks everywhere.
///   paper_world       a village clearing between terraced hills, for 0.5 m blocks; see paper_world.h
///   crystal_valley    a meadow with the five shrines of the game, for 0.5 m blocks; see crystal_valley.h
///   terrain           rolling hills without end, `size` wide round the origin
///   endless           nothing at once: the system stream_terrain brings what is near; see endless_terrain.h
///   creature          a four-legged animal, 20 x 16 x 10 blocks, looking along +x, for 1/16 m blocks
///   tree_small        a bush-like tree, 16 x 24 x 16 blocks, for 1/16 m blocks
///   room              a closed white box with interior [0, size)
///   room_skylight     the same with a hole in the middle of the ceiling, a third as wide
///   room_cornell      white, red on -x, green on +x, without the +z wall
///   region            the blocks of settings.blocks; see region_text.h
/// Throws Error naming the choices for another name.
void generate(VoxelVolume& volume, std::string_view name, const GeneratorSettings& settings = {});

void generate_paper_world(VoxelVolume& volume, std::uint32_t seed);
void generate_crystal_valley(VoxelVolume& volume, std::uint32_t seed);
void generate_terrain(VoxelVolume& volume, const GeneratorSettings& settings);
void generate_creature(VoxelVolume& volume);
void generate_tree_small(VoxelVolume& volume, std::uint32_t seed);

enum class RoomKind { closed, skylight, cornell };
void generate_room(VoxelVolume& volume, ivec3 size, RoomKind kind);

}  // namespace sl
