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
    if (parts.posed.empty()) return;
    auto& pool = world.resource<MeshPool>();
    const std::vector<mat4> places = places_of(model, pose);
    // Many nodes may hang on one skin.
    std::vector<std::optional<std::vector<mat4>>> skins(model.skins.size());
    const std::vector<mat4> none;
    const auto joints_of = [&](std::int32_t skin) -> const std::vector<mat4>& {
        if (skin < 0) return none;
        auto& joints = skins[static_cast<std::size_t>(skin)];
        if (!joints) joints = joint_matrices(model.skins[static_cast<std::size_t>(skin)], places);
        return *joints;
    };
    for (const ModelParts::Posed& posed : parts.posed) {
        const ModelNode& node = model.nodes[posed.node];
        const ModelPrimitive& primitive = model.meshes[static_cast<std::size_t>(node.mesh)].primitives[posed.primitive];
        MeshData* mesh = pool.find(world.get<ModelPart>(posed.entity).own_mesh);
        if (mesh == nullptr) continue;
        deform(primitive, primitive.mesh, pose.weights[posed.node], joints_of(node.skin), *mesh);
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
