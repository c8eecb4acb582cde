// SPDX-License-Identifier: MIT
// A world file: an SQLite database from anywhere. What is told of a world must be what is then opened.
#include "engine/core/check.h"
#include "engine/core/error.h"
#include "game/saving/world_file.h"
#include "tests/fuzz/input_folder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::InputFolder files;
    for (const char* beside : {"input.world-wal", "input.world-shm", "input.world-journal"}) std::filesystem::remove(files.path() / beside);
    const auto path = files.write("input.world", sl::text_of(data, size));
    std::string scene;
    try {
        scene = sl::WorldFile::scene_of(path);
    } catch (const sl::Error&) {
        // Refused: that is an answer.
    }
    try {
        const auto world = sl::WorldFile::open(path);
        CHECK(scene.empty() || world->scene() == scene, "the scene is '{}' and then '{}'", scene, world->scene());
    } catch (const sl::Error&) {
        // Refused: that is an answer.
    }
    return 0;
}
