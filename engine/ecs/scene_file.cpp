// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_file.h"

#include <map>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <unordered_set>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/fields_json.h"
#include "engine/core/json_text.h"
#include "engine/core/text_file.h"
#include "engine/ecs/components/name.h"
#include "engine/ecs/parent.h"
#include "engine/ecs/scene_document.h"
#include "engine/ecs/scene_references.h"

namespace sl {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

void apply_layer(World& world, const ComponentRegistry& registry, Entity entity, const SceneLayer& layer,
                 const MovedReferences& references) {
    for (const auto& item : layer.object->items()) {
        const std::string& key = item.key();
        if (key == scene_key::name || key == scene_key::parent || key == scene_key::remove) continue;
        const ComponentType& type = registry.get(key, layer.where);
        if (item.value().is_null()) {
            type.remove(world, entity);
            continue;
        }
        if (!type.has(world, entity)) type.add_default(world, entity);
        json component = item.value();
        references.move_in(type, component);
        JsonReader reader(component, fmt::format("{}/{}", layer.where, key));
        type.visit(world, entity, reader);
        reader.check_all_used();
    }
}

void build(World& world, const ComponentRegistry& registry, const SceneDocument& document,
           std::vector<Entity>& made) {
    const std::filesystem::path folder = document.paths.front().parent_path();
    std::unordered_map<std::string_view, Entity> by_name;
    std::map<std::shared_ptr<const std::filesystem::path>, MovedReferences> references;  // from each folder, which takes long to look up
    for (const SceneEntity& scene_entity : document.entities) {
        const Entity entity = world.create(Name{scene_entity.name});
        made.push_back(entity);
        by_name[scene_entity.name] = entity;
        for (const SceneLayer& layer : scene_entity.layers) apply_layer(world, registry, entity, layer, references.try_emplace(layer.folder, *layer.folder, folder).first->second);
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
        const auto& parent = document.entities[i].parent;
        if (parent) world.add(made[i], Parent{by_name.at(*parent)});
    }
}

std::string parent_name(const World& world, Entity parent, std::string_view child, const std::string& file) {
    if (const Name* name = world.find<Name>(parent)) return name->value;
    fail("{}: not written, because the parent of '{}' has no name; give it one", file, for_message(child));
}

ordered_json entity_json(const World& world, const ComponentRegistry& registry, Entity entity,
                         const MovedReferences& references, const std::string& file) {
    ordered_json object = ordered_json::object();
    const std::string& name = world.get<Name>(entity).value;
    object[std::string(scene_key::name)] = name;
    if (const Parent* parent = world.find<Parent>(entity); parent != nullptr && world.alive(parent->entity)) {
        object[std::string(scene_key::parent)] = parent_name(world, parent->entity, name, file);
    }
    for (const ComponentType& type : registry.types()) {
        if (!type.has(world, entity)) continue;
        ordered_json& component = object[type.name];
        JsonWriter writer(component);
        type.visit_copy(world, entity, writer);
        references.move_in(type, component);
    }
    return object;
}

}  // namespace

std::filesystem::path references_folder(const World& world) {
    const auto* info = world.find_resource<SceneInfo>();
    if (info == nullptr) return {};
    return info->folder.empty() ? info->path.parent_path() : info->folder;
}

void read_scene(World& world, const ComponentRegistry& registry, const std::filesystem::path& path) {
    add_scene(world, registry, read_scene_document(path));
}

void add_scene(World& world, const ComponentRegistry& registry, const SceneDocument& document) {
    std::vector<Entity> made;
    try {
        build(world, registry, document, made);
    } catch (...) {
        for (const Entity entity : made) world.destroy(entity);
        throw;
    }
    world.add_resource(SceneInfo{.description = document.description, .path = document.paths.front(), .schema = document.schema});
}

void write_scene(const World& world, const ComponentRegistry& registry, const std::filesystem::path& path) {
    const std::string file = path.string();
    const MovedReferences references(references_folder(world), path.parent_path());
    const auto* info = world.find_resource<SceneInfo>();
    ordered_json scene = ordered_json::object();
    if (info != nullptr && !info->schema.empty()) {
        const bool is_url = info->schema.find("://") != std::string::npos;
        scene[std::string(scene_key::schema)] = is_url ? info->schema : references.moved(info->schema);
    }
    scene[std::string(scene_key::version)] = scene_version;
    if (info != nullptr && !info->description.empty()) scene[std::string(scene_key::description)] = info->description;
    ordered_json& entities = scene[std::string(scene_key::entities)] = ordered_json::array();
    std::unordered_set<std::string_view> names;
    if (const auto* named = world.find_pool<Name>()) {
        if (named->size() > most_scene_entities) fail("{}: not written, because there are {} entities; {} is the limit", file, named->size(), most_scene_entities);
        for (const Entity entity : named->entities()) {
            const std::string& name = world.get<Name>(entity).value;
            if (name.empty()) fail("{}: not written, because an entity has an empty name; name it", file);
            if (!names.insert(name).second) {
                fail("{}: not written, because two entities are called '{}'; rename one", file,
                     for_message(name));
            }
            entities.push_back(entity_json(world, registry, entity, references, file));
        }
    }
    write_text_file(path, json_text(scene));
}

}  // namespace sl
