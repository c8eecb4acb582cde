// SPDX-License-Identifier: MIT
#include "game/voxel/generators.h"

#include <array>
#include <string>

#include "engine/core/error.h"
#include "game/voxel/region_text.h"

namespace sl {
namespace {

struct Generator {
    std::string_view name;
    void (*build)(VoxelVolume&, const GeneratorSettings&);
};

using Volume = VoxelVolume;
using Settings = GeneratorSettings;

constexpr std::array<Generator, 10> generators{{
    {"paper_world",
     [](Volume& volume, const Settings& settings) { generate_paper_world(volume, settings.seed); }},
    {"crystal_valley",
     [](Volume& volume, const Settings& settings) { generate_crystal_valley(volume, settings.seed); }},
    {"terrain", generate_terrain},
    {"creature", [](Volume& volume, const Settings&) { generate_creature(volume); }},
    {"tree_small",
     [](Volume& volume, const Settings& settings) { generate_tree_small(volume, settings.seed); }},
    {"room", [](Volume& volume,
                const Settings& settings) { generate_room(volume, settings.size, RoomKind::closed); }},
    {"room_skylight",
     [](Volume& volume, const Settings& settings) {
         generate_room(volume, settings.size, RoomKind::skylight);
     }},
    {"room_cornell",
     [](Volume& volume, const Settings& settings) {
         generate_room(volume, settings.size, RoomKind::cornell);
     }},
    {region_generator, [](Volume& volume, const Settings& settings) { put_region(volume, settings.blocks); }},
    {endless_generator, [](Volume&, const Settings&) {}},
}};

constexpr auto names = [] {
    std::array<std::string_view, generators.size()> result;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = generators[i].name;
    return result;
}();

}  // namespace

std::span<const std::string_view> generator_names() {
    return names;
}

void generate(VoxelVolume& volume, std::string_view name, const GeneratorSettings& settings) {
    for (const Generator& generator : generators) {
        if (generator.name == name) return generator.build(volume, settings);
    }
    std::string choices;
    for (const std::string_view choice : names) choices.append(choices.empty() ? "" : ", ").append(choice);
    fail("no voxel generator is called \"{}\"; choose one of {}", name, choices);
}

}  // namespace sl
