// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/ecs/component_registry.h"

namespace sl {

/// JSON Schema (draft 2020-12) of scene files of the newest version, without their comments. What a schema cannot say is left
/// to read_scene: that names are unique, that what parents, includes and references name exists, that rotations have a length.
nlohmann::ordered_json scene_schema(const ComponentRegistry& registry);

}  // namespace sl
