// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"
#include "engine/render/capture.h"
#include "engine/render/gl/context.h"
#include "engine/render/scene/extract.h"
#include "engine/render/trace/path_tracer.h"
#include "game/session.h"
#include "tests/model/model_fixture.h"

namespace sl {

/// A square that fills the view, drawn and traced.
class SquareModelTest : public ModelTest {
  protected:
    static constexpr std::uint32_t side = 60;
    /// 4 x 4 places, each in the middle of a texel of a picture of 4 x 4.
    static constexpr std::uint32_t place_of(std::uint32_t texel) { return 7 + 15 * texel; }

    /// A picture of 4 x 4 squares.
    void add_picture(const char* name, const std::function<vec3(std::uint32_t, std::uint32_t)>& colour) {
        Image picture(4, 4, 4);
        for (std::uint32_t y = 0; y < 4; ++y) {
            for (std::uint32_t x = 0; x < 4; ++x) {
                const vec3 at = colour(x, y);
                for (std::uint32_t k = 0; k < 4; ++k) picture.pixel(x, y)[k] = k < 3 ? at[static_cast<int>(k)] : 1.0f;
            }
        }
        write_png(folder / name, picture);
        json["images"].push_back({{"uri", name}});
        json["samplers"] = {{{"magFilter", 9728}}};
        json["textures"].push_back({{"source", json["images"].size() - 1}, {"sampler", 0}});
    }
    void show_square(Json material, const Json& node = Json::object()) {
        json["materials"] = Json::array({material});
        show(square({{"material", 0}}));
        json["nodes"].back().update(node);
    }
    /// The picture is filled by the square.
    static void look(App& app, vec3 eye, float ev100) {
        auto& transform = app.world.get<Transform>(active_camera(app.world));
        transform.translation = dvec3(eye);
        transform.rotation = glm::quat_cast(glm::transpose(mat3(view_from_world(eye, vec3(0.5f, 0.5f, 0.0f) - eye, vec3(0, 1, 0)))));
        auto& camera = app.world.get<Camera>(active_camera(app.world));
        camera.fov_y = 2.0f * std::atan(0.5f / glm::length(vec3(0.5f, 0.5f, 0.0f) - eye));
        camera.auto_exposure = false;
        camera.antialias = false;
        camera.ev100 = ev100;
    }
    struct Seen {
        std::map<std::string, Image> layers;
        vec3 at(const std::string& layer, std::uint32_t x, std::uint32_t y) {
            const float* pixel = layers.at(layer).pixel(place_of(x), place_of(y));
            return {pixel[0], pixel[1], pixel[2]};
        }
    };
    using Prepare = std::function<void(App&)>;
    static Prepare from(vec3 eye, float ev100) {
        return [=](App& app) { look(app, eye, ev100); };
    }
    static Seen drawn(const std::filesystem::path& file, vec3 eye, const char* gi = "off", float ev100 = 12.0f) { return drawn(file, from(eye, ev100), gi); }
    /// Layers of a capture, and the "picture".
    static Seen drawn(const std::filesystem::path& file, const Prepare& prepare, const char* gi) {
        Seen seen;
        auto context = gl::create_context(gl::ContextKind::egl);
        {
            Renderer renderer(shader_folder());
            App app = open_scene({.scene = file.string(), .gi = gi});
            prepare(app);
            Capture captured = capture(app, renderer, {.width = side, .height = side, .layers = true});
            for (ImageLayer& layer : captured.layers) seen.layers[layer.name] = std::move(layer.image);
            seen.layers["picture"] = std::move(captured.picture);
        }
        EXPECT_TRUE(context->errors().empty());
        return seen;
    }
    struct Traced {
        RenderScene scene;
        std::unique_ptr<PathTracer> tracer;
    };
    static Traced traced(const std::filesystem::path& file, vec3 eye, float ev100 = 12.0f) { return traced(file, from(eye, ev100)); }
    static Traced traced(const std::filesystem::path& file, const Prepare& prepare) {
        Traced result;
        App app = open_scene({.scene = file.string()});
        prepare(app);
        app.schedule.run(app.world);
        extract(app.world, result.scene);
        result.tracer = std::make_unique<PathTracer>(result.scene, uvec2(side), TransportSettings{.bounces = 0, .pixel_area = false});
        return result;
    }
    const Json matte{{"metallicFactor", 0}};
};

}  // namespace sl
