// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/ecs/app.h"
#include "engine/ecs/components.h"
#include "engine/render/scene/extract.h"

namespace sl {
namespace {

std::size_t lights_with_maps(const RenderScene& scene, RenderScene::Light::Kind kind) {
    return static_cast<std::size_t>(std::ranges::count_if(scene.lights, [&](const auto& light) { return light.kind == kind && (light.casts_shadow || light.bounces); }));
}

TEST(LightBounds, OfThousandsOfLightsSomeHaveMapsAndAllShine) {
    App app;
    for (int i = 0; i < 3000; ++i) {
        app.world.create(Transform{}, SpotLight{.casts_shadow = true, .bounces = true, .shadow_size = 512});
        app.world.create(Transform{}, DirectionalLight{.casts_shadow = true, .bounces = true, .shadow_size = 1024});
    }
    app.schedule.run(app.world);
    RenderScene scene;
    extract(app.world, scene);
    EXPECT_EQ(scene.lights.size(), 6000u);
    EXPECT_EQ(lights_with_maps(scene, RenderScene::Light::Kind::spot), 512u);
    EXPECT_EQ(lights_with_maps(scene, RenderScene::Light::Kind::directional), 32u);
}

}  // namespace
}  // namespace sl
