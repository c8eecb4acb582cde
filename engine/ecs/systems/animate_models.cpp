// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/animate_models.h"

#include "engine/core/clock.h"
#include "engine/core/mesh_data.h"
#include "engine/core/model/model_pose.h"
#include "engine/ecs/components/transform.h"
#include "engine/ecs/query.h"
#include "engine/ecs/systems/load_models.h"

namespace sl {

namespace {

void move_vertices(World& world, const ModelParts& parts, const ModelPose& pose) {
    const Model& model = *parts.model;
    auto& pool = world.resource<MeshPool>();
    for (const ModelParts::Posed& posed : parts.posed) {
        const ModelNode& node = model.nodes[posed.node];
        const ModelPrimitive& primitive = model.meshes[static_cast<std::size_t>(node.mesh)].primitives[posed.primitive];
        const std::vector<mat4> joints = node.skin >= 0 ? joint_matrices(model, model.skins[static_cast<std::size_t>(node.skin)], pose) : std::vector<mat4>{};
        MeshData* mesh = pool.find(world.get<ModelPart>(posed.entity).own_mesh);
        if (mesh == nullptr) continue;
        deform(primitive, primitive.mesh, pose.weights[posed.node], joints, *mesh);
        ++mesh->version;
    }
}

}  // namespace

void animate_models(World& world) {
    const double seconds = world.resource<FrameClock>().seconds;
    for (auto [entity, file, parts] : Query<const ModelFile, ModelParts>(world)) {
        if (!parts.made) continue;
        const auto number = static_cast<std::size_t>(file.animation);
        const bool plays = file.animation >= 0 && number < parts.model->animations.size();
        // A model at rest is put there once, for its skins and morphs may have it stand otherwise than its meshes lie in the file.
        const double at = plays ? seconds * double{file.speed} : -1.0;
        if (parts.posed_at == at) continue;
        parts.posed_at = at;
        const ModelPose pose = plays ? pose_at(*parts.model, parts.model->animations[number], at) : rest_of(*parts.model);
        for (std::size_t i = 0; i < parts.nodes.size(); ++i) {
            if (!parts.nodes[i] || !world.alive(parts.nodes[i])) continue;
            auto& transform = world.get<Transform>(parts.nodes[i]);
            transform.translation = pose.nodes[i].translation;
            transform.rotation = pose.nodes[i].rotation;
            transform.scale = pose.nodes[i].scale;
        }
        move_vertices(world, parts, pose);
    }
}

}  // namespace sl
