// SPDX-License-Identifier: MIT
// A scene file, beside another one that it may include. What is read is written, and read again the same.
#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/text_file.h"
#include "engine/ecs/scene_document.h"
#include "engine/ecs/scene_file.h"
#include "game/crystals/crystal.h"
#include "game/voxel_content.h"
#include "tests/fuzz/input_folder.h"

namespace sl {
namespace {

struct Files : InputFolder {
    ComponentRegistry registry;

    Files() {
        register_engine_components(registry);
        registry.add<VoxelGenerator>("voxels");
        registry.add<Crystal>("crystal");
        write("a.json", R"({"secondlight_scene": 1, "entities": [{"name": "a", "camera": {}, "transform": {}}, {"name": "b", "parent": "a", "shape": {}}]})");
    }
};

std::string written(const World& world, const ComponentRegistry& registry, const std::filesystem::path& path) {
    write_scene(world, registry, path);
    return read_text_file(path, most_scene_bytes);
}

}  // namespace
}  // namespace sl

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::Files files;
    sl::World world;
    try {
        sl::read_scene(world, files.registry, files.write("scene.json", sl::text_of(data, size)));
    } catch (const sl::Error&) {
        return 0;
    }
    const auto copy = files.path() / "copy.json";
    const std::string text = sl::written(world, files.registry, copy);
    sl::World again;
    sl::read_scene(again, files.registry, copy);
    CHECK(sl::written(again, files.registry, copy) == text, "a scene that was written is read as another one");
    return 0;
}
