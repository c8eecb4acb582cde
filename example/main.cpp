// SPDX-License-Identifier: MIT
// Draws a scene with a component, a system, a pass and a GI method of its own: hemisphere SCENE PICTURE.png
#include "engine/core/clock.h"
#include "engine/core/error.h"
#include "engine/ecs/app.h"
#include "engine/ecs/components/transform.h"
#include "engine/ecs/scene_file.h"
#include "engine/render/capture.h"
#include "engine/render/gl/context.h"
#include "hemisphere.h"

namespace hemisphere {

/// A component: its entity moves at this velocity.
struct Drift {
    sl::vec3 velocity{0.0f};
};
void visit_fields(sl::FieldVisitor& visit, Drift& drift) {
    visit.field("velocity", drift.velocity, {.min = -100, .max = 100, .unit = "m/s", .help = "More moves it farther each second."});
}

/// A system: its parameters say what it reads and writes.
void move_drifting(const sl::FrameClock& clock, sl::Query<const Drift, sl::Transform> drifting) {
    for (auto [entity, drift, transform] : drifting) transform.translation += sl::dvec3(drift.velocity) * clock.step;
}

/// A GI method: an evenly bright sky above, an evenly bright ground below, and nothing in their way.
struct Hemisphere {
    static constexpr std::string_view name = "hemisphere";
    static constexpr std::string_view claims = "light of sky and ground without occlusion";
    sl::vec3 sky{3000.0f};
    sl::vec3 ground{300.0f};
};
void visit_fields(sl::FieldVisitor& visit, Hemisphere& method) {
    visit.field("sky", method.sky, {.min = 0, .max = 1e6, .unit = "nit", .help = "Radiance of what is above; more lights what faces up."});
    visit.field("ground", method.ground, {.min = 0, .max = 1e6, .unit = "nit", .help = "Radiance of what is below; more lights what faces down."});
}
/// Irradiance, before albedo.
sl::GiResult indirect_light(const sl::FrameInput& frame, const sl::GBuffer& gbuffer, const Hemisphere& method) {
    auto pass = frame.graph.fullscreen("hemisphere", "hemisphere.frag");
    const sl::HemisphereParams params{.sky = sl::vec4(method.sky, 0.0f), .ground = sl::vec4(method.ground, 0.0f)};
    pass.params("Hemisphere", params).read("normal", gbuffer.normal);
    return {.irradiance = pass.create("irradiance", frame.screen(sl::Format::rgba32f))};
}

/// A pass: paints an evening where the picture shows nothing.
sl::ImageId evening(const sl::FrameInput& frame, const sl::FrameOutput& made, sl::ImageId picture) {
    auto pass = frame.graph.fullscreen("evening", "evening.frag");
    pass.params("Frame", frame.params).read("depth", made.gbuffer.depth).read("picture", picture);
    return pass.create("evening", frame.screen(sl::Format::rgba32f));
}

void draw(const char* scene, const char* picture) {
    sl::add_gi_method<Hemisphere>();
    sl::App app;
    app.registry().add<Drift>("drift");
    app.schedule.add(sl::Stage::simulate, "move_drifting", &move_drifting);
    sl::read_scene(app.world, app.registry(), scene);

    const auto context = sl::gl::create_context(sl::gl::ContextKind::automatic);
    sl::Renderer renderer(sl::shader_folder());
    renderer.add_shaders(OWN_SHADERS);
    renderer.add_pass(&evening);
    sl::write_png(picture, sl::capture(app, renderer, {.width = 320, .height = 180, .frame = 60}).picture);
}

}  // namespace hemisphere

int main(int argc, char** argv) try {
    if (argc != 3) sl::fail("give a scene file and the name of a PNG: {} SCENE PICTURE.png", argv[0]);
    hemisphere::draw(argv[1], argv[2]);
} catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
