// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "engine/render/trace/path_walk.h"

namespace sl {

/// Finds the lit points whose reflected light some places need, by tracing a few paths from each, and points the world's
/// light paths at them. `trace` follows path `number` from a place and lists the lit points that it found; it may run on
/// any number of threads. The result depends on the places alone.
void learn_light_paths(TransportWorld& world, std::size_t places, const std::function<void(std::size_t place, std::uint32_t number, std::vector<LitPoint>& lit)>& trace);

}  // namespace sl
