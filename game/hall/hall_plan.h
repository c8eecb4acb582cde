// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall.h"
#include "game/hall/hall_detail.h"

namespace sl {

/// Measures of the hall that several of its parts share, m.
namespace hall_plan {

inline constexpr double bay = 4.0;                                   ///< from column to column
inline constexpr int bays_x = 2, bays_z = 6;                         ///< along the court's sides
inline constexpr double court_x = 4.0, court_z = 12.0;               ///< from its middle to the columns
inline constexpr double wall_x = 8.0, wall_z = 16.0;                 ///< from its middle to the outer walls
inline constexpr double ledge = 0.4;                                 ///< floors reach as far beyond the columns' axes
inline constexpr double spring = 3.0;                                ///< where the lower arches and vaults begin
inline constexpr double gallery_below = 5.0, gallery = 5.4;          ///< the gallery's floor
inline constexpr double upper_spring = gallery + 2.3;                ///< where the upper arches begin
inline constexpr double ceiling = 9.8, roof = 10.3;
inline constexpr double arch_radius = 1.6, lower_wall = 0.6, upper_wall = 0.5;

}  // namespace hall_plan

/// Numbers of Hall::materials.
enum class HallSurface { stone, plaster, tile, wood, red, green, blue, clay, marble };

/// Floors, walls, ceilings and roof: what closes the hall.
void add_hall_shell(Hall& hall, const HallDetail& detail);
/// Columns, arches, vaults and balustrades.
void add_hall_arcades(Hall& hall, const HallDetail& detail);
/// Cloth, vases, statuettes.
void add_hall_furniture(Hall& hall, const HallDetail& detail, std::uint64_t seed);

}  // namespace sl
