// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/components/transform.h"
#include "engine/ecs/parent.h"
#include "engine/ecs/query.h"

namespace sl {

/// Where entities of a hierarchy stand, in double precision: what world_transform found out this frame. A
/// resource, so that its memory is kept.
struct Placements {
    /// The place of one entity in the world, while it is worked out.
    struct Node {
        dvec3 origin{0.0};
        glm::dmat3 linear{1.0};
        std::uint64_t frame = 0;
        std::size_t on_path = 0;  ///< 1 + position on the way up while it is being placed, 0 once it is
    };
    std::vector<Node> nodes;  ///< by entity index
    std::vector<Entity> path;
    std::uint64_t frame = 0;
};

/// Gives each entity with a Transform the WorldTransform that world_transform writes to.
void add_world_transforms(World& world);

/// Transform and Parent to WorldTransform, the only writer of it. Any depth and order. A parent that has
/// died, or has no Transform, adds nothing of its own; entities whose parents form a circle are placed as if
/// they had none. An entity that loses its Transform stays where it was.
void world_transform(Query<const Transform, WorldTransform, Without<Parent>> roots,
                     Query<const Transform, WorldTransform, With<Parent>> children,
                     Query<const Transform> transforms, Query<const Parent> parents, Placements& placements);

}  // namespace sl
