// SPDX-License-Identifier: MIT
// One small whole frame of each method, quick enough to run under the sanitizers: extraction, passes, gathers and reading back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/render/capture.h"
#include "engine/render/gl/context.h"
#include "game/session.h"

namespace sl {
namespace {

class OneFrame : public testing::TestWithParam<std::string_view> {};

TEST_P(OneFrame, IsFiniteAndLit) {
    auto context = gl::create_context(gl::ContextKind::egl);
    {
        Renderer renderer(shader_folder());
        const std::string method(GetParam());
        std::vector<std::string> sets;
        if (method == "rsm_exact") sets = {"gi.rsm_size=16"};
        if (method == "rsm_grid") sets = {"gi.rsm_size=16"};
        App app = open_scene({.scene = "cornell", .gi = method, .sets = sets});
        const Capture captured = capture(app, renderer, {.width = 32, .height = 18, .layers = true});
        double irradiance = 0.0;
        for (const ImageLayer& layer : captured.layers) {
            for (const float value : layer.image.data) {
                ASSERT_TRUE(std::isfinite(value)) << layer.name;
                if (layer.name == "irradiance") irradiance += value;
            }
        }
        EXPECT_EQ(irradiance > 0.0, method != "off");
    }
    EXPECT_TRUE(context->errors().empty());
}

TEST(ShownImages, HaveTheExposureOfAPictureThatAdapts) {
    auto context = gl::create_context(gl::ContextKind::egl);
    {
        Renderer renderer(shader_folder());
        App app = open_scene({.scene = "cornell", .gi = "off", .sets = {"camera.auto_exposure=true", "camera.ev100=20", "camera.antialias=false"}});
        const Image picture = capture(app, renderer, {.width = 32, .height = 18}).picture;
        const Image radiance = capture(app, renderer, {.width = 32, .height = 18, .show = "hdr"}).picture;
        ASSERT_EQ(picture.data.size(), radiance.data.size());
        for (std::size_t i = 0; i < picture.data.size(); ++i) EXPECT_NEAR(picture.data[i], radiance.data[i], 0.005f) << i;
        EXPECT_GT(*std::ranges::max_element(picture.data), 0.2f) << "at EV 20 all of it would be black";
    }
    EXPECT_TRUE(context->errors().empty());
}

INSTANTIATE_TEST_SUITE_P(Methods, OneFrame, testing::ValuesIn(gi_method_names().begin(), gi_method_names().end()), [](const auto& method) { return std::string(method.param); });

}  // namespace
}  // namespace sl
