// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/mesh_data.h"

namespace sl {

/// Cells with a number each; 0 is empty.
struct VoxelGrid {
    ivec3 size{0};
    std::vector<std::uint8_t> cells;  ///< x runs first, then y, then z

    std::uint8_t at(ivec3 cell) const {
        const bool inside = glm::all(glm::greaterThanEqual(cell, ivec3(0))) && glm::all(glm::lessThan(cell, size));
        return inside ? cells[index(cell)] : std::uint8_t{0};
    }
    std::size_t index(ivec3 cell) const {
        return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(cell.y)) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(cell.x);
    }
};

/// Merged faces of all grids of a model: a few bytes of a file may become a hundred times as many.
inline constexpr std::size_t most_voxel_faces = std::size_t{1} << 22;

/// The faces between full and empty cells, equal neighbours merged greedily. A cell is one metre wide, cell (0, 0, 0) begins at `low`;
/// Vertex.material is the cell's number less one. Takes the faces off what is left of `most_voxel_faces`; throws Error where that is
/// not enough.
MeshData voxel_mesh(const VoxelGrid& grid, vec3 low, std::size_t& faces_left);

}  // namespace sl
