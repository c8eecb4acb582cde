// SPDX-License-Identifier: MIT
#include "editor/capture_command.h"

#include <algorithm>
#include <ranges>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/field_list.h"
#include "engine/ecs/active_camera.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "engine/ecs/scene_file.h"
#include "engine/ecs/set_field.h"

namespace sl {

namespace {

Entity entity_called(World& world, std::string_view wanted) {
    for (auto [entity, name] : Query<const Name>(world)) {
        if (name.value == wanted) return entity;
    }
    return {};
}

/// Makes the scene as its file has it into the one that is shown, and notes each flag that does so. It goes the
/// way of the command that will read them, so that what they add up to is known here.
class CommandWords {
  public:
    CommandWords(World& shown, const ComponentRegistry& registry) : shown_(shown), registry_(registry) {}

    std::vector<std::string> words;

    void choose_scene() {
        const auto* info = shown_.find_resource<SceneInfo>();
        if (info == nullptr || info->path.empty()) fail("this scene has no file yet: save it");
        read_scene(made_, registry_, info->path);
        add("--scene", std::filesystem::absolute(info->path).string());
    }

    /// The cameras that are active in only one of the two.
    void choose_camera() {
        std::vector<std::pair<std::string, bool>> wrong;
        for (auto [entity, name, camera] : Query<const Name, const Camera>(made_)) {
            const Entity other = entity_called(shown_, name.value);
            const Camera* now = other ? shown_.find<Camera>(other) : nullptr;
            const bool active = now != nullptr && now->active;
            if (active != camera.active) wrong.emplace_back(name.value, active);
        }
        for (const auto& [name, active] : wrong) set(fmt::format("{}.camera.active={}", checked(name), active));
    }

    void choose_method(Entity shown_camera) {
        const auto* wanted = shown_.find<GiSettings>(shown_camera);
        const std::string_view name = wanted != nullptr ? wanted->method.name() : GiOff::name;
        const Entity camera = active_camera(made_);
        const auto* now = camera ? made_.find<GiSettings>(camera) : nullptr;
        if (now != nullptr ? now->method.name() == name : wanted == nullptr) return;
        add("--gi", std::string(name));
        const GiSettings settings{make_gi_method(name)};
        if (camera) made_.add(camera, settings);
        for (auto [entity, other] : Query<GiSettings>(made_)) other = settings;
    }

    void set_fields(Entity shown_entity, std::string_view component) {
        const ComponentType& type = registry_.get(component, "capture");
        if (!type.has(shown_, shown_entity)) return;
        const std::string& name = shown_.get<Name>(shown_entity).value;
        const Entity entity = entity_called(made_, name);
        if (!entity || !type.has(made_, entity)) {
            fail("the scene's file has no {} of '{}': save the scene", component, for_message(name));
        }
        // From the last one, because fields that stand for others, as presets do, come before those.
        FieldLister wanted;
        type.visit_copy(shown_, shown_entity, wanted);
        for (const FieldRow& row : wanted.rows | std::views::reverse) {
            if (value_of(type, entity, row.name) == row.value) continue;
            set(fmt::format("{}.{}={}", address(type, name), row.name, row.value));
        }
    }

  private:
    void add(std::string flag, std::string value) {
        // What begins like a flag would be taken for one.
        if (value.starts_with('-')) {
            words.push_back(std::move(flag) + "=" + std::move(value));
        } else {
            words.insert(words.end(), {std::move(flag), std::move(value)});
        }
    }
    void set(std::string assignment) {
        set_field(made_, registry_, assignment);
        add("--set", std::move(assignment));
    }
    std::string value_of(const ComponentType& type, Entity entity, std::string_view field) const {
        FieldLister lister;
        type.visit_copy(made_, entity, lister);
        const auto row = std::ranges::find(lister.rows, field, &FieldRow::name);
        return row == lister.rows.end() ? "" : row->value;
    }
    /// Without the entity's name where no other has the component.
    std::string address(const ComponentType& type, const std::string& name) const {
        int count = 0;
        made_.each_entity([&](Entity entity) { count += type.has(made_, entity); });
        return count == 1 ? type.name : fmt::format("{}.{}", checked(name), type.name);
    }
    static const std::string& checked(const std::string& name) {
        if (name.find('=') != std::string::npos) fail("no flag can name '{}', which has a '=' in it: rename it", for_message(name));
        return name;
    }

    World& shown_;
    const ComponentRegistry& registry_;
    World made_;
};

}  // namespace

std::vector<std::string> capture_command(World& world, const ComponentRegistry& registry, uvec2 size) {
    const Entity camera = active_camera(world);
    if (!camera) fail("no camera is active");
    if (!world.has<Name>(camera)) fail("the active camera has no name");
    CommandWords flags(world, registry);
    flags.words = {"secondlight", "capture"};
    flags.choose_scene();
    flags.choose_camera();
    flags.choose_method(camera);
    for (const std::string_view component : {"gi", "camera", "transform"}) flags.set_fields(camera, component);
    flags.words.insert(flags.words.end(), {"--size", fmt::format("{}x{}", size.x, size.y), "-o", "picture.png"});
    return std::move(flags.words);
}

}  // namespace sl
