// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "shared/facets.h"

namespace sl {

/// A cell of the lattice, as one number.
using FacetName = std::uint64_t;

inline FacetName facet_name(const FacetCell& cell) { return (FacetName{cell.name.x} << 32) | cell.name.y; }

}  // namespace sl
