// SPDX-License-Identifier: MIT
#include "engine/render/scene/extract.h"

#include <gtest/gtest.h>

#include "engine/ecs/app.h"
#include "engine/ecs/components.h"

namespace sl {
namespace {

TEST(Extract, AMaterialOfAnEntitysOwnIsItsDrawsAffairAlone) {
    App app;
    app.world.create(Camera{.active = true}, Transform{}, WorldTransform{}, GiSettings{});
    MeshPool& meshes = app.world.add_resource(MeshPool{});
    const MeshHandle mesh = meshes.insert({.vertices = {{}, {}, {}}, .indices = {0, 1, 2}, .bounds = {vec3(0), vec3(1)}});
    const auto add = [&](vec3 glow) { return app.world.create(MeshInstance{.mesh = mesh}, Material{.emission_colour = glow, .emission = 1.0f}, WorldTransform{}); };
    add(vec3(1, 0, 0));
    const Entity other = add(vec3(0, 1, 0));
    RenderScene before, after;
    extract(app.world, before);
    ASSERT_EQ(before.draws.size(), 2u);
    app.world.get<Material>(other).emission_colour = vec3(0, 0, 1);
    extract(app.world, after);
    EXPECT_EQ(after.materials_hash, before.materials_hash) << "or all light would start anew";
    EXPECT_EQ(after.draws[0].content, before.draws[0].content);
    EXPECT_NE(after.draws[1].content, before.draws[1].content);
    EXPECT_NE(after.geometry_hash(), before.geometry_hash());
}

}  // namespace
}  // namespace sl
