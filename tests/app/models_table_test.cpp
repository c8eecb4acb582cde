// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/text_file.h"
#include "game/app/bench_models.h"

namespace sl {
namespace {

using testing::HasSubstr;

class FindModels : public testing::Test {
  protected:
    std::filesystem::path folder = std::filesystem::temp_directory_path() / fmt::format("sl_find_models_{}", ::getpid());

    void SetUp() override {
        std::filesystem::create_directories(folder / "ship/textures");
        std::filesystem::create_directories(folder / "empty");
        for (const char* name : {"b.glb", "a.vox", "ship/Ship.GLTF", "ship/ship.bin", "ship/textures/hull.png", "notes.txt"}) write_text_file(folder / name, "x");
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::vector<std::string> names(const std::vector<std::string>& paths) const {
        std::vector<std::string> all;
        for (const FoundModel& model : find_models(paths)) all.push_back(model.name);
        return all;
    }
    std::string fault(const std::string& path) const {
        try {
            (void)find_models({path});
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(FindModels, AllBelowAFolderByNameAndNoParts) { EXPECT_THAT(names({folder.string()}), testing::ElementsAre("a.vox", "b.glb", "ship/Ship.GLTF")); }

TEST_F(FindModels, EachOnceInTheOrderOfThePaths) {
    EXPECT_THAT(names({(folder / "b.glb").string(), folder.string() + "/", (folder / "ship").string()}), testing::ElementsAre("b.glb", "a.vox", "ship/Ship.GLTF"));
}

TEST_F(FindModels, TwoOfOneNameAreToldApart) {
    write_text_file(folder / "ship/b.glb", "x");
    EXPECT_THAT(names({(folder / "b.glb").string(), (folder / "ship/b.glb").string()}), testing::ElementsAre("b.glb", (folder / "ship/b.glb").string()));
}

TEST_F(FindModels, WhatIsNoModelIsTold) {
    EXPECT_THAT(fault((folder / "none.glb").string()), HasSubstr("none.glb: there is no such file"));
    EXPECT_THAT(fault((folder / "notes.txt").string()), HasSubstr("notes.txt: it is no model"));
    EXPECT_THAT(fault((folder / "empty").string()), HasSubstr("empty: no model"));
}

TEST(ModelsTable, HasARowForEachWithWhatIsKnown) {
    const nlohmann::json rows{
        {{"model", "box.glb"}, {"triangles", 12}, {"load_s", 0.034}, {"capture_s", 2.16}, {"peak_mb", 123.4}, {"nrmse", 0.0512}, {"bias", -0.004}, {"reference_noise", 0.01}, {"flip", 0.0123}},
        {{"model", "dark.glb"}, {"triangles", 1}, {"load_s", 0.0}, {"capture_s", 1.0}, {"peak_mb", 99.6}, {"nrmse", nullptr}, {"bias", nullptr}, {"reference_noise", 0.0}},
        {{"model", "slow.vox"}, {"triangles", 900}, {"load_s", 1.0}, {"capture_s", 9.0}, {"peak_mb", 300.0}, {"error", "the comparison took longer than 10 minutes"}},
        {{"model", "a|b.glb"}, {"error", "it is no glTF\nfile"}}};
    const std::string table = models_table(rows);
    EXPECT_THAT(table, HasSubstr("\n| box.glb | 12 | 0.03 | 2.2 | 123 | 5.1 % | -0.4 % | 1.0 % | 0.012 |\n"));
    EXPECT_THAT(table, HasSubstr("\n| dark.glb | 1 | 0.00 | 1.0 | 100 | – | – | 0.0 % | – |\n"));
    EXPECT_THAT(table, HasSubstr("\n| slow.vox | 900 | 1.00 | 9.0 | 300 | the comparison took longer than 10 minutes | | | |\n"));
    EXPECT_THAT(table, HasSubstr("\n| a\\|b.glb | – | – | – | – | it is no glTF file | | | |\n"));
}

}  // namespace
}  // namespace sl
