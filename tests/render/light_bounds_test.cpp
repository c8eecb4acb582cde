// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/ecs/app.h"
#include "engine/ecs/components.h"
#include "engine/render/scene/extract.h"

namespace sl {
namespace {

std::size_t lights_with_maps(const RenderScene& scene, RenderScene::Light::Kind kind) {
    return static_cast<std::size_t>(std::ranges::count_if(scene.lights, [&](const auto& light) { return light.kind == kind && light.mapped && (light.casts_shadow || light.bounces); }));
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
    EXPECT_EQ(scene.lights_without_maps(), 6000u - 512u - 32u);
    EXPECT_TRUE(std::ranges::all_of(scene.lights, &RenderScene::Light::casts_shadow)) << "where there are no maps, rays know what is right";
}

TEST(LightBounds, SixFacesOfPointLightsFitWhereSpotsLeaveRoom) {
    const auto mapped_points = [](int spots, std::uint32_t faces) {
        App app;
        for (int i = 0; i < spots; ++i) app.world.create(Transform{}, SpotLight{.shadow_size = 512});
        for (int i = 0; i < 400; ++i) app.world.create(Transform{}, PointLight{.shadow_size = faces});
        app.world.create(Transform{}, PointLight{.casts_shadow = false});
        app.schedule.run(app.world);
        RenderScene scene;
        extract(app.world, scene);
        EXPECT_EQ(scene.lights_without_maps() + lights_with_maps(scene, RenderScene::Light::Kind::point), 400u) << "one asks for none";
        return lights_with_maps(scene, RenderScene::Light::Kind::point);
    };
    // A face takes 1 MiB of 512.
    EXPECT_EQ(mapped_points(0, 512), 85u);
    EXPECT_EQ(mapped_points(256, 512), 42u);
    EXPECT_EQ(mapped_points(512, 512), 0u);
    // Here the 2048 layers that OpenGL promises are the bound.
    EXPECT_EQ(mapped_points(0, 16), 341u);
}

}  // namespace
}  // namespace sl
