// SPDX-License-Identifier: MIT
#include "engine/render/trace/traced_mesh.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/render/scene/rows.h"
#include "shared/octahedral.h"

namespace sl {

namespace {

vec3 vertex_colour(std::uint32_t rgba) {
    return vec3(rgba & 255u, (rgba >> 8) & 255u, (rgba >> 16) & 255u) / 255.0f;
}

void check_embree(void*, RTCError, const char* text) { fail("the ray tracer Embree reports: {}", text != nullptr ? text : "an error"); }

}  // namespace

std::shared_ptr<RTCDeviceTy> start_embree() {
    RTCDevice device = rtcNewDevice(nullptr);
    if (device == nullptr) fail("the ray tracer Embree does not start on this processor");
    rtcSetDeviceErrorFunction(device, &check_embree, nullptr);
    return {device, [](RTCDevice it) { rtcReleaseDevice(it); }};
}

TracedMesh::TracedMesh(std::shared_ptr<RTCDeviceTy> device, const MeshData& mesh, const RenderScene::Draw& draw) : device_(std::move(device)), both_sides_(mesh.both_sides), open_(draw.open) {
    const mat3 turn(normal_matrix(draw.world_from_local));
    for (const sl::Vertex& vertex : mesh.vertices) {
        positions_.push_back(vec3(draw.world_from_local * vec4(vertex.position, 1.0f)));
        bounds_.add(positions_.back());
        const vec3 normal = turn * unpack_normal(vertex.normal);
        const float length = glm::length(normal);
        vertices_.push_back({.normal = length > 0.0f ? normal / length : vec3(0.0f), .uv = vertex.uv, .colour = vertex_colour(vertex.colour), .alpha = static_cast<float>(vertex.colour >> 24) / 255.0f,
                             .material = draw.first_material + vertex.material});
        materials_.push_back(vertices_.back().material);
    }
    std::ranges::sort(materials_);
    materials_.erase(std::unique(materials_.begin(), materials_.end()), materials_.end());
    const bool mirrored = glm::determinant(mat3(draw.world_from_local)) < 0.0f;
    for (const sl::PicturedVertex& vertex : mesh.pictured) {
        const vec3 tangent = unit_or_zero(mat3(draw.world_from_local) * unpack_normal(vertex.tangent));
        pictured_.push_back({.uv = vertex.uv, .tangent = vec4(tangent, mirrored ? -vertex.hand : vertex.hand)});
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        uvec3 corners(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
        if (mirrored) std::swap(corners.y, corners.z);
        // Triangles that are points meet no ray, and Embree 3 stops the program where all that it looks at lies in one point.
        const vec3& first = positions_[corners.x];
        if (positions_[corners.y] != first || positions_[corners.z] != first) triangles_.push_back(corners);
    }
    give_to_embree();
}

void TracedMesh::move(vec3 offset) {
    for (vec3& position : positions_) position += offset;
    bounds_ = bounds_.moved(offset);
    std::ranges::copy(positions_, static_cast<vec3*>(rtcGetGeometryBufferData(geometry_.get(), RTC_BUFFER_TYPE_VERTEX, 0)));
    rtcUpdateGeometryBuffer(geometry_.get(), RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry_.get());
}

void TracedMesh::give_to_embree() {
    geometry_.reset(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* positions = static_cast<vec3*>(rtcSetNewGeometryBuffer(geometry_.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3), positions_.size()));
    auto* triangles = static_cast<uvec3*>(rtcSetNewGeometryBuffer(geometry_.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3), triangles_.size()));
    std::ranges::copy(positions_, positions);
    std::ranges::copy(triangles_, triangles);
    rtcSetGeometryBuildQuality(geometry_.get(), RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry_.get());
}

}  // namespace sl
