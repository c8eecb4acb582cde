// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/mesh_data.h"
#include "engine/ecs/commands.h"
#include "engine/ecs/components/mesh_instance.h"
#include "engine/ecs/components/shape.h"
#include "engine/ecs/query.h"

namespace sl {

/// Which mesh was built from which shape, a resource. It outlives the entities, so that their meshes are
/// erased.
struct ShapeMeshes {
    /// A mesh, and the shape it was made from.
    struct Built {
        Shape shape;
        MeshHandle mesh;
    };
    ComponentPool<Built> by_entity;
};

/// Keeps for each entity with a Shape a mesh and the MeshInstance that draws it; the instance comes at the
/// end of the stage. A changed shape changes its mesh in place. Mesh and instance go with the Shape or its
/// entity.
void build_shapes(Query<const Shape> shapes, Query<const MeshInstance> instances, ShapeMeshes& built,
                  MeshPool& meshes, Commands& commands);

}  // namespace sl
