// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/components/shape.h"
#include "engine/ecs/systems/shape_mesh.h"
#include "engine/render/renderer.h"

namespace sl {

/// Makes render scenes from shapes and lights without a world, for tests with known answers.
class SceneBuilder {
  public:
    SceneBuilder() { scene_.meshes = &meshes_; }
    SceneBuilder(const SceneBuilder&) = delete;
    SceneBuilder& operator=(const SceneBuilder&) = delete;

    /// A purely diffuse shape; `place` is world_from_local.
    void add(Shape shape, const mat4& place, vec3 albedo) { add(make_shape_mesh(shape), place, matte(albedo)); }
    /// Any mesh of any material.
    void add(MeshData mesh, const mat4& place, const Material& material) {
        RenderScene::Draw draw;
        draw.mesh = meshes_.insert({});
        draw.first_material = static_cast<std::uint32_t>(scene_.materials.size());
        scene_.materials.push_back({material, -1});
        scene_.materials_hash = hash_bytes(scene_.materials_hash, &material.base_colour, sizeof(vec3));
        scene_.draws.push_back(draw);
        replace(scene_.draws.size() - 1, std::move(mesh), place);
    }
    /// Another mesh, or another place, in a draw that is there.
    void replace(std::size_t number, MeshData mesh, const mat4& place) {
        // Two builders' meshes have the same handles; a renderer that draws both must not take one for the other.
        static std::uint32_t meshes_made = 0;
        mesh.version = ++meshes_made;
        meshes_.at(scene_.draws[number].mesh) = std::move(mesh);
        move(number, place);
    }
    void move(std::size_t number, const mat4& place) {
        RenderScene::Draw& draw = scene_.draws[number];
        const MeshData& mesh = meshes_.at(draw.mesh);
        draw.world_from_local = place;
        draw.bounds = transformed(mesh.bounds, place);
        const vec3 colour = scene_.materials[draw.first_material].material.base_colour;
        draw.content = hash_bytes(hash_bytes(hash_mix(number + 1, mesh.version), &place, sizeof place), &colour, sizeof colour);
        scene_.bounds = {};
        for (const RenderScene::Draw& each : scene_.draws) scene_.bounds.add(each.bounds);
    }
    void add(const RenderScene::Light& light) { scene_.lights.push_back(light); }
    void look(vec3 from, vec3 forward, vec3 up, float fov_y) {
        scene_.view = RenderScene::View{.position = from, .forward = forward, .up = up, .fov_y = fov_y, .near = 1e-3f};
    }
    void use(const GiMethod& method) { scene_.gi = GiSettings{method}; }
    RenderScene& scene() { return scene_; }

    static Material matte(vec3 albedo) {
        Material material;
        material.base_colour = albedo;
        material.specular = 0.0f;
        return material;
    }

  private:
    MeshPool meshes_;
    RenderScene scene_;
};

/// A frame's irradiance, and where each pixel's surface is.
struct IrradianceField {
    std::uint32_t width = 0, height = 0;
    std::vector<vec3> position, irradiance;
    std::vector<bool> surface;
};

inline IrradianceField render_irradiance(Renderer& renderer, const RenderScene& scene, std::uint32_t width, std::uint32_t height) {
    const auto result = renderer.render(scene, {.width = width, .height = height, .wanted = {"depth"}, .want_irradiance = true});
    const Image irradiance = renderer.read(result.images.irradiance);
    const Image depth = renderer.read(result.images.gbuffer.depth);
    const FrameParams frame = frame_params(scene, width, height, 0);
    IrradianceField field{.width = width, .height = height};
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const vec2 ndc((static_cast<float>(x) + 0.5f) / static_cast<float>(width) * 2.0f - 1.0f,
                           1.0f - (static_cast<float>(y) + 0.5f) / static_cast<float>(height) * 2.0f);
            const float d = *depth.pixel(x, y);
            field.surface.push_back(d > 0.0f);
            field.position.push_back(vec3(frame.camera_position) + view_ray(frame, ndc) * (d > 0.0f ? view_distance(d, scene.view->near) : 0.0f));
            const float* e = irradiance.pixel(std::min(x, irradiance.width - 1), std::min(y, irradiance.height - 1));
            field.irradiance.push_back(vec3(e[0], e[1], e[2]));
        }
    }
    return field;
}

}  // namespace sl
