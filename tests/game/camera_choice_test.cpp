// SPDX-License-Identifier: MIT
#include "game/camera_choice.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include "engine/core/error.h"
#include "engine/core/text_file.h"
#include "game/session.h"

namespace sl {
namespace {

TEST(CameraChoice, IsByNameOrByNumber) {
    App app;
    const Entity first = app.world.create(Name{"first"}, Transform{}, Camera{}), second = app.world.create(Name{"second"}, Transform{}, Camera{.active = false});
    choose_camera(app.world, "second");
    EXPECT_EQ(active_camera(app.world), second);
    EXPECT_FALSE(app.world.get<Camera>(first).active);
    choose_camera(app.world, "0");
    EXPECT_EQ(active_camera(app.world), first);
}

TEST(CameraChoice, TellsTheNames) {
    App app;
    EXPECT_THROW(choose_camera(app.world, "0"), Error);
    app.world.create(Name{"nave"}, Transform{}, Camera{});
    for (const char* wrong : {"neve", "1", "-1", "", "0x"}) {
        try {
            choose_camera(app.world, wrong);
            ADD_FAILURE() << wrong;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("nave")) << wrong;
        }
    }
}

TEST(CameraChoice, OfAModelItIsTheOneWithThatNameInItsFile) {
    const auto path = std::filesystem::temp_directory_path() / fmt::format("sl_cameras_{}.gltf", ::getpid());
    write_text_file(path, R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "cameras": [{"name": "wide", "type": "perspective", "perspective": {"yfov": 1.2, "znear": 0.1}}, {"type": "perspective", "perspective": {"yfov": 0.4, "znear": 0.1}}],
        "nodes": [{"camera": 0}, {"name": "far", "camera": 1}]})");
    const auto fov = [&](const std::string& camera) {
        App app = open_scene({.scene = path.string(), .camera = camera});
        EXPECT_TRUE(app.world.has<GiSettings>(active_camera(app.world)));
        return app.world.get<Camera>(active_camera(app.world)).fov_y;
    };
    EXPECT_FLOAT_EQ(fov(""), 1.2f);
    EXPECT_FLOAT_EQ(fov("far"), 0.4f);
    EXPECT_FLOAT_EQ(fov("wide"), 1.2f);
    EXPECT_FLOAT_EQ(fov("1"), 0.4f);
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace sl
