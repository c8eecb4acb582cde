// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/entity.h"

namespace sl {

/// The entity in whose space this one is placed. A stale or null parent counts as none.
struct Parent {
    Entity entity;
};

}  // namespace sl
