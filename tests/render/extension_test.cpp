// SPDX-License-Identifier: MIT
// Passes and GI methods that the engine does not have.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/gl/gl_fixture.h"
#include "tests/support/gl_test.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

/// The same irradiance everywhere.
struct Even {
    static constexpr std::string_view name = "even";
    static constexpr std::string_view claims = "nothing";
    float lux = 1.0f;
};
void visit_fields(FieldVisitor&, Even&) {}
GiResult indirect_light(const FrameInput& frame, const GBuffer&, const Even& even) {
    auto pass = frame.graph.fullscreen("even", "even.frag");
    pass.params("Even", vec4(even.lux));
    return {.irradiance = pass.create("irradiance", {.width = 1, .height = 1, .format = Format::rgba32f})};
}

/// Halves the picture and adds 1 nit: what comes out tells how often that was done.
PicturePass halve_and_add(const std::string& name) {
    return [name](const FrameInput& frame, const FrameOutput& made, ImageId picture) {
        EXPECT_TRUE(made.gbuffer.depth && made.direct && made.irradiance && made.hdr);
        auto pass = frame.graph.fullscreen(name, "halve_and_add.frag");
        pass.read("picture", picture);
        return pass.write("halved", frame.graph.create(name, frame.screen(Format::rgba32f)), Load::discard);
    };
}

class Extension : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        builder.look(vec3(0), vec3(0, 0, -1), vec3(0, 1, 0), 0.5f);
        builder.add({Shape::Kind::box, vec3(8, 8, 1)}, glm::translate(mat4(1.0f), vec3(0, 0, -2)), vec3(1.0f));
        folder.write("halve_and_add.frag", "uniform sampler2D picture;\nlayout(location = 0) out vec4 halved;\n"
                                           "void main() { halved = 0.5 * texelFetch(picture, ivec2(gl_FragCoord.xy), 0) + 1.0; }\n");
        folder.write("even.frag", "layout(std140) uniform Even { vec4 lux; };\nlayout(location = 0) out vec4 irradiance;\nvoid main() { irradiance = lux; }\n");
        renderer->add_shaders(folder.path());
    }
    float radiance_of(const std::string& image) {
        renderer->render(builder.scene(), {.width = 8, .height = 8, .wanted = {image}});
        return renderer->read_pixel(renderer->find_image(image), {4, 4}).x;
    }

    gl::TempFolder folder;
    SceneBuilder builder;
};

TEST_F(Extension, AddedMethodLightsTheSceneLikeTheEngines) {
    add_gi_method<Even>();
    builder.use(Even{.lux = 5.0f});
    EXPECT_NEAR(radiance_of("hdr"), 5.0f / pi, 0.01f);
}

TEST_F(Extension, AddedPassesFollowOneAnotherBeforeThePictureIsExposed) {
    builder.scene().lights.push_back({.direction = vec3(0, 0, -1), .intensity = vec3(4.0f * pi)});
    renderer->add_pass(halve_and_add("once"));
    EXPECT_NEAR(radiance_of("once"), 3.0f, 0.01f);
    renderer->add_pass(halve_and_add("twice"));
    EXPECT_NEAR(radiance_of("once"), 3.0f, 0.01f);
    EXPECT_NEAR(radiance_of("twice"), 2.5f, 0.01f);
    EXPECT_NEAR(radiance_of("hdr"), 4.0f, 0.01f);
}

}  // namespace
}  // namespace sl
