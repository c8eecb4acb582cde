// SPDX-License-Identifier: MIT
#include "game/camera_choice.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "engine/ecs/systems/load_models.h"

namespace sl {

namespace {

/// Of a model's part: the camera's own name, or its node's.
std::string name_in_model(World& world, Entity entity) {
    const auto* part = world.find<ModelPart>(entity);
    const auto* parts = part != nullptr ? world.find<ModelParts>(part->owner) : nullptr;
    if (parts == nullptr || !parts->model) return "";
    const auto number = static_cast<std::size_t>(std::ranges::find(parts->nodes, entity) - parts->nodes.begin());
    const ModelNode& node = parts->model->nodes.at(number);
    const std::string& name = parts->model->cameras.at(static_cast<std::size_t>(node.camera)).name;
    return name.empty() ? node.name : name;
}

}  // namespace

void choose_camera(World& world, const std::string& camera) {
    std::vector<Entity> cameras;
    std::vector<std::string> names;
    for (auto [entity, view] : Query<const Camera>(world)) {
        const auto* name = world.find<Name>(entity);
        cameras.push_back(entity);
        names.push_back(name != nullptr ? name->value : name_in_model(world, entity));
    }
    if (cameras.empty()) fail("--camera {}: there is no camera to choose", camera);
    auto chosen = static_cast<std::size_t>(std::ranges::find(names, camera) - names.begin());
    const char* end = camera.data() + camera.size();
    if (chosen == names.size() && std::from_chars(camera.data(), end, chosen).ptr != end) chosen = names.size();
    if (chosen >= names.size()) fail("{}, or a number from 0 to {}", no_such_name("camera", camera, names), names.size() - 1);
    for (std::size_t i = 0; i < cameras.size(); ++i) world.get<Camera>(cameras[i]).active = i == chosen;
}

}  // namespace sl
