// SPDX-License-Identifier: MIT
#pragma once

#include "editor/edit_history.h"

namespace sl {

/// The scene that people edit, and what they did to it.
struct EditedScene {
    World& world;
    const ComponentRegistry& registry;
    EditHistory& history;

    EntityParts parts() const { return {world, registry, history.keys()}; }
};

/// One step in the making: each call changes the world at once, and what was changed is remembered as one step
/// at the end of its life.
class SceneEdit {
  public:
    SceneEdit(const EditedScene& scene, std::string label) : scene_(scene), step_{std::move(label), {}} {}
    ~SceneEdit();
    SceneEdit(const SceneEdit&) = delete;
    SceneEdit& operator=(const SceneEdit&) = delete;

    /// A new entity with a name.
    Entity create(std::string name);
    /// Nothing takes the part away.
    void set(Entity entity, std::string_view part, const PartValue& value);
    void destroy(Entity entity);
    /// Takes an entity that was just made elsewhere into the step.
    void adopt(Entity entity);

  private:
    void note(Entity entity, std::string_view part, PartValue before, PartValue after);

    EditedScene scene_;
    EditStep step_;
};

}  // namespace sl
