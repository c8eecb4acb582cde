// SPDX-License-Identifier: MIT
#include "engine/render/trace/trace_scene.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <cstring>

#include "engine/core/error.h"
#include "engine/render/scene/rows.h"

namespace sl {

namespace {

float linear_from_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

/// The finest level of the block textures, decoded.
struct LinearTextures {
    std::uint32_t size = 1;
    std::vector<vec3> texels;  ///< layer after layer, row after row

    explicit LinearTextures(const TextureLayers* layers) {
        if (layers == nullptr) return;
        size = layers->size;
        std::array<float, 256> linear{};
        for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
        for (const auto& bytes : layers->layers) {
            for (std::size_t i = 0; i < std::size_t{size} * size; ++i) {
                texels.emplace_back(linear[bytes[4 * i]], linear[bytes[4 * i + 1]], linear[bytes[4 * i + 2]]);
            }
        }
    }
    vec3 at(std::uint32_t layer, vec2 uv) const {
        const vec2 inside = uv - glm::floor(uv);
        const uvec2 texel = glm::min(uvec2(inside * static_cast<float>(size)), uvec2(size - 1));
        return texels[(std::size_t{layer} * size + texel.y) * size + texel.x];
    }
};

struct TracedVertex {
    vec3 normal;
    vec2 uv;
    vec3 colour;
    std::uint32_t material = 0;  ///< row of the material table
};

/// One draw in world space.
struct TracedMesh {
    std::vector<vec3> positions;
    std::vector<TracedVertex> vertices;
    std::vector<uvec3> triangles;  ///< counter-clockwise seen from the front, also where the draw mirrors
};

vec3 vertex_colour(std::uint32_t rgba) {
    return vec3(rgba & 255u, (rgba >> 8) & 255u, (rgba >> 16) & 255u) / 255.0f;
}

TracedMesh trace_mesh(const MeshData& mesh, const RenderScene::Draw& draw) {
    TracedMesh traced;
    const mat3 turn(normal_matrix(draw.world_from_local));
    for (const Vertex& vertex : mesh.vertices) {
        traced.positions.push_back(vec3(draw.world_from_local * vec4(vertex.position, 1.0f)));
        const vec3 normal = turn * unpack_normal(vertex.normal);
        const float length = glm::length(normal);
        traced.vertices.push_back({.normal = length > 0.0f ? normal / length : vec3(0.0f), .uv = vertex.uv, .colour = vertex_colour(vertex.colour),
                                   .material = draw.first_material + vertex.material});
    }
    const bool mirrored = glm::determinant(mat3(draw.world_from_local)) < 0.0f;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        uvec3 corners(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
        if (mirrored) std::swap(corners.y, corners.z);
        traced.triangles.push_back(corners);
    }
    return traced;
}

void check_embree(void*, RTCError, const char* text) { fail("the ray tracer Embree reports: {}", text != nullptr ? text : "an error"); }

RTCRay to_embree(const Ray& ray) {
    RTCRay result{};
    result.org_x = ray.origin.x;
    result.org_y = ray.origin.y;
    result.org_z = ray.origin.z;
    result.dir_x = ray.direction.x;
    result.dir_y = ray.direction.y;
    result.dir_z = ray.direction.z;
    result.tnear = ray.nearest;
    result.tfar = ray.farthest;
    result.mask = ~0u;
    return result;
}

}  // namespace

struct TraceScene::Data {
    std::vector<TracedMesh> meshes;
    std::vector<MaterialParams> materials;
    LinearTextures textures;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    explicit Data(const TextureLayers* layers) : textures(layers) {}
    ~Data() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    void attach(const TracedMesh& mesh, std::uint32_t id) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3), mesh.positions.size());
        void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3), mesh.triangles.size());
        std::memcpy(positions, mesh.positions.data(), mesh.positions.size() * sizeof(vec3));
        std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(uvec3));
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, id);
        rtcReleaseGeometry(geometry);
    }
};

TraceScene::TraceScene(const RenderScene& scene) : data_(std::make_unique<Data>(scene.textures)) {
    data_->device = rtcNewDevice(nullptr);
    if (data_->device == nullptr) fail("the ray tracer Embree does not start on this processor");
    rtcSetDeviceErrorFunction(data_->device, &check_embree, nullptr);
    data_->scene = rtcNewScene(data_->device);
    rtcSetSceneFlags(data_->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(data_->scene, RTC_BUILD_QUALITY_HIGH);
    for (const MaterialEntry& entry : scene.materials) data_->materials.push_back(material_params(entry));
    for (const RenderScene::Draw& draw : scene.draws) {
        data_->meshes.push_back(trace_mesh(scene.meshes->at(draw.mesh), draw));
        data_->attach(data_->meshes.back(), static_cast<std::uint32_t>(data_->meshes.size()) - 1);
    }
    rtcCommitScene(data_->scene);
}

TraceScene::~TraceScene() = default;

std::optional<TriangleHit> TraceScene::intersect(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray = to_embree(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(data_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const vec3 face(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
    return TriangleHit{.draw = query.hit.geomID, .triangle = query.hit.primID, .u = query.hit.u, .v = query.hit.v,
                       .distance = query.ray.tfar, .front = glm::dot(face, ray.direction) < 0.0f};
}

std::optional<TriangleHit> TraceScene::intersect_front(Ray ray) const {
    for (;;) {
        const auto hit = intersect(ray);
        if (!hit || hit->front) return hit;
        ray = {.origin = surface_at(*hit).origin_towards(ray.direction), .direction = ray.direction};
    }
}

bool TraceScene::occluded(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = to_embree(ray);
    rtcOccluded1(data_->scene, &context, &query);
    return query.tfar < 0.0f;
}

SurfacePoint TraceScene::surface_at(const TriangleHit& hit) const {
    const TracedMesh& mesh = data_->meshes[hit.draw];
    const uvec3 index = mesh.triangles[hit.triangle];
    const vec3 weights(1.0f - hit.u - hit.v, hit.u, hit.v);
    const vec3 &a = mesh.positions[index.x], &b = mesh.positions[index.y], &c = mesh.positions[index.z];
    const TracedVertex &va = mesh.vertices[index.x], &vb = mesh.vertices[index.y], &vc = mesh.vertices[index.z];
    SurfacePoint point;
    // From the corners, not along the ray: the error then depends on the triangle alone.
    point.position = weights.x * a + weights.y * b + weights.z * c;
    const vec3 cross = glm::cross(b - a, c - a);
    const float area = glm::length(cross);
    point.face = area > 0.0f ? cross / area : va.normal;
    const vec3 largest = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
    point.error = std::ldexp(std::max({largest.x, largest.y, largest.z}), -19);

    const vec3 blended = weights.x * va.normal + weights.y * vb.normal + weights.z * vc.normal;
    const float length = glm::length(blended);
    const vec3 normal = length > 1e-6f ? blended / length : point.face;
    const MaterialParams& material = data_->materials[va.material];
    const vec2 uv = weights.x * va.uv + weights.y * vb.uv + weights.z * vc.uv;
    const vec3 texel = material.texture.x == no_texture ? vec3(1.0f) : data_->textures.at(material.texture.x, uv);
    const vec3 colour = surface_colour(material, texel, weights.x * va.colour + weights.y * vb.colour + weights.z * vc.colour);
    point.surface.base_colour = vec4(colour, material.base_colour.w);
    point.surface.normal = vec4(normal, material.emission.w);
    point.surface.specular = material.specular;
    point.emission = surface_emission(material, colour);
    return point;
}

std::array<vec3, 3> TraceScene::corners(std::uint32_t draw, std::uint32_t triangle) const {
    const TracedMesh& mesh = data_->meshes[draw];
    const uvec3 index = mesh.triangles[triangle];
    return {mesh.positions[index.x], mesh.positions[index.y], mesh.positions[index.z]};
}

vec3 TraceScene::plain_emission(std::uint32_t draw, std::uint32_t triangle) const {
    const TracedMesh& mesh = data_->meshes[draw];
    return vec3(data_->materials[mesh.vertices[mesh.triangles[triangle].x].material].emission);
}

std::uint32_t TraceScene::draw_count() const { return static_cast<std::uint32_t>(data_->meshes.size()); }
std::uint32_t TraceScene::triangle_count(std::uint32_t draw) const { return static_cast<std::uint32_t>(data_->meshes[draw].triangles.size()); }

std::uint64_t TraceScene::content_hash() const {
    const auto bytes = [](std::uint64_t hash, const auto& values) { return hash_bytes(hash, values.data(), values.size() * sizeof(values[0])); };
    std::uint64_t hash = bytes(bytes(1, data_->materials), data_->textures.texels);
    for (const TracedMesh& mesh : data_->meshes) hash = bytes(bytes(bytes(hash, mesh.positions), mesh.vertices), mesh.triangles);
    return hash;
}

Bounds TraceScene::bounds() const {
    Bounds result;
    for (const TracedMesh& mesh : data_->meshes) {
        for (const vec3& position : mesh.positions) result.add(position);
    }
    return result;
}

std::uint64_t TraceScene::triangles() const {
    std::uint64_t count = 0;
    for (const TracedMesh& mesh : data_->meshes) count += mesh.triangles.size();
    return count;
}

}  // namespace sl
