// SPDX-License-Identifier: MIT
#include "editor/entity_parts.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "engine/core/fields_json.h"
#include "engine/ecs/components/name.h"
#include "engine/ecs/parent.h"

namespace sl {

namespace {

std::string compact_text(const nlohmann::ordered_json& object) {
    return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

PartValue parent_value(const EntityParts& parts, Entity entity) {
    const Parent* parent = parts.world.find<Parent>(entity);
    if (parent == nullptr || !parts.world.alive(parent->entity)) return std::nullopt;
    return fmt::format("{}", static_cast<std::uint64_t>(parts.keys.key_of(parent->entity)));
}

EntityKey key_from(const std::string& text) {
    std::uint64_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return EntityKey{number};
}

template <class T>
void write_own(World& world, Entity entity, bool there, T value) {
    there ? void(world.add(entity, std::move(value))) : world.remove<T>(entity);
}

void write_component(World& world, const ComponentType& type, Entity entity, const PartValue& value) {
    if (!value) return type.remove(world, entity);
    if (!type.has(world, entity)) type.add_default(world, entity);
    const auto object = nlohmann::json::parse(*value);
    JsonReader reader(object, type.name);
    type.visit(world, entity, reader);
}

}  // namespace

PartValue EntityParts::read(Entity entity, std::string_view part) const {
    if (!world.alive(entity)) return std::nullopt;
    if (part == entity_part::existence) return "";
    if (part == entity_part::parent) return parent_value(*this, entity);
    if (part == entity_part::name) {
        const Name* name = world.find<Name>(entity);
        return name == nullptr ? PartValue() : name->value;
    }
    const ComponentType& type = registry.get(part, "editor");
    if (!type.has(world, entity)) return std::nullopt;
    nlohmann::ordered_json object;
    JsonWriter writer(object);
    type.visit_copy(world, entity, writer);
    return compact_text(object);
}

void EntityParts::write(Entity entity, std::string_view part, const PartValue& value) const {
    if (part == entity_part::name) {
        write_own(world, entity, value.has_value(), Name{value.value_or("")});
    } else if (part == entity_part::parent) {
        const Entity parent = keys.entity_of(key_from(value.value_or("0")));
        write_own(world, entity, value.has_value(), Parent{parent});
    } else {
        write_component(world, registry.get(part, "editor"), entity, value);
    }
}

std::vector<std::string_view> EntityParts::of(Entity entity) const {
    std::vector<std::string_view> parts;
    for (const std::string_view own : {entity_part::name, entity_part::parent}) {
        if (read(entity, own)) parts.push_back(own);
    }
    for (const ComponentType& type : registry.types()) {
        if (type.has(world, entity)) parts.push_back(type.name);
    }
    return parts;
}

std::string default_value(const ComponentType& type) {
    nlohmann::ordered_json object;
    JsonWriter writer(object);
    type.visit_default(writer);
    return compact_text(object);
}

}  // namespace sl
