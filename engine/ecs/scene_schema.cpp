// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_schema.h"

#include <nlohmann/json.hpp>

#include "engine/core/field_schema.h"
#include "engine/ecs/scene_document.h"

namespace sl {

using nlohmann::ordered_json;

namespace {

bool same_keys(const ordered_json& a, const ordered_json& b) {
    for (const auto& item : a.items()) {
        if (!b.contains(item.key())) return false;
    }
    return a.size() == b.size();
}

/// The component's fields for each alternative of the choice that other fields depend on, as the GI method; none where nothing
/// does.
ordered_json variants(const ComponentType& type, const ordered_json& properties) {
    for (const auto& [name, property] : properties.items()) {
        if (!property.contains("enum")) continue;
        ordered_json found = ordered_json::array();
        bool differ = false;
        for (const auto& alternative : property["enum"]) {
            ordered_json fields;
            FieldSchema schema(fields, name, found.size());
            type.visit_default(schema);
            differ |= !same_keys(fields, properties);
            found.push_back({{"title", alternative}, {"properties", std::move(fields)}, {"additionalProperties", false}});
        }
        if (differ) return found;
    }
    return ordered_json::array();
}

ordered_json component_schema(const ComponentType& type) {
    ordered_json properties;
    FieldSchema schema(properties);
    type.visit_default(schema);
    ordered_json component = {{"type", {"object", "null"}}};
    if (ordered_json found = variants(type, properties); !found.empty()) {
        component["anyOf"] = std::move(found);
    } else {
        component["properties"] = std::move(properties);
        component["additionalProperties"] = false;
    }
    return component;
}

ordered_json text_schema(std::string_view description) {
    return {{"description", description}, {"type", "string"}};
}

ordered_json name_schema(std::string_view description) {
    return {{"description", description}, {"type", "string"}, {"minLength", 1}};
}

ordered_json entity_schema(const ComponentRegistry& registry) {
    ordered_json properties = ordered_json::object();
    properties[std::string(scene_key::name)] =
        name_schema("Unique in its file. Entities of one name in a file and in what it includes are one.");
    properties[std::string(scene_key::parent)] = {
        {"description", "Name of the entity whose transform this one's follows; null is none."},
        {"type", {"string", "null"}},
        {"minLength", 1}};
    properties[std::string(scene_key::remove)] = {
        {"description", "true leaves out the entity of this name that an included file has; it then has no key but its name."},
        {"type", "boolean"}};
    for (const ComponentType& type : registry.types()) properties[type.name] = component_schema(type);
    return {{"description", "Its other keys are components; null takes away what an included file gives it."},
            {"type", "object"},
            {"properties", std::move(properties)},
            {"required", {scene_key::name}},
            {"additionalProperties", false},
            {"if", {{"properties", {{scene_key::remove, {{"const", true}}}}}, {"required", {scene_key::remove}}}},
            {"then", {{"maxProperties", 2}}}};
}

}  // namespace

ordered_json scene_schema(const ComponentRegistry& registry) {
    ordered_json properties = ordered_json::object();
    properties[std::string(scene_key::schema)] = text_schema("Where this schema lies, for editors.");
    properties[std::string(scene_key::version)] = {{"description", "Version of the format."}, {"const", scene_version}};
    properties[std::string(scene_key::description)] = text_schema("What the scene is, in one line.");
    properties[std::string(scene_key::include)] =
        name_schema("Another scene file that this one changes and adds to: relative, in the same folder or below.");
    properties[std::string(scene_key::entities)] = {{"type", "array"}, {"items", entity_schema(registry)}};
    return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", "Secondlight scene"},
            {"description",
             "Lengths are in metres, angles in radians, light in lux, candela and nit; +y is up, and cameras and lights look along -z. "
             "Fields that are left out have their default, or what an included file says. Comments (// and /* */) are passed over."},
            {"type", "object"},
            {"properties", std::move(properties)},
            {"required", {scene_key::version}},
            {"additionalProperties", false}};
}

}  // namespace sl
