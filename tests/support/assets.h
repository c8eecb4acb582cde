// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sl {

/// Tests on models of others, which lie beside the project and not in it: they skip where those are not there.
class AssetsTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::is_directory(folder)) {
            GTEST_SKIP() << folder << " with models of others is not there; SECONDLIGHT_ASSETS names another folder";
        }
    }

    static std::string content_of(const std::filesystem::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    /// All models of a part ("valid"), by name.
    std::vector<std::filesystem::path> models(std::string_view part) const {
        std::vector<std::filesystem::path> found;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / part)) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".gltf" || ending == ".glb" || ending == ".vox") found.push_back(entry.path());
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    /// What the format's own validator says of each malformed file.
    nlohmann::json manifest() const { return nlohmann::json::parse(content_of(folder / "malformed/MANIFEST.json")); }

    const char* told_folder = std::getenv("SECONDLIGHT_ASSETS");
    std::filesystem::path folder = told_folder != nullptr ? told_folder : SL_ASSETS_FOLDER;
};

}  // namespace sl
