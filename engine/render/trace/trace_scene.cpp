// SPDX-License-Identifier: MIT
#include "engine/render/trace/trace_scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "engine/render/scene/rows.h"
#include "engine/render/trace/traced_mesh.h"

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
    std::shared_ptr<RTCDeviceTy> device = start_embree();
    RTCScene scene = rtcNewScene(device.get());
    std::vector<std::unique_ptr<TracedMesh>> meshes;         ///< by their numbers in Embree's scene; null where one was
    std::unordered_multimap<std::uint64_t, std::uint32_t> number;  ///< by a draw's content
    std::vector<std::uint32_t> free;                               ///< numbers of none
    std::vector<MaterialParams> materials;
    std::optional<std::uint64_t> textures_version;
    LinearTextures textures{nullptr};

    Data() {
        // A tree for each mesh and one over them, so that a change builds anew what has changed: Embree makes these for low
        // quality alone, which is that of the upper tree.
        rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC));
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);
    }
    ~Data() { rtcReleaseScene(scene); }

    std::uint32_t add(std::unique_ptr<TracedMesh> mesh) {
        if (free.empty()) {
            free.push_back(static_cast<std::uint32_t>(meshes.size()));
            meshes.emplace_back();
        }
        const std::uint32_t id = free.back();
        free.pop_back();
        rtcAttachGeometryByID(scene, mesh->geometry(), id);
        meshes[id] = std::move(mesh);
        return id;
    }
    void remove(std::uint32_t id) {
        rtcDetachGeometry(scene, id);
        meshes[id].reset();
        free.push_back(id);
    }
};

TraceScene::TraceScene(const RenderScene& scene) : data_(std::make_unique<Data>()) { update(scene); }

void TraceScene::update(const RenderScene& scene) {
    const std::uint64_t textures_version = scene.textures != nullptr ? scene.textures->version : 0;
    if (std::exchange(data_->textures_version, textures_version) != textures_version) data_->textures = LinearTextures(scene.textures);
    data_->materials.clear();
    for (const MaterialEntry& entry : scene.materials) data_->materials.push_back(material_params(entry));
    auto before = std::exchange(data_->number, {});
    std::vector<const RenderScene::Draw*> fresh;
    for (const RenderScene::Draw& draw : scene.draws) {
        if (const auto same = before.find(draw.content); same != before.end()) {
            data_->number.insert(before.extract(same));
        } else {
            fresh.push_back(&draw);
        }
    }
    for (const auto& [content, id] : before) data_->remove(id);
    std::vector<std::unique_ptr<TracedMesh>> meshes(fresh.size());
    tbb::parallel_for(std::size_t{0}, fresh.size(), [&](std::size_t i) {
        meshes[i] = std::make_unique<TracedMesh>(data_->device, scene.meshes->at(fresh[i]->mesh), *fresh[i]);
    });
    for (std::size_t i = 0; i < fresh.size(); ++i) data_->number.emplace(fresh[i]->content, data_->add(std::move(meshes[i])));
    rtcCommitScene(data_->scene);
}

void TraceScene::move(vec3 offset) {
    tbb::parallel_for(std::size_t{0}, data_->meshes.size(), [&](std::size_t i) {
        if (data_->meshes[i]) data_->meshes[i]->move(offset);
    });
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
    const TracedMesh& mesh = *data_->meshes[hit.draw];
    const uvec3 index = mesh.triangles()[hit.triangle];
    const vec3 weights(1.0f - hit.u - hit.v, hit.u, hit.v);
    const vec3 &a = mesh.positions()[index.x], &b = mesh.positions()[index.y], &c = mesh.positions()[index.z];
    const TracedMesh::Vertex &va = mesh.vertices()[index.x], &vb = mesh.vertices()[index.y], &vc = mesh.vertices()[index.z];
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
    const TracedMesh& mesh = *data_->meshes[draw];
    const uvec3 index = mesh.triangles()[triangle];
    return {mesh.positions()[index.x], mesh.positions()[index.y], mesh.positions()[index.z]};
}

bool TraceScene::glows(std::uint32_t draw) const {
    return data_->meshes[draw] && std::ranges::any_of(data_->meshes[draw]->materials(), [&](std::uint32_t row) { return vec3(data_->materials[row].emission) != vec3(0.0f); });
}

vec3 TraceScene::plain_emission(std::uint32_t draw, std::uint32_t triangle) const {
    const TracedMesh& mesh = *data_->meshes[draw];
    return vec3(data_->materials[mesh.vertices()[mesh.triangles()[triangle].x].material].emission);
}

std::uint32_t TraceScene::draw_count() const { return static_cast<std::uint32_t>(data_->meshes.size()); }
std::uint32_t TraceScene::triangle_count(std::uint32_t draw) const { 
    return data_->meshes[draw] ? static_cast<std::uint32_t>(data_->meshes[draw]->triangles().size()) : 0;
}

std::uint64_t TraceScene::content_hash() const {
    const auto bytes = [](std::uint64_t hash, const auto& values) { return hash_bytes(hash, values.data(), values.size() * sizeof(values[0])); };
    std::uint64_t hash = bytes(bytes(1, data_->materials), data_->textures.texels);
    for (const auto& mesh : data_->meshes) {
        if (mesh) hash = bytes(bytes(bytes(hash, mesh->positions()), mesh->vertices()), mesh->triangles());
    }
    return hash;
}

Bounds TraceScene::bounds() const {
    Bounds result;
    for (const auto& mesh : data_->meshes) {
        if (mesh) result.add(mesh->bounds());
    }
    return result;
}

std::uint64_t TraceScene::triangles() const {
    std::uint64_t count = 0;
    for (const auto& mesh : data_->meshes) count += mesh ? mesh->triangles().size() : 0;
    return count;
}

}  // namespace sl
