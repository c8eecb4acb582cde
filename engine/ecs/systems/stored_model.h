// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "engine/core/model/model.h"
#include "engine/ecs/systems/model_pictures.h"
#include "engine/ecs/world.h"

namespace sl {

/// What a model has in the world's MeshPool, MaterialTable and PictureTable, for all entities that show it.
struct StoredModel {
    std::vector<std::vector<MeshHandle>> meshes;  ///< per mesh, per primitive; null for those that each entity has its own of
    std::int32_t first_material = 0;  ///< row in the MaterialTable
    std::int32_t materials = 0;       ///< one more than the file has, the plain one last
    std::uint32_t first_colour = 0, colours = 0, first_data = 0, data = 0;  ///< layers in the PictureTable
};

/// Moves a model's meshes into the world, and adds its materials and pictures.
StoredModel store_model(World& world, Model& model, const ModelPictures& pictures);

/// Gives all of it back. What lies behind it in the tables moves down, and so do the rows that entities name and what `others` hold.
void remove_model(World& world, const StoredModel& stored, std::span<StoredModel* const> others);

}  // namespace sl
