// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall_detail.h"
#include "game/hall/hall_mesh.h"

namespace sl {

/// All of these stand on 0.

/// A post of a balustrade, 0.75 m high.
HallMesh baluster(const HallDetail& detail);
inline constexpr double baluster_height = 0.75;

/// A hollow vase with two handles, 1.1 m high.
HallMesh vase(const HallDetail& detail);

/// A moulded pedestal, 0.9 m high.
HallMesh pedestal(const HallDetail& detail);
inline constexpr double pedestal_height = 0.9;

/// A band that goes three times round a ring as it goes twice along it, 0.9 m high.
HallMesh knot(const HallDetail& detail);

}  // namespace sl
