// SPDX-License-Identifier: MIT
#include "engine/render/trace/trace_scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "engine/core/srgb.h"
#include "engine/render/scene/rows.h"
#include "engine/render/trace/picture_reader.h"
#include "engine/render/trace/traced_mesh.h"

namespace sl {

namespace {

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
    MaterialRows materials;
    std::optional<std::uint64_t> textures_version;
    LinearTextures textures{nullptr};
    PictureReader picture_colours, picture_data;
    Relief relief;
    /// What Embree gives back when it asks about a hit.
    struct Asked {
        const Data* data;
        std::uint32_t id;
    };
    std::vector<std::unique_ptr<Asked>> asked;  ///< by the meshes' numbers; of those alone whose hits are asked about

    explicit Data(Relief relief_) : relief(relief_) {
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
            asked.emplace_back();
        }
        const std::uint32_t id = free.back();
        free.pop_back();
        asked[id].reset();
        if (mesh->both_sides() || mesh->open()) {
            asked[id] = std::make_unique<Asked>(Asked{this, id});
            rtcSetGeometryUserData(mesh->geometry(), asked[id].get());
            rtcSetGeometryIntersectFilterFunction(mesh->geometry(), &leave_out);
            rtcSetGeometryOccludedFilterFunction(mesh->geometry(), &leave_out);
            rtcCommitGeometry(mesh->geometry());
        }
        rtcAttachGeometryByID(scene, mesh->geometry(), id);
        meshes[id] = std::move(mesh);
        return id;
    }
    /// The first and the second texture coordinates of a point.
    struct Coordinates {
        vec2 first, second;
    };
    /// A texel of one of a material's pictures.
    static vec4 texel(const PictureReader& reader, std::uint32_t layer, std::uint32_t second, const PicturePlace& place, const PictureParams& params, const Coordinates& uv) {
        return reader.at(layer, picture_inside(place, picture_place(place, second == 0 ? uv.first : uv.second), params.alpha.z));
    }
    MaterialParams pictured(const MaterialParams& material, const Coordinates& uv) const {
        const PictureParams& params = materials.pictures[material.texture.y - 1];
        return pictured_material(material, vec3(texel(picture_colours, params.layers.x, params.second.x, params.colour, params, uv)),
                                 vec3(texel(picture_colours, params.layers.y, params.second.y, params.emission, params, uv)),
                                 vec3(texel(picture_data, params.layers.z, params.second.z, params.data, params, uv)));
    }
    /// Tilts the normal of a point whose material has a normal texture.
    void tilt(SurfacePoint& point, const PictureParams& params, const Coordinates& uv, vec4 tangent) const {
        if (relief == Relief::flat || params.layers.w == no_texture) return;
        point.vertex_normal = point.normal();
        const vec3 normal(texel(picture_data, params.layers.w, params.second.w, params.relief, params, uv));
        point.surface.normal = vec4(relief_normal(point.vertex_normal, tangent, normal, params.alpha.w), point.surface.normal.w);
    }
    bool is_open(const TracedMesh& mesh, std::uint32_t triangle, float u, float v) const;
    static void leave_out(const RTCFilterFunctionNArguments* hit);
    void remove(std::uint32_t id) {
        rtcDetachGeometry(scene, id);
        meshes[id].reset();
        free.push_back(id);
    }
};

/// A hit does not count on a back whose front lies at the same place, nor where a material is open.
void TraceScene::Data::leave_out(const RTCFilterFunctionNArguments* hit) {
    const auto* asked = static_cast<const Asked*>(hit->geometryUserPtr);
    const TracedMesh& mesh = *asked->data->meshes[asked->id];
    for (unsigned i = 0; i < hit->N; ++i) {
        if (hit->valid[i] == 0) continue;
        const vec3 direction(RTCRayN_dir_x(hit->ray, hit->N, i), RTCRayN_dir_y(hit->ray, hit->N, i), RTCRayN_dir_z(hit->ray, hit->N, i));
        const vec3 face(RTCHitN_Ng_x(hit->hit, hit->N, i), RTCHitN_Ng_y(hit->hit, hit->N, i), RTCHitN_Ng_z(hit->hit, hit->N, i));
        const std::uint32_t triangle = RTCHitN_primID(hit->hit, hit->N, i);
        const float u = RTCHitN_u(hit->hit, hit->N, i), v = RTCHitN_v(hit->hit, hit->N, i);
        const bool behind = mesh.both_sides() && glm::dot(face, direction) > 0.0f;
        if (behind || (mesh.open() && asked->data->is_open(mesh, triangle, u, v))) hit->valid[i] = 0;
    }
}

bool TraceScene::Data::is_open(const TracedMesh& mesh, std::uint32_t triangle, float u, float v) const {
    const uvec3 index = mesh.triangles()[triangle];
    const vec3 weights(1.0f - u - v, u, v);
    const TracedMesh::Vertex &a = mesh.vertices()[index.x], &b = mesh.vertices()[index.y], &c = mesh.vertices()[index.z];
    const MaterialParams& material = materials.materials[a.material];
    if (material.texture.y == 0) return false;
    const PictureParams& params = materials.pictures[material.texture.y - 1];
    const vec2 uv = weights.x * a.uv + weights.y * b.uv + weights.z * c.uv;
    const float alpha = params.alpha.x * (weights.x * a.alpha + weights.y * b.alpha + weights.z * c.alpha) * texel(picture_colours, params.layers.x, 0, params.colour, params, {uv, uv}).w;
    // By chance, which differs from place to place and from ray to ray, as light passes what is see-through.
    const std::uint64_t chance = hash_mix(hash_mix(triangle, std::bit_cast<std::uint32_t>(u)), std::bit_cast<std::uint32_t>(v));
    return picture_cover(params, alpha) <= static_cast<float>(chance >> 40) * 0x1p-24f;
}

TraceScene::TraceScene(const RenderScene& scene, Relief relief) : data_(std::make_unique<Data>(relief)) { update(scene); }

void TraceScene::update(const RenderScene& scene) {
    const std::uint64_t textures_version = scene.textures != nullptr ? scene.textures->version : 0;
    if (std::exchange(data_->textures_version, textures_version) != textures_version) data_->textures = LinearTextures(scene.textures);
    data_->materials = material_rows(scene);
    data_->picture_colours = PictureReader(scene.pictures.colours, PictureReader::Encoding::srgb);
    data_->picture_data = PictureReader(scene.pictures.data, PictureReader::Encoding::linear);
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
    MaterialParams material = data_->materials.materials[va.material];
    const vec2 uv = weights.x * va.uv + weights.y * vb.uv + weights.z * vc.uv;
    point.surface.normal = vec4(normal, 0.0f);
    if (material.texture.y > 0) {
        Data::Coordinates coordinates{uv, uv};
        if (!mesh.pictured().empty()) {
            const TracedMesh::PicturedVertex &pa = mesh.pictured()[index.x], &pb = mesh.pictured()[index.y], &pc = mesh.pictured()[index.z];
            coordinates.second = weights.x * pa.uv + weights.y * pb.uv + weights.z * pc.uv;
            data_->tilt(point, data_->materials.pictures[material.texture.y - 1], coordinates, weights.x * pa.tangent + weights.y * pb.tangent + weights.z * pc.tangent);
        }
        material = data_->pictured(material, coordinates);
    }
    const vec3 texel = material.texture.x == no_texture ? vec3(1.0f) : data_->textures.at(material.texture.x, uv);
    vec3 colour = surface_colour(material, texel, weights.x * va.colour + weights.y * vb.colour + weights.z * vc.colour);
    if (material.specular.y > 0.0f) {
        material.base_colour = vec4(colour, 1.0f);
        material = unlit_material(material);
        point.unlit = vec3(std::exchange(material.emission, vec4(0.0f)));
        colour = vec3(0.0f);
    }
    point.surface.base_colour = vec4(colour, material.base_colour.w);
    point.surface.normal.w = material.emission.w;
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
    return data_->meshes[draw] && std::ranges::any_of(data_->meshes[draw]->materials(), [&](std::uint32_t row) { return vec3(data_->materials.materials[row].emission) != vec3(0.0f); });
}

vec3 TraceScene::plain_emission(std::uint32_t draw, std::uint32_t triangle) const {
    const TracedMesh& mesh = *data_->meshes[draw];
    return vec3(data_->materials.materials[mesh.vertices()[mesh.triangles()[triangle].x].material].emission);
}

std::uint32_t TraceScene::draw_count() const { return static_cast<std::uint32_t>(data_->meshes.size()); }
std::uint32_t TraceScene::triangle_count(std::uint32_t draw) const { 
    return data_->meshes[draw] ? static_cast<std::uint32_t>(data_->meshes[draw]->triangles().size()) : 0;
}

std::uint64_t TraceScene::content_hash() const {
    const auto bytes = [](std::uint64_t hash, const auto& values) { return hash_bytes(hash, values.data(), values.size() * sizeof(values[0])); };
    std::uint64_t hash = bytes(bytes(bytes(1, data_->materials.materials), data_->materials.pictures), data_->textures.texels);
    hash = data_->picture_data.hash(data_->picture_colours.hash(hash));
    for (const auto& mesh : data_->meshes) {
        if (mesh) hash = bytes(bytes(bytes(bytes(hash, mesh->positions()), mesh->vertices()), mesh->pictured()), mesh->triangles());
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
