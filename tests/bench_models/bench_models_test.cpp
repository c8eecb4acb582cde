// SPDX-License-Identifier: MIT
#include "game/app/bench_models.h"

#include "engine/core/image.h"
#include "engine/core/text_file.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

using testing::HasSubstr;

/// Two squares that face each other at an angle, so that light goes from one to the other, and a file that is no model.
class BenchModels : public ModelTest {
  protected:
    void SetUp() override {
        ModelTest::SetUp();
        json["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0}}}}};
        show(square({{"material", 0}}));
        show(square({{"material", 0}}));
        json["nodes"][1]["rotation"] = {-0.70710678, 0, 0, 0.70710678};
        json["nodes"][1]["translation"] = {0, 0, 1};
        std::filesystem::create_directories(folder / "models");
        write("models/squares.gltf");
        std::filesystem::rename(folder / "data.bin", folder / "models/data.bin");
        flags.paths = {(folder / "models").string()};
        flags.folder = (folder / "out").string();
    }
    Json rows() const { return Json::parse(read_text_file(folder / "out/report.json", 1u << 20))["rows"]; }

    GlobalFlags global;
    ModelsFlags flags{.size = "48x27", .reference_size = "32x18", .spp = 256};
};

TEST_F(BenchModels, MeasuresAndKeepsPictures) {
    EXPECT_EQ(run_bench_models(global, flags), 0);
    const Json row = rows().at(0);
    EXPECT_EQ(row["model"], "squares.gltf");
    EXPECT_EQ(row["triangles"], 4);
    EXPECT_FALSE(row.contains("error")) << row["error"];
    EXPECT_GT(row["peak_mb"].get<double>(), 1.0);
    EXPECT_GE(row["capture_s"].get<double>(), row["load_s"].get<double>());
    EXPECT_LT(row["nrmse"].get<double>(), 0.3);
    EXPECT_GT(row["reference_noise"].get<double>(), 0.0);
    EXPECT_LT(row["flip"].get<double>(), 0.2);
    EXPECT_EQ(read_png(folder / "out/squares.gltf/capture.png").width, 48u);
    EXPECT_EQ(read_png(folder / "out/squares.gltf/beside_reference.png").width, 2u * 32u + 4u);
    EXPECT_THAT(read_text_file(folder / "out/report.md", 1u << 20), HasSubstr("| squares.gltf | 4 |"));
}

TEST_F(BenchModels, AModelThatFailsIsARowAndTheRestGoesOn) {
    write_text_file(folder / "models/broken.glb", "no model");
    write_text_file(folder / "models/nothing.gltf", R"({"asset": {"version": "2.0"}})");
    EXPECT_EQ(run_bench_models(global, flags), 1);
    const Json all = rows();
    ASSERT_EQ(all.size(), 3u);
    EXPECT_THAT(all[0]["error"].get<std::string>(), testing::Not(HasSubstr(folder.string()))) << "the row names the model";
    EXPECT_EQ(all[1]["model"], "nothing.gltf");
    EXPECT_EQ(all[1]["error"], "it has no triangles to show");
    EXPECT_EQ(all[2]["model"], "squares.gltf");
    EXPECT_FALSE(all[2].contains("error"));
}

TEST_F(BenchModels, WhatTakesTooLongIsGivenUp) {
    flags.spp = 1'000'000;
    flags.minutes = 0.2;
    EXPECT_EQ(run_bench_models(global, flags), 1);
    const Json row = rows().at(0);
    EXPECT_EQ(row["error"], "the comparison took longer than 0.2 minutes");
    EXPECT_TRUE(row.contains("capture_s")) << "what was measured stays";
}

TEST_F(BenchModels, WrongFlagsAreToldBeforeAnythingIsMeasured) {
    const auto wrong = [&](auto change) {
        ModelsFlags other = flags;
        change(other);
        EXPECT_THROW((void)run_bench_models(global, other), Error);
    };
    wrong([](ModelsFlags& f) { f.size = "large"; });
    wrong([](ModelsFlags& f) { f.spp = 0; });
    wrong([](ModelsFlags& f) { f.gi = "magic"; });
    wrong([](ModelsFlags& f) { f.paths = {"nowhere"}; });
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace sl
