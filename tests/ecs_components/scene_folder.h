// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "engine/core/text_file.h"
#include "engine/ecs/component_registry.h"
#include "engine/ecs/components.h"
#include "engine/ecs/components/name.h"
#include "engine/ecs/scene_file.h"

namespace sl {

/// A test with an empty folder for scene files and a world to read them into.
class SceneFolder : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder = std::filesystem::temp_directory_path() /
                 (std::string("sl_scene_") + test->name() + "_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder);
        register_engine_components(registry);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void put(const std::string& file, std::string_view text) {
        std::filesystem::create_directories((folder / file).parent_path());
        // Not write_text_file: thousands of small files need not be on the disk, one after the other.
        std::ofstream(folder / file, std::ios::binary) << text;
    }
    void read(const std::string& file) { read_scene(world, registry, folder / file); }
    std::string text_of(const std::string& file) const { return read_text_file(folder / file, 1 << 24); }

    /// The message without the folder's path, or nothing.
    std::string error_of_reading(const std::string& file) {
        try {
            read(file);
        } catch (const std::exception& error) {
            return without_folder(error.what());
        }
        return "";
    }
    /// As above, for a scene with these entities.
    std::string error_of_entities(std::string_view entities) {
        put("s.json", R"({"secondlight_scene": 1, "entities": )" + std::string(entities) + "}");
        return error_of_reading("s.json");
    }
    std::string without_folder(std::string message) const {
        const std::string prefix = folder.string() + "/";
        for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) {
            message.erase(at, prefix.size());
        }
        return message;
    }

    Entity named(std::string_view name) const {
        Entity found;
        world.each_entity([&](Entity entity) {
            const Name* known = world.find<Name>(entity);
            if (known != nullptr && known->value == name) found = entity;
        });
        return found;
    }

    std::filesystem::path folder;
    World world;
    ComponentRegistry registry;
};

}  // namespace sl
