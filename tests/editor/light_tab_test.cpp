// SPDX-License-Identifier: MIT
#include "editor/light_tab.h"

#include <gmock/gmock.h>

#include "tests/editor/panel_test.h"

namespace sl {
namespace {

using testing::HasSubstr;
using testing::Not;

class LightTabTest : public PanelTest {
  protected:
    std::function<void()> drawing() {
        return [this] {
            open({"Lights", "Camera and exposure"});
            light_tab(scene(), report_, state_.light);
        };
    }
    std::string shown() { return PanelTest::shown(drawing()); }
};

TEST_F(LightTabTest, ShowsMethodPresetAndEverySetting) {
    const std::string text = shown();
    for (const char* word :
         {"rsm_grid", "preset", "paper", "angle_threshold", "distance_attenuation", "cutoff"}) {
        EXPECT_THAT(text, HasSubstr(word));
    }
    EXPECT_THAT(text, Not(HasSubstr("low_resolution")));
}

TEST_F(LightTabTest, ShowsEachLightByName) {
    const std::string text = shown();
    for (const char* word : {"lamp", "spot_light", "outer_cone", "sunlight", "azimuth", "illuminance", "heaven",
                             "luminance", "ev100"}) {
        EXPECT_THAT(text, HasSubstr(word));
    }
    EXPECT_THAT(text, Not(HasSubstr("box")));
}

TEST_F(LightTabTest, ShowsWhatGiCostsAndItsNoise) {
    const std::string text = shown();
    EXPECT_THAT(text, HasSubstr("0.75 ms in 1 passes"));
    EXPECT_THAT(text, HasSubstr("noise 7.0 %"));
    EXPECT_THAT(text, Not(HasSubstr("gathered in full")));
}

TEST_F(LightTabTest, OfADiscItTellsHowManySamplesItTakes) {
    app_.world.add(camera_, GiSettings{RsmDisc{.samples = 320, .low_resolution = 8}});
    report_.refined = 0.1;
    EXPECT_THAT(shown(), HasSubstr("10.0 % of pixels gathered in full, 37.0 samples per pixel"));
}

TEST_F(LightTabTest, WithoutGiSettingsItOffersThem) {
    app_.world.remove<GiSettings>(camera_);
    EXPECT_THAT(shown(), HasSubstr("Add GI settings"));
}

TEST_F(LightTabTest, WithoutACameraItSaysSo) {
    app_.world.get<Camera>(camera_).active = false;
    EXPECT_THAT(shown(), HasSubstr("No camera is active"));
}

TEST_F(LightTabTest, ComponentsMayComeAndGoWhileItIsOpen) {
    for (int i = 0; i < 4; ++i) {
        frame(drawing());
        app_.world.destroy(lamp_);
        lamp_ = app_.world.create(Name{"lamp"}, PointLight{}, Transform{});
        app_.schedule.run(app_.world);
    }
    EXPECT_THAT(shown(), HasSubstr("point_light"));
}

TEST(PassHistory, RemembersTheLastFramesAndForgetsPassesThatNoLongerRun) {
    PassHistory history;
    const std::vector<gl::SpanTime> first{{"old", "gi", 4.0}, {"both", "gi", 1.0}}, later{{"both", "gi", 2.0}, {"new", "gi", 3.0}};
    history.add(first);
    history.add(later);
    EXPECT_EQ(history.passes(), (std::vector<std::string>{"old", "both", "new"}));
    EXPECT_EQ(history.milliseconds(0, 2), 0.0f);
    EXPECT_EQ(history.sum(1), 5.0f);
    for (std::size_t i = 1; i < PassHistory::longest; ++i) history.add(later);
    EXPECT_EQ(history.frames(), PassHistory::longest);
    EXPECT_EQ(history.passes(), (std::vector<std::string>{"both", "new"}));
    EXPECT_EQ(history.milliseconds(0, 1), 3.0f);
}

}  // namespace
}  // namespace sl
