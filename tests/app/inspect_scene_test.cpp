// SPDX-License-Identifier: MIT
#include "engine/core/image.h"
#include "engine/core/text_file.h"
#include "game/app/inspect.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

using testing::HasSubstr;

/// A lamp and a box in an included file, and a model of a square.
class InspectScene : public ModelTest {
  protected:
    void SetUp() override {
        ModelTest::SetUp();
        show(square());
        json["nodes"][0]["translation"] = {0, 5, 0};
        std::filesystem::create_directories(folder / "parts");
        write_text_file(folder / "parts/base.json", R"({"secondlight_scene": 1, "entities": [{"name": "lamp", "transform": {}, "spot_light": {"intensity": 250}},
            {"name": "dark", "point_light": {"intensity": 0}}, {"name": "box", "transform": {}, "shape": {"size": [2, 2, 2]}, "material": {}}]})");
    }
    std::string told(const std::string& scene) const {
        write_text_file(folder / "s.json", scene);
        testing::internal::CaptureStdout();
        inspect_scene(folder / "s.json");
        return testing::internal::GetCapturedStdout();
    }
};

TEST_F(InspectScene, TellsWhatIsInIt) {
    show(square({{"mode", 1}}));
    const auto model = write();
    const std::string text = told(R"({"secondlight_scene": 1, "description": "A box", "include": "parts/base.json", // as it comes
        "entities": [{"name": "picture", "transform": {}, "model": {"file": ")" + model.filename().string() + R"("}}]})");
    EXPECT_THAT(text, testing::StartsWith((folder / "s.json").string() + ": A box\nincludes: 1\n  " + (folder / "parts/base.json").string() + "\nentities: 4\ncomponents: 6\n  transform: 3\n"));
    EXPECT_THAT(text, HasSubstr("\n  point_light: 1\n"));
    EXPECT_THAT(text, HasSubstr("\nlight: 1\n  lamp: spot_light, intensity 250 cd\n"));
    EXPECT_THAT(text, HasSubstr("\nfiles: 1\n  picture: model, file " + model.filename().string() + "\n"));
    EXPECT_THAT(text, HasSubstr("\ntriangles: 14\nbounds: -1 -1 -1 to 1 6 1 m\n"));
    EXPECT_THAT(text, testing::EndsWith("\nignored: 1\n  " + model.string() + ": /meshes/1/primitives/0: points and lines are not drawn\n"));
}

TEST_F(InspectScene, OfAModelItTellsWhatNobodyReads) {
    json["extensionsUsed"] = {"KHR_materials_unlit"};
    json["images"] = {{{"uri", "picture.png"}}};
    write_png(folder / "picture.png", Image(1, 1, 4));
    json["textures"] = {{{"source", 0}}};
    json["materials"] = {{{"occlusionTexture", {{"index", 0}}}}, {{"extensions", {{"KHR_materials_unlit", Json::object()}}}}};
    testing::internal::CaptureStdout();
    inspect_model(write());
    const std::string text = testing::internal::GetCapturedStdout();
    EXPECT_THAT(text, HasSubstr(", unlit\n"));
    EXPECT_THAT(text, testing::EndsWith("\nignored: 1\n  /materials/0/occlusionTexture: where little light arrives, it is dark without it\n"));
}

TEST_F(InspectScene, AnEmptyOneHasNoBounds) {
    const std::string text = told(R"({"secondlight_scene": 1})");
    EXPECT_THAT(text, HasSubstr("entities: 0\ncomponents: 0\nlight: 0\nfiles: 0\ntriangles: 0\nignored: 0\n"));
}

TEST_F(InspectScene, AModelThatIsMissingIsAnError) {
    EXPECT_THROW(told(R"({"secondlight_scene": 1, "entities": [{"name": "a", "transform": {}, "model": {"file": "none.glb"}}]})"), Error);
    (void)testing::internal::GetCapturedStdout();
}

}  // namespace
}  // namespace sl
