// SPDX-License-Identifier: MIT
#include "engine/render/facets/patches.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/scene_builder.h"

namespace sl {
namespace {

TEST(Patches, ChangesWithoutEndLeaveNothingBehind) {
    SceneBuilder builder;
    builder.add({Shape::Kind::box, vec3(8)}, glm::translate(mat4(1.0f), vec3(0, -4, 0)), vec3(0.5f));
    builder.add({Shape::Kind::box, vec3(40, 40, 1)}, glm::translate(mat4(1.0f), vec3(0, 0, 9)), vec3(0.5f));
    const TransportWorld world(builder.scene(), TransportSettings{});
    Patches patches(world);
    GatherPoint stays, comes;
    stays.point.position = vec3(0, 0.001f, 0);
    stays.point.face = vec3(0, 1, 0);
    stays.point.surface.normal = vec4(0, 1, 0, 0);
    stays.point.error = 1e-5f;
    stays.level = comes.level = -6.0f;
    comes.point = stays.point;
    std::size_t most = 0;
    for (std::uint32_t round = 0; round < 60; ++round) {
        comes.by_chance.clear();
        std::vector<Patches::Job> jobs{{.point = &comes, .by_chance = 1024, .seed = round + 1}};
        if (round == 0) jobs.push_back({.point = &stays, .by_chance = 64, .seed = 7});
        patches.link(jobs);
        // What all of this was linked to is gone, and nobody has the time to follow.
        const std::array boxes{builder.scene().bounds};
        patches.change(boxes);
        if (patches.many_gone()) {
            patches.begin_burying();
            patches.keep_linked(stays);
            while (patches.bury(1000)) {}
        }
        most = std::max(most, patches.size());
    }
    EXPECT_LT(most, 16000u) << "as many as pay a look, and what came since";
    // Links that stay still tell that what they met is gone.
    std::vector<Patches::Job> jobs{{.point = &stays, .by_chance = 0, .seed = 7}};
    patches.mend(jobs);
    EXPECT_GT(stays.renewed, 0u);
}

}  // namespace
}  // namespace sl
