// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "engine/ecs/app.h"
#include "engine/ecs/components.h"
#include "engine/render/scene/extract.h"

namespace sl {
namespace {

/// 1/m, with land that ends at a distance, m; 0: it does not.
float extinction(float visibility, double edge) {
    App app;
    app.world.create(SkyLight{.visibility = visibility});
    if (edge > 0.0) app.world.add_resource(LandEdge{edge});
    RenderScene scene;
    extract(app.world, scene);
    return scene.extinction;
}

TEST(Haze, TwoPercentOfAContrastAreLeftAtTheVisibility) { EXPECT_NEAR(std::exp(-extinction(190.0f, 0.0) * 190.0f), 0.02f, 1e-4f); }

TEST(Haze, ClearAirStaysClear) { EXPECT_EQ(extinction(0.0f, 48.0), 0.0f); }

TEST(Haze, HidesTheEdgeOfTheLandWhereverThatIs) {
    EXPECT_EQ(extinction(190.0f, 96.0), extinction(190.0f, 0.0)) << "which it hides anyway";
    for (const double edge : {32.0, 48.0, 80.0}) EXPECT_NEAR(std::exp(-extinction(190.0f, edge) * edge), std::sqrt(0.02), 1e-4);
}

}  // namespace
}  // namespace sl
