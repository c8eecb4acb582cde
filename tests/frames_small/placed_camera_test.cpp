// SPDX-License-Identifier: MIT
// What a model that brings no camera is seen with.
#include "tests/frames_small/square_model.h"

namespace sl {
namespace {

class PlacedCameraTest : public SquareModelTest {
  protected:
    /// Of a square that glows with so many nit, and nothing else.
    float exposure(float nit) {
        show_square({{"emissiveFactor", {1.0, 0.5, 0.2}}, {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", nit}}}}}});
        App app = open_scene({.scene = write().string()});
        return app.world.get<Camera>(active_camera(app.world)).ev100;
    }
};

TEST_F(PlacedCameraTest, IsExposedForAFaintGlow) { EXPECT_NEAR(exposure(1.0f), 0.0f, 1e-3f); }
TEST_F(PlacedCameraTest, IsExposedForALamp) { EXPECT_NEAR(exposure(64.0f), 6.0f, 1e-3f); }
TEST_F(PlacedCameraTest, SeesARoomWhereALampIsTooBrightToLookAt) { EXPECT_EQ(exposure(1e5f), 7.0f); }
TEST_F(PlacedCameraTest, SeesDaylightWhereNothingGlows) { EXPECT_EQ(exposure(0.0f), 14.0f); }

}  // namespace
}  // namespace sl
