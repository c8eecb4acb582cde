// SPDX-License-Identifier: MIT
#include "engine/render/upload.h"

#include "engine/render/scene/facing_runs.h"
#include "engine/render/scene/rows.h"

namespace sl {

namespace {

DrawList chosen(const std::vector<DrawCall>& calls, const std::vector<std::uint32_t>& numbers) {
    auto list = std::make_shared<std::vector<DrawCall>>();
    list->reserve(numbers.size());
    for (const std::uint32_t number : numbers) list->push_back(calls[number]);
    return list;
}

/// One white texel where there are no layers.
gl::Texture array_of(const TextureLayers* layers, Format format, const char* label) {
    if (layers == nullptr || layers->layers.empty()) {
        gl::Texture texture({.layers = 1, .format = format}, label);
        const std::vector<std::uint8_t> white{255, 255, 255, 255};
        texture.upload(0, 0, std::as_bytes(std::span(white)));
        return texture;
    }
    gl::Texture texture({.width = layers->size, .height = layers->size, .layers = static_cast<std::uint32_t>(layers->layers.size()), .mips = layers->mips, .format = format}, label);
    for (std::uint32_t layer = 0; layer < layers->layers.size(); ++layer) {
        std::span<const std::uint8_t> bytes(layers->layers[layer]);
        for (std::uint32_t mip = 0; mip < layers->mips; ++mip) {
            const std::size_t side = std::max(layers->size >> mip, 1u);
            texture.upload(mip, layer, std::as_bytes(bytes.first(side * side * 4)));
            bytes = bytes.subspan(side * side * 4);
        }
    }
    return texture;
}

}  // namespace

DrawList SceneInputs::list(const std::vector<std::uint32_t>& draws_) const { return chosen(calls, draws_); }
DrawList SceneInputs::list_facing(const std::vector<std::uint32_t>& draws_, vec4 eye) const {
    auto list = std::make_shared<std::vector<DrawCall>>();
    for (const std::uint32_t number : draws_) {
        const RenderScene::Draw& draw = scene->draws[number];
        for (const IndexRun& run : facing_runs(scene->meshes->at(draw.mesh), draw.world_from_local, eye)) {
            DrawCall& call = list->emplace_back(calls[number]);
            call.first_index = run.first;
            call.index_count = run.count;
        }
    }
    return list;
}
DrawList SceneInputs::water_list(const std::vector<std::uint32_t>& waters) const { return chosen(water_calls, waters); }

const GpuScene::GpuMesh& GpuScene::refresh(const RenderScene& scene, MeshHandle handle) {
    const MeshData& mesh = scene.meshes->at(handle);
    GpuMesh& gpu = meshes_[handle];
    if (gpu.used_in == 0 || gpu.version != mesh.version) {
        gpu.vertices.upload(mesh.vertices, "vertices");
        gpu.has_pictured = !mesh.pictured.empty();
        if (gpu.has_pictured) gpu.pictured.upload(mesh.pictured, "pictured vertices");
        gpu.indices.upload(mesh.indices, "indices");
        gpu.index_count = static_cast<std::uint32_t>(mesh.indices.size());
        gpu.version = mesh.version;
    }
    gpu.used_in = frame_;
    return gpu;
}

void GpuScene::refresh_textures(const RenderScene& scene) {
    const std::uint32_t version = scene.textures != nullptr ? scene.textures->version : 0;
    if (textures_ && version == textures_version_) return;
    textures_version_ = version;
    textures_ = array_of(scene.textures, Format::srgb8_alpha8, "block textures");
}

void GpuScene::refresh_pictures(const RenderScene& scene) {
    if (picture_colours_ && scene.pictures.version == pictures_version_) return;
    pictures_version_ = scene.pictures.version;
    picture_colours_ = array_of(scene.pictures.colours.get(), Format::srgb8_alpha8, "picture colours");
    picture_data_ = array_of(scene.pictures.data.get(), Format::rgba8, "picture data");
}

SceneInputs GpuScene::upload(FrameGraph& graph, const RenderScene& scene, const LightTable& lights) {
    ++frame_;
    SceneInputs inputs;
    inputs.scene = &scene;
    std::vector<DrawParams> draws;
    draws.reserve(scene.draws.size() + scene.waters.size());
    const auto add = [&](const RenderScene::Draw& draw, std::vector<DrawCall>& calls) {
        const GpuMesh& mesh = refresh(scene, draw.mesh);
        const bool mirrored = glm::determinant(mat3(draw.world_from_local)) < 0.0f;
        calls.push_back({.vertex_buffer = mesh.vertices.id(), .index_buffer = mesh.indices.id(),
                         .index_count = mesh.index_count, .draw_index = static_cast<std::uint32_t>(draws.size()),
                         .mirrored = mirrored,
                         .pictured_vertex_buffer = mesh.has_pictured ? mesh.pictured.id() : 0});
        draws.push_back({.world_from_local = draw.world_from_local, .normal_from_local = normal_matrix(draw.world_from_local),
                         .first_material = uvec4(draw.first_material, mirrored ? 1 : 0, 0, 0)});
    };
    for (const RenderScene::Draw& draw : scene.draws) add(draw, inputs.calls);
    for (const DrawCall& call : inputs.calls) inputs.triangles += call.index_count / 3;
    for (const RenderScene::Draw& water : scene.waters) add(water, inputs.water_calls);
    // A mesh that no draw names any more has left the scene.
    std::erase_if(meshes_, [&](const auto& entry) { return entry.second.used_in != frame_; });

    const MaterialRows rows = material_rows(scene);
    draws_.upload(draws, "draws");
    materials_.upload(rows.materials, "materials");
    pictures_.upload(rows.pictures, "pictures");
    lights_.upload(lights.params, "lights");
    refresh_textures(scene);
    refresh_pictures(scene);

    inputs.draws = graph.import_buffer("draws", draws.size() * sizeof(DrawParams), draws_.id());
    inputs.materials = graph.import_buffer("materials", rows.materials.size() * sizeof(MaterialParams), materials_.id());
    inputs.lights = graph.import_buffer("lights", lights.params.size() * sizeof(LightParams), lights_.id());
    inputs.textures = graph.import_image("block_textures", textures_.desc(), textures_.id());
    if (rows.pictures.empty()) return inputs;
    inputs.pictures = graph.import_buffer("pictures", rows.pictures.size() * sizeof(PictureParams), pictures_.id());
    inputs.picture_colours = graph.import_image("picture_colours", picture_colours_.desc(), picture_colours_.id());
    inputs.picture_data = graph.import_image("picture_data", picture_data_.desc(), picture_data_.id());
    return inputs;
}

std::uint64_t GpuScene::mesh_bytes() const {
    std::uint64_t bytes = 0;
    for (const auto& [handle, mesh] : meshes_) bytes += mesh.vertices.capacity() + mesh.pictured.capacity() + mesh.indices.capacity();
    return bytes;
}

}  // namespace sl
