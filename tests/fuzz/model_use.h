// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/core/check.h"
#include "engine/core/model/model_pose.h"

namespace sl {

/// Does with a model that was read what a game does, and stops where the file has left something in it that does not fit together.
inline void use_model(const Model& model) {
    CHECK(model.scenes.empty() || model.scene < model.scenes.size(), "scene {} of {}", model.scene, model.scenes.size());
    for (std::size_t i = 0; i < model.scenes.size(); ++i) (void)bounds_of(model, i);
    const auto is_one_of = [](std::int32_t number, std::size_t count, const char* what) { CHECK(number >= -1 && number < static_cast<std::int64_t>(count), "{} {} of {}", what, number, count); };
    const auto is_finite = [](auto... numbers) { CHECK((std::isfinite(numbers) && ...), "a number is none"); };
    for (const ModelMaterial& material : model.materials) {
        is_finite(material.base_colour.x, material.alpha, material.metallic, material.roughness, material.specular, material.emission.x, material.normal_scale, material.alpha_cutoff);
        for (const ModelTexture* texture : {&material.base_colour_texture, &material.metallic_roughness_texture, &material.normal_texture, &material.emission_texture, &material.occlusion_texture}) {
            is_one_of(texture->image, model.images.size(), "image");
        }
    }
    for (const ModelMesh& mesh : model.meshes) {
        for (const ModelPrimitive& primitive : mesh.primitives) {
            for (const Vertex& vertex : primitive.mesh.vertices) is_finite(vertex.position.x, vertex.position.y, vertex.position.z, vertex.uv.x, vertex.uv.y);
            for (const PicturedVertex& vertex : primitive.mesh.pictured) is_finite(vertex.uv.x, vertex.uv.y, vertex.hand);
            CHECK(primitive.mesh.pictured.empty() || primitive.mesh.pictured.size() == primitive.mesh.vertices.size(), "{} pictured vertices of {}", primitive.mesh.pictured.size(), primitive.mesh.vertices.size());
            is_one_of(primitive.material, model.materials.size(), "material");
            for (const std::uint32_t index : primitive.mesh.indices) CHECK(index < primitive.mesh.vertices.size(), "vertex {} of {}", index, primitive.mesh.vertices.size());
        }
    }
    for (const ModelNode& node : model.nodes) is_finite(node.translation.x, node.rotation.x, node.rotation.w, node.scale.x, node.scale.y, node.scale.z);
    for (const ModelLight& light : model.lights) is_finite(light.colour.x, light.intensity, light.range, light.inner_cone, light.outer_cone);
    for (const ModelCamera& camera : model.cameras) is_finite(camera.fov_y, camera.height, camera.near);
    const auto show = [&](const ModelPose& pose) {
        const std::vector<mat4> places = places_of(model, pose);
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            const ModelNode& node = model.nodes[i];
            is_one_of(node.parent, i, "parent");
            is_one_of(node.mesh, model.meshes.size(), "mesh");
            is_one_of(node.skin, model.skins.size(), "skin");
            is_one_of(node.light, model.lights.size(), "light");
            is_one_of(node.camera, model.cameras.size(), "camera");
            if (node.mesh < 0) continue;
            const auto joints = node.skin >= 0 ? joint_matrices(model.skins[static_cast<std::size_t>(node.skin)], places) : std::vector<mat4>();
            for (const ModelPrimitive& primitive : model.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
                MeshData moved;
                if (deforms(primitive)) deform(primitive, primitive.mesh, pose.weights[i], joints, moved);
            }
        }
    };
    show(rest_of(model));
    for (const ModelAnimation& animation : model.animations) {
        for (const double part : {0.0, 0.4, 1.0}) show(pose_at(model, animation, part * double{animation.length}));
    }
}

}  // namespace sl
