// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/build_shapes.h"

#include <glm/common.hpp>

#include "engine/ecs/systems/shape_mesh.h"

namespace sl {

namespace {

// By bits: a size that is not a number would differ from itself and be built again each frame.
bool same(const Shape& a, const Shape& b) {
    return a.kind == b.kind && glm::floatBitsToUint(a.size) == glm::floatBitsToUint(b.size);
}

bool draws(const Query<const MeshInstance>& instances, Entity entity, MeshHandle mesh) {
    const auto instance = instances.find(entity);
    return instance && std::get<1>(*instance).mesh == mesh;
}

void erase_orphans(const Query<const Shape>& shapes, const Query<const MeshInstance>& instances,
                   ShapeMeshes& built, MeshPool& meshes, Commands& commands) {
    // Backwards, because the last one moves into the hole.
    for (std::uint32_t i = built.by_entity.size(); i-- > 0;) {
        const Entity entity = built.by_entity.entities()[i];
        if (shapes.contains(entity)) continue;
        const MeshHandle mesh = built.by_entity.values()[i].mesh;
        if (draws(instances, entity, mesh)) commands.remove<MeshInstance>(entity);
        meshes.erase(mesh);
        built.by_entity.erase(entity);
    }
}

MeshHandle build(const Shape& shape, Entity entity, ShapeMeshes& built, MeshPool& meshes) {
    ShapeMeshes::Built* known = built.by_entity.find(entity);
    MeshData* mesh = known == nullptr ? nullptr : meshes.find(known->mesh);
    if (mesh == nullptr) {
        return built.by_entity.add(entity, {shape, meshes.insert(make_shape_mesh(shape))}).mesh;
    }
    if (!same(shape, known->shape)) {
        const std::uint32_t version = mesh->version;
        *mesh = make_shape_mesh(shape);
        mesh->version = version + 1;
        known->shape = shape;
    }
    return known->mesh;
}

}  // namespace

void build_shapes(Query<const Shape> shapes, Query<const MeshInstance> instances, ShapeMeshes& built,
                  MeshPool& meshes, Commands& commands) {
    // First, because a new entity may have the index of one that died, and the table holds an index once.
    erase_orphans(shapes, instances, built, meshes, commands);
    shapes.each([&](Entity entity, const Shape& shape) {
        const MeshHandle mesh = build(shape, entity, built, meshes);
        if (!draws(instances, entity, mesh)) commands.add(entity, MeshInstance{.mesh = mesh});
    });
}

}  // namespace sl
