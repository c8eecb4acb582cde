// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "engine/render/gl/buffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/graph/frame_graph.h"
#include "engine/render/scene/light_map.h"

namespace sl {

/// The scene's arrays as the frame's passes read them.
struct SceneInputs {
    BufferId draws, materials, lights;
    ImageId textures;
    BufferId pictures;  ///< these three only where some material reads pictures
    ImageId picture_colours, picture_data;
    std::vector<DrawCall> calls;  ///< one per RenderScene::Draw
    std::vector<DrawCall> water_calls;  ///< one per surface of water
    std::uint64_t triangles = 0;
    const RenderScene* scene = nullptr;

    /// The calls of some draws, for one pass.
    DrawList list(const std::vector<std::uint32_t>& draws) const;
    /// The same without what is known to face away from `eye`: a place (w = 1), or a direction (w = 0).
    DrawList list_facing(const std::vector<std::uint32_t>& draws, vec4 eye) const;
    DrawList water_list(const std::vector<std::uint32_t>& waters) const;
};

/// Keeps GPU copies of meshes, materials and textures, and refreshes what changed.
class GpuScene {
  public:
    SceneInputs upload(FrameGraph& graph, const RenderScene& scene, const LightTable& lights);
    /// Bytes of vertex and index buffers held.
    std::uint64_t mesh_bytes() const;

  private:
    struct GpuMesh {
        gl::Buffer vertices, pictured, indices;
        bool has_pictured = false;
        std::uint32_t index_count = 0;
        std::uint32_t version = 0;
        std::uint64_t used_in = 0;
    };
    const GpuMesh& refresh(const RenderScene& scene, MeshHandle handle);
    void refresh_textures(const RenderScene& scene);
    void refresh_pictures(const RenderScene& scene);

    std::map<MeshHandle, GpuMesh> meshes_;
    gl::Buffer draws_, materials_, lights_, pictures_;
    gl::Texture textures_, picture_colours_, picture_data_;
    std::uint32_t textures_version_ = ~0u, pictures_version_ = ~0u;
    std::uint64_t frame_ = 0;
};

}  // namespace sl
