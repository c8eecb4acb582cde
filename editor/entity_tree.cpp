// SPDX-License-Identifier: MIT
#include "editor/entity_tree.h"

#include <algorithm>
#include <set>

#include "engine/ecs/components/name.h"
#include "engine/ecs/parent.h"

namespace sl {

namespace {

template <class F>
void each_named(const World& world, F visit) {
    if (const auto* named = world.find_pool<Name>()) std::ranges::for_each(named->entities(), visit);
}

Entity named_parent(const World& world, Entity entity) {
    const Parent* parent = world.find<Parent>(entity);
    return parent != nullptr && world.has<Name>(parent->entity) ? parent->entity : Entity{};
}

/// "lamp" of "lamp 2".
std::string_view without_number(std::string_view name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    const bool numbered = end != std::string_view::npos && end > 0 && end + 1 < name.size() && name[end] == ' ';
    return numbered ? name.substr(0, end) : name;
}

}  // namespace

EntityTree::EntityTree(const World& world) : world_(world) {
    each_named(world, [&](Entity entity) { children_[named_parent(world, entity)].push_back(entity); });
    for (auto& [parent, children] : children_) sort(children);
}

std::vector<Entity> EntityTree::all() const {
    std::vector<Entity> entities;
    for (const auto& [parent, children] : children_) entities.insert(entities.end(), children.begin(), children.end());
    sort(entities);
    return entities;
}

void EntityTree::sort(std::vector<Entity>& entities) const {
    std::ranges::sort(entities, {}, [&](Entity entity) { return std::pair(world_.get<Name>(entity).value, entity); });
}

const std::vector<Entity>& EntityTree::below(Entity parent) const {
    static const std::vector<Entity> none;
    const auto found = children_.find(parent);
    return found == children_.end() ? none : found->second;
}

std::vector<Entity> with_all_below(const World& world, Entity entity) {
    const EntityTree tree(world);
    std::vector<Entity> all{entity};
    std::set<Entity> known{entity};  // parents in a circle end the walk
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (const Entity child : tree.below(all[i])) {
            if (known.insert(child).second) all.push_back(child);
        }
    }
    return all;
}

bool is_below(const World& world, Entity entity, Entity above) {
    return std::ranges::count(with_all_below(world, above), entity) > 0;
}

const std::string& shown_name(const World& world, Entity entity) {
    static const std::string none = "(no name)";
    const Name* name = world.find<Name>(entity);
    return name == nullptr || name->value.empty() ? none : name->value;
}

bool name_is_taken(const World& world, std::string_view name) {
    bool taken = false;
    each_named(world, [&](Entity entity) { taken |= world.get<Name>(entity).value == name; });
    return taken;
}

std::string free_name(const World& world, std::string_view wanted) {
    if (!name_is_taken(world, wanted)) return std::string(wanted);
    const std::string_view stem = without_number(wanted);
    for (int number = 2;; ++number) {
        std::string name = fmt::format("{} {}", stem, number);
        if (!name_is_taken(world, name)) return name;
    }
}

}  // namespace sl
