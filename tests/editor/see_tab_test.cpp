// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "editor/see/probe_lines.h"
#include "editor/see/probe_table.h"
#include "engine/ecs/parent.h"
#include "tests/editor/panel_test.h"

namespace sl {
namespace {

using testing::HasSubstr;

class SeeTabTest : public PanelTest {
  protected:
    ProbeReading reading() {
        ProbeReading result{.point = {dvec3(1, 0, -4), vec3(0, 1, 0)}, .entity = lamp_, .distance = 4.1f, .shadowed = true};
        result.live = LiveValues{.albedo = vec3(0.25f), .direct = vec3(20.0f), .irradiance = vec3(90.0f), .radiance = vec3(27.0f)};
        result.lights = {{lamp_, vec3(300.0f), dvec3(0, 3, -4), false}, {camera_, vec3(70.0f), dvec3(2, 3, -4), true}};
        result.texels = TexelShares{{{dvec3(-1, 0, -5), vec3(2.0f)}}, vec3(80.0f)};
        result.truth = LightMeter::Reading{.irradiance = vec3(100.0f), .bounced = vec3(100.0f), .noise = 0.03f, .paths = 640};
        return result;
    }
    std::string table(const ProbeReading& reading) {
        return shown([&] { probe_table(app_.world, reading); });
    }
    int corners_of(const ProbeReading& reading) {
        ImGui::NewFrame();
        draw_probe_lines(reading, Projection(app_.world.get<Camera>(camera_), app_.world.get<WorldTransform>(camera_)), 1.0f);
        ImGui::Render();
        for (const ImDrawVert& vertex : ImGui::GetBackgroundDrawList()->VtxBuffer) EXPECT_TRUE(std::isfinite(vertex.pos.x + vertex.pos.y));
        return ImGui::GetBackgroundDrawList()->VtxBuffer.Size;
    }
};

TEST_F(SeeTabTest, TellsHowFarTheLiveLightIsFromTheTruth) {
    const std::string text = table(reading());
    for (const char* word : {"lamp", "1.00, 0.00, -4.00 m", "0.25, 0.25, 0.25", "4.10 m", "27 nit", "90 lux", "100 lux", "3.0 %", "-10.0 %", "80 lux", "2.5 % by the 1", "300 lux", "70 lux, in shadow"}) {
        EXPECT_THAT(text, HasSubstr(word));
    }
}

TEST_F(SeeTabTest, SaysWhatItDoesNotKnow) {
    ProbeReading nothing = reading();
    nothing.live.reset();
    nothing.truth.reset();
    nothing.texels.reset();
    nothing.shadowed = false;
    nothing.entity = {};
    const std::string text = table(nothing);
    for (const char* word : {"hidden from the camera", "not yet", "unshadowed", "none that is known"}) EXPECT_THAT(text, HasSubstr(word));
    nothing.point.position = dvec3(std::numeric_limits<double>::quiet_NaN());
    nothing.lights.clear();
    corners_of(nothing);
}

TEST_F(SeeTabTest, APartWithoutANameGoesByTheNameAboveIt) {
    ProbeReading chunk = reading();
    chunk.entity = app_.world.create(Parent{lamp_});
    EXPECT_THAT(table(chunk), HasSubstr("lamp"));
    app_.world.destroy(chunk.entity);
    EXPECT_THAT(table(chunk), HasSubstr("none that is known"));
}

TEST_F(SeeTabTest, LinesLeadFromLightsAndTexelsToTheCross) {
    ProbeReading bare = reading();
    bare.lights.clear();
    bare.texels.reset();
    const int cross = corners_of(bare), all = corners_of(reading());
    EXPECT_GT(cross, 0);
    EXPECT_GT(all, cross);
    bare.point.position.z = 4.0;
    EXPECT_EQ(corners_of(bare), 0) << "behind the camera";
}

TEST_F(SeeTabTest, IsDrawnWithoutAFrameAndTellsOfAnImageThatIsNotThere) {
    state_.see.image.name = "rsm_flux";
    state_.see.facets.on = true;
    const std::string text = shown([&] { see_tab(app_.world, state_.see); });
    EXPECT_THAT(text, HasSubstr("This frame has no image rsm_flux"));
    EXPECT_THAT(text, HasSubstr("method facets"));
    frame([&] { state_.see.draw(app_.world, 1.0f); });
    app_.world.destroy(camera_);
    frame([&] { state_.see.draw(app_.world, 1.0f); });
}

TEST_F(SeeTabTest, AClickIsForThePanelOnlyWhileTheTabIsInFront) {
    EXPECT_FALSE(click_picture(state_));
    state_.see.picks = true;
    EXPECT_TRUE(click_picture(state_));
    state_.open = false;
    EXPECT_FALSE(click_picture(state_));
    state_.open = true;
    ImGui::NewFrame();
    editor_panel(app_, report_, state_);
    ImGui::Render();
    EXPECT_FALSE(click_picture(state_)) << "another tab is in front";
}

}  // namespace
}  // namespace sl
