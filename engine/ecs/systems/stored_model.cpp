// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/stored_model.h"

#include <algorithm>
#include <utility>

#include "engine/core/model/model_pose.h"
#include "engine/ecs/query.h"

namespace sl {

namespace {

template <class Table>
Table& table_of(World& world) {
    return world.find_resource<Table>() != nullptr ? world.resource<Table>() : world.emplace_resource<Table>();
}

Material material_of(const ModelMaterial& from) {
    const float emission = std::max({from.emission.x, from.emission.y, from.emission.z});
    return {.base_colour = from.base_colour, .metallic = from.metallic, .roughness = from.roughness, .specular = from.specular,
            .emission_colour = emission > 0.0f ? from.emission / emission : vec3(1.0f), .emission = emission};
}

/// glTF's material of primitives without one.
ModelMaterial plain_material() { return {}; }

/// The layers a row names, those of colours and then those of data.
std::array<std::uint32_t*, 2> colour_layers(PictureParams& params) { return {&params.layers.x, &params.layers.y}; }
std::array<std::uint32_t*, 2> data_layers(PictureParams& params) { return {&params.layers.z, &params.layers.w}; }

void move_up(std::span<std::uint32_t* const> layers, std::uint32_t by) {
    for (std::uint32_t* layer : layers) *layer += *layer == no_texture ? 0 : by;
}

/// A number of something that lies in a table from which `count` are taken at `first`.
template <class Number>
void close_gap(Number& number, Number first, Number count) {
    if (number >= first + count) number -= count;
}

void remove_layers(std::shared_ptr<const TextureLayers>& from, std::uint32_t first, std::uint32_t count) {
    if (count == 0) return;
    if (from->layers.size() == count) {
        from = nullptr;
        return;
    }
    TextureLayers kept{.size = from->size, .mips = from->mips, .layers = {}};
    for (std::uint32_t i = 0; i < from->layers.size(); ++i) {
        if (i < first || i >= first + count) kept.layers.push_back(from->layers[i]);
    }
    from = std::make_shared<const TextureLayers>(std::move(kept));
}

}  // namespace

StoredModel store_model(World& world, Model& model, const ModelPictures& pictures) {
    auto& table = table_of<MaterialTable>(world);
    StoredModel stored{.meshes = {}, .first_material = static_cast<std::int32_t>(table.entries.size()), .materials = static_cast<std::int32_t>(model.materials.size() + 1)};
    std::tie(stored.first_colour, stored.first_data) = add_pictures(table_of<PictureTable>(world), pictures);
    stored.colours = static_cast<std::uint32_t>(pictures.colours.layers.size());
    stored.data = static_cast<std::uint32_t>(pictures.data.layers.size());
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        auto params = pictures.materials[i];
        if (params) {
            move_up(colour_layers(*params), stored.first_colour);
            move_up(data_layers(*params), stored.first_data);
        }
        table.entries.push_back({.material = material_of(model.materials[i]), .texture_layer = -1, .pictures = params, .unlit = model.materials[i].unlit});
    }
    table.entries.push_back({material_of(plain_material()), -1});
    ++table.version;
    auto& pool = world.resource<MeshPool>();
    for (ModelMesh& mesh : model.meshes) {
        auto& handles = stored.meshes.emplace_back();
        // Each that is moved is a copy of what stays here.
        for (ModelPrimitive& primitive : mesh.primitives) handles.push_back(deforms(primitive) ? MeshHandle{} : pool.insert(std::exchange(primitive.mesh, {})));
    }
    return stored;
}

void remove_model(World& world, const StoredModel& stored, std::span<StoredModel* const> others) {
    for (const auto& mesh : stored.meshes) {
        for (const MeshHandle handle : mesh) world.resource<MeshPool>().erase(handle);
    }
    auto& table = world.resource<MaterialTable>();
    const auto row = table.entries.begin() + stored.first_material;
    table.entries.erase(row, row + stored.materials);
    ++table.version;
    auto& pictures = world.resource<PictureTable>();
    remove_layers(pictures.colours, stored.first_colour, stored.colours);
    remove_layers(pictures.data, stored.first_data, stored.data);
    ++pictures.version;
    for (MaterialEntry& entry : table.entries) {
        if (!entry.pictures) continue;
        for (std::uint32_t* layer : colour_layers(*entry.pictures)) {
            if (*layer != no_texture) close_gap(*layer, stored.first_colour, stored.colours);
        }
        for (std::uint32_t* layer : data_layers(*entry.pictures)) {
            if (*layer != no_texture) close_gap(*layer, stored.first_data, stored.data);
        }
    }
    for (auto [entity, instance] : Query<MeshInstance>(world)) close_gap(instance.first_material, stored.first_material, stored.materials);
    for (StoredModel* other : others) {
        close_gap(other->first_material, stored.first_material, stored.materials);
        close_gap(other->first_colour, stored.first_colour, stored.colours);
        close_gap(other->first_data, stored.first_data, stored.data);
    }
}

}  // namespace sl
