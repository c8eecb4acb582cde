// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/world_transform.h"

namespace sl {

namespace {

using Node = Placements::Node;

Node local_placement(const Transform& transform) {
    const glm::dquat rotation(transform.rotation);
    const double length = glm::length(rotation);
    Node node{.origin = transform.translation};
    if (length > 0.0) node.linear = glm::mat3_cast(rotation / length);
    for (int axis = 0; axis < 3; ++axis) node.linear[axis] *= static_cast<double>(transform.scale[axis]);
    return node;
}

WorldTransform stored(const Node& node) {
    return {.origin = node.origin, .linear = mat3(node.linear)};
}

class Hierarchy {
  public:
    Hierarchy(const Query<const Transform>& transforms, const Query<const Parent>& parents,
              Placements& placements)
        : transforms_(transforms),
          parents_(parents),
          nodes_(placements.nodes),
          path_(placements.path),
          frame_(++placements.frame) {}

    /// Walks up to what is placed already or has no parent, then down again, placing what was passed.
    const Node& place(Entity entity) {
        path_.clear();
        Node above;
        for (Entity at = entity; transforms_.contains(at) || parents_.contains(at);) {
            Node& node = node_of(at);
            if (node.frame == frame_) {
                above = node.on_path > 0 ? break_circle(node.on_path - 1) : node;
                break;
            }
            path_.push_back(at);
            node.frame = frame_;
            node.on_path = path_.size();
            const auto parent = parents_.find(at);
            if (!parent) break;
            at = std::get<1>(*parent).entity;
        }
        for (; !path_.empty(); path_.pop_back()) above = put(path_.back(), above);
        return node_of(entity);
    }

  private:
    Node& node_of(Entity entity) {
        if (entity.index >= nodes_.size()) nodes_.resize(std::size_t{entity.index} + 1);
        return nodes_[entity.index];
    }

    Node put(Entity entity, const Node& above) {
        const auto transform = transforms_.find(entity);
        const Node local = transform ? local_placement(std::get<1>(*transform)) : Node();
        return node_of(entity) = {.origin = above.origin + above.linear * local.origin,
                                  .linear = above.linear * local.linear,
                                  .frame = frame_};
    }

    /// Where a circle is entered must not matter, so all of its entities lose their parents, not only one.
    Node break_circle(std::size_t first) {
        const Entity entered = path_[first];
        for (; path_.size() > first; path_.pop_back()) put(path_.back(), Node());
        return node_of(entered);
    }

    const Query<const Transform>& transforms_;
    const Query<const Parent>& parents_;
    std::vector<Node>& nodes_;
    std::vector<Entity>& path_;
    std::uint64_t frame_;
};

}  // namespace

void add_world_transforms(World& world) {
    std::vector<Entity> without;
    Query<const Transform, Without<WorldTransform>>(world).each(
        [&](Entity entity, const Transform&) { without.push_back(entity); });
    for (const Entity entity : without) world.add(entity, WorldTransform{});
}

void world_transform(Query<const Transform, WorldTransform, Without<Parent>> roots,
                     Query<const Transform, WorldTransform, With<Parent>> children,
                     Query<const Transform> transforms, Query<const Parent> parents, Placements& placements) {
    roots.each([](const Transform& transform, WorldTransform& world) {
        world = stored(local_placement(transform));
    });
    Hierarchy hierarchy(transforms, parents, placements);
    children.each([&](Entity entity, const Transform&, WorldTransform& world) {
        world = stored(hierarchy.place(entity));
    });
}

}  // namespace sl
