// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <vector>

#include "engine/render/scene/render_scene.h"

namespace sl {

/// The ray tracer Embree; ends with the last mesh that needs it. Throws Error when it cannot start.
std::shared_ptr<RTCDeviceTy> start_embree();

/// One draw's triangles in world space.
class TracedMesh {
  public:
    /// What is known of a point of a surface besides its place.
    struct Vertex {
        vec3 normal;
        vec2 uv;
        vec3 colour;
        float alpha = 1.0f;
        std::uint32_t material = 0;  ///< row of the material table
    };

    /// What pictures of its material need besides.
    struct PicturedVertex {
        vec2 uv;       ///< second texture coordinates
        vec4 tangent;  ///< as relief_normal takes it
    };

    /// Throws Error when there is no memory.
    TracedMesh(std::shared_ptr<RTCDeviceTy> device, const MeshData& mesh, const RenderScene::Draw& draw);

    const std::vector<vec3>& positions() const { return positions_; }
    const std::vector<Vertex>& vertices() const { return vertices_; }
    /// One per vertex, or none.
    const std::vector<PicturedVertex>& pictured() const { return pictured_; }
    /// Counter-clockwise seen from the front, also where the draw mirrors.
    const std::vector<uvec3>& triangles() const { return triangles_; }
    const Bounds& bounds() const { return bounds_; }
    /// Rows of the material table that it has, each once.
    const std::vector<std::uint32_t>& materials() const { return materials_; }
    /// Each triangle is there twice, the second time turned.
    bool both_sides() const { return both_sides_; }
    /// Its material has holes, or is see-through.
    bool open() const { return open_; }
    /// Changes all positions by `offset`, m.
    void move(vec3 offset);
    RTCGeometry geometry() const { return geometry_.get(); }

  private:
    void give_to_embree();

    struct Release {
        void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    };

    std::shared_ptr<RTCDeviceTy> device_;
    std::vector<vec3> positions_;
    std::vector<Vertex> vertices_;
    std::vector<PicturedVertex> pictured_;
    std::vector<uvec3> triangles_;
    std::vector<std::uint32_t> materials_;
    Bounds bounds_;
    bool both_sides_ = false, open_ = false;
    std::unique_ptr<RTCGeometryTy, Release> geometry_;
};

}  // namespace sl
