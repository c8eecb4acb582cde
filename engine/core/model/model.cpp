// SPDX-License-Identifier: MIT
#include "engine/core/model/model.h"

namespace sl {

std::vector<std::optional<mat4>> places_of(const Model& model, std::size_t scene) {
    std::vector<std::optional<mat4>> places(model.nodes.size());
    if (scene >= model.scenes.size()) return places;
    for (const std::int32_t root : model.scenes[scene].roots) places[static_cast<std::size_t>(root)] = mat4(1.0f);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const ModelNode& node = model.nodes[i];
        if (node.parent >= 0 && places[static_cast<std::size_t>(node.parent)]) places[i] = places[static_cast<std::size_t>(node.parent)];
        if (!places[i]) continue;
        mat4 local = glm::mat4_cast(node.rotation);
        for (int axis = 0; axis < 3; ++axis) local[axis] *= node.scale[axis];
        local[3] = vec4(vec3(node.translation), 1.0f);
        places[i] = *places[i] * local;
    }
    return places;
}

Bounds bounds_of(const Model& model, std::size_t scene) {
    const auto places = places_of(model, scene);
    Bounds bounds;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (!places[i] || model.nodes[i].mesh < 0) continue;
        for (const ModelPrimitive& primitive : model.meshes[static_cast<std::size_t>(model.nodes[i].mesh)].primitives) {
            if (!primitive.mesh.bounds.empty()) bounds.add(transformed(primitive.mesh.bounds, *places[i]));
        }
    }
    return bounds;
}

}  // namespace sl
