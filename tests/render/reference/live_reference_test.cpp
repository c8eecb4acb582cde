// SPDX-License-Identifier: MIT
#include "engine/render/reference/live_reference.h"

#include <gtest/gtest.h>

#include <chrono>

#include "engine/measure/metrics.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

constexpr uvec2 size(24, 16);

class LiveReferenceTest : public testing::Test {
  protected:
    void SetUp() override {
        builder.add({Shape::Kind::box, vec3(4, 1, 4)}, mat4(1.0f), vec3(0.6f));
        builder.add({.kind = RenderScene::Light::Kind::directional, .direction = glm::normalize(vec3(1, -2, 0.5f)), .intensity = vec3(1000.0f)});
        builder.scene().sky_radiance = vec3(100.0f);
        builder.look(vec3(0, 3, 4), glm::normalize(vec3(0, -2.2f, -3)), vec3(0, 1, 0), 1.0f);
    }
    /// Frames until there is a picture of so many samples.
    std::shared_ptr<const LiveReference::Picture> wait_for(LiveReference& reference, std::uint32_t samples) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < end) {
            reference.follow(builder.scene(), size, 0.1);
            if (auto picture = reference.picture(); picture && picture->samples >= samples) return picture;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return nullptr;
    }
    SceneBuilder builder;
};

TEST_F(LiveReferenceTest, GrowsToTheReferenceOfTheScene) {
    LiveReference reference({}, 0.0, 64);
    const auto picture = wait_for(reference, 64);
    ASSERT_TRUE(picture);
    const Film film = trace_film(builder.scene(), size, {}, 64);
    const auto layers = film.layers();
    EXPECT_EQ(picture->layer("").data, layers[0].image.data) << "and is the very same, bit for bit";
    EXPECT_EQ(picture->share, 1.0);
}

TEST_F(LiveReferenceTest, BeginsAnewWhenSomethingMovesAndForgetsAtOnce) {
    LiveReference reference({}, 0.0, 16);
    ASSERT_TRUE(wait_for(reference, 16));
    builder.scene().lights[0].intensity *= 2.0f;
    reference.follow(builder.scene(), size, 0.1);
    EXPECT_FALSE(reference.picture());
    const auto brighter = wait_for(reference, 16);
    ASSERT_TRUE(brighter);
    EXPECT_EQ(brighter->layer("").data, trace_film(builder.scene(), size, {}, 16).layers()[0].image.data);
    builder.scene().view->position.x += 0.1f;
    reference.follow(builder.scene(), size, 0.1);
    EXPECT_FALSE(reference.picture());
}

TEST_F(LiveReferenceTest, WaitsWhileTheCameraMoves) {
    LiveReference reference({}, 0.0, 16);
    for (int frame = 0; frame < 50; ++frame) {
        builder.scene().view->position.x += 0.01f;
        reference.follow(builder.scene(), size, 0.1);
        EXPECT_FALSE(reference.picture());
    }
}

TEST_F(LiveReferenceTest, EndsAtTheNoiseThatIsWanted) {
    LiveReference reference({}, 0.02, 1u << 20);
    const auto first = wait_for(reference, 1);
    ASSERT_TRUE(first);
    for (int wait = 0; wait < 10000 && reference.picture()->noise > 0.02; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_LE(reference.picture()->noise, 0.02);
    EXPECT_EQ(reference.picture()->share, 1.0);
}

TEST_F(LiveReferenceTest, CanBeStoppedAndDestroyedAtAnyTime) {
    for (int milliseconds = 0; milliseconds < 20; milliseconds += 2) {
        LiveReference reference({}, 0.0, 1u << 20);
        reference.follow(builder.scene(), size, 1.0);
        reference.follow(builder.scene(), size, 1.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        if (milliseconds % 4 == 0) reference.stop();
    }
    LiveReference nothing_to_see;
    builder.scene().view.reset();
    nothing_to_see.follow(builder.scene(), size, 1.0);
    EXPECT_FALSE(nothing_to_see.picture());
}

}  // namespace
}  // namespace sl
