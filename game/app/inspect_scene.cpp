// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "engine/core/field_list.h"
#include "engine/ecs/query.h"
#include "engine/ecs/scene_document.h"
#include "engine/ecs/scene_file.h"
#include "engine/ecs/systems/load_models.h"
#include "game/app/inspect.h"
#include "game/model_scene.h"
#include "game/session.h"

namespace sl {

namespace {

struct ComponentCount {
    const std::string& name;
    std::size_t entities;
};

std::vector<ComponentCount> counted(const World& world, const ComponentRegistry& registry) {
    std::vector<ComponentCount> counts;
    for (const ComponentType& type : registry.types()) {
        std::size_t entities = 0;
        world.each_entity([&](Entity entity) { entities += type.has(world, entity); });
        if (entities > 0) counts.push_back({type.name, entities});
    }
    return counts;
}

/// "lamp: spot_light, intensity 800 cd": per component that has any, the fields of a kind that say something.
template <class Kind>
std::vector<std::string> fields_told(const World& world, const ComponentRegistry& registry, Kind&& is_kind) {
    // Scenes may have a million entities, of components without such fields.
    std::vector<const ComponentType*> types;
    for (const ComponentType& type : registry.types()) {
        FieldLister lister;
        type.visit_default(lister);
        if (std::ranges::any_of(lister.rows, is_kind)) types.push_back(&type);
    }
    std::vector<std::string> lines;
    world.each_entity([&](Entity entity) {
        for (const ComponentType* type : types) {
            if (!type->has(world, entity)) continue;
            FieldLister lister;
            type->visit_copy(world, entity, lister);
            std::string fields;
            for (const FieldRow& row : lister.rows) {
                if (is_kind(row) && !row.value.empty() && row.value != "0") fields += fmt::format(", {} {}{}{}", row.name, row.value, row.unit.empty() ? "" : " ", row.unit);
            }
            if (!fields.empty()) lines.push_back(fmt::format("{}: {}{}", world.get<Name>(entity).value, type->name, fields));
        }
    });
    return lines;
}

bool is_light(const FieldRow& row) {
    return row.unit == "lux" || row.unit == "cd" || row.unit == "nit";
}

bool is_file(const FieldRow& row) { return row.type == "file"; }

/// Of all models that are shown.
std::set<std::string> model_warnings(World& world) {
    std::set<std::string> warnings;
    for (auto [entity, file, parts] : Query<const ModelFile, const ModelParts>(world)) {
        if (!parts.model) continue;
        for (const std::string& warning : parts.model->warnings) warnings.insert(fmt::format("{}: {}", model_path(world, file).string(), warning));
    }
    return warnings;
}

}  // namespace

void inspect_scene(const std::filesystem::path& path) {
    App app = empty_game();
    World& world = app.world;
    world.resource<ModelLibrary>().at_once = true;
    const auto files = [&] {
        const SceneDocument document = read_scene_document(path);
        add_scene(world, app.registry(), document);
        return document.paths;
    }();
    const auto& info = world.resource<SceneInfo>();
    fmt::print("{}{}{}\n", path.string(), info.description.empty() ? "" : ": ", info.description);
    print_part("includes", std::span(files).subspan(1), [](const std::filesystem::path& file) { return file.string(); });
    fmt::print("entities: {}\n", world.entity_count());
    print_part("components", counted(world, app.registry()), [](const ComponentCount& count) { return fmt::format("{}: {}", count.name, count.entities); });
    const auto same = [](const std::string& line) { return line; };
    print_part("light", fields_told(world, app.registry(), is_light), same);
    print_part("files", fields_told(world, app.registry(), is_file), same);
    app.schedule.run(world);  // makes meshes of blocks, shapes and models
    fmt::print("triangles: {}\n", triangles_of_meshes(world));
    print_bounds(bounds_of_meshes(world));
    const std::set<std::string> warnings = model_warnings(world);
    print_part("ignored", std::vector<std::string>(warnings.begin(), warnings.end()), same);
}

}  // namespace sl
