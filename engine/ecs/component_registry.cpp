// SPDX-License-Identifier: MIT
#include "engine/ecs/component_registry.h"

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/ecs/components.h"

namespace sl {

void ComponentRegistry::insert(ComponentType type) {
    CHECK(find(type.name) == nullptr, "two components are called '{}'", type.name);
    CHECK(type.name != "name" && type.name != "parent" && type.name != "remove",
          "'{}' is a key of entities in scene files and cannot name a component", type.name);
    types_.push_back(std::move(type));
}

const ComponentType* ComponentRegistry::find(std::string_view name) const {
    for (const ComponentType& type : types_) {
        if (type.name == name) return &type;
    }
    return nullptr;
}

const ComponentType& ComponentRegistry::get(std::string_view name, std::string_view where) const {
    if (const ComponentType* found = find(name)) return *found;
    std::vector<std::string_view> known;
    for (const ComponentType& type : types_) known.push_back(type.name);
    fail("{}: {}", where, no_such_name("component", name, known));
}

void register_engine_components(ComponentRegistry& registry) {
    registry.add<Transform>("transform");
    registry.add<Camera>("camera");
    registry.add<GiSettings>("gi");
    registry.add<DirectionalLight>("directional_light");
    registry.add<SunAngles>("sun");
    registry.add<DayCycle>("day_cycle");
    registry.add<SpotLight>("spot_light");
    registry.add<PointLight>("point_light");
    registry.add<SkyLight>("sky");
    registry.add<Shape>("shape");
    registry.add<Material>("material");
    registry.add<ModelFile>("model");
}

}  // namespace sl
