// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/schedule.h"

namespace sl {

/// What the engine's systems and scene files need: MeshPool, FrameClock, DayPause, their tables, and the ComponentRegistry with
/// the engine's components. Resources that are there already are kept.
void add_engine_resources(World& world);

/// Registers the engine's systems; the world must have the engine's resources when it runs.
void add_engine_systems(Schedule& schedule);

}  // namespace sl
