// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_mesh.h"

#include <cmath>
#include <glm/gtc/packing.hpp>
#include <numeric>

#include "engine/core/error.h"
#include "engine/core/gltf/gltf_value.h"
#include "engine/core/model/tangents.h"

namespace sl {

using nlohmann::json;

namespace {

/// As the format numbers them; what is below is points and lines.
enum class Mode : std::size_t { triangles = 4, triangle_strip, triangle_fan };

/// Values of a vertex attribute; none where the primitive has none, or where they lie in a file that is not read.
AccessorValues attribute(const json& attributes, std::string_view name, GltfReader& reader) {
    const auto accessor = gltf_find_whole(attributes, name);
    return accessor ? reader.values(*accessor).value_or(AccessorValues{}) : AccessorValues{};
}

vec3 vector_at(const AccessorValues& values, std::size_t vertex) {
    const float* at = &values.numbers[vertex * values.width];
    return {at[0], at[1], at[2]};
}

vec3 finite(vec3 v) {
    for (int axis = 0; axis < 3; ++axis) v[axis] = std::isfinite(v[axis]) ? v[axis] : 0.0f;
    return v;
}

/// Corners of triangles, three each, of lists, strips and fans.
std::vector<std::uint32_t> triangles_of(const std::vector<std::uint32_t>& indices, Mode mode) {
    if (mode == Mode::triangles) return {indices.begin(), indices.end() - static_cast<std::ptrdiff_t>(indices.size() % 3)};
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        const bool fan = mode == Mode::triangle_fan;
        // Every other triangle of a strip is wound the other way.
        const std::size_t odd = i % 2;
        const std::uint32_t a = fan ? indices[i + 1] : indices[i], b = fan ? indices[i + 2] : indices[i + 1 + odd],
                            c = fan ? indices[0] : indices[i + 2 - odd];
        corners.insert(corners.end(), {a, b, c});
    }
    return corners;
}

/// Gives each triangle vertices of its own, for what differs from one to the next.
void part_triangles(ModelPrimitive& result) {
    result.visit_vertex_arrays([&](auto& values) {
        if (values.empty()) return;
        std::decay_t<decltype(values)> apart;
        apart.reserve(result.mesh.indices.size());
        for (const std::uint32_t index : result.mesh.indices) apart.push_back(values[index]);
        values = std::move(apart);
    });
    for (std::size_t i = 0; i < result.mesh.indices.size(); ++i) result.mesh.indices[i] = static_cast<std::uint32_t>(i);
}

void make_flat_normals(ModelPrimitive& result) {
    part_triangles(result);
    std::vector<Vertex>& vertices = result.mesh.vertices;
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
        const vec3 normal =
            glm::cross(vertices[i + 1].position - vertices[i].position, vertices[i + 2].position - vertices[i].position);
        const float length = glm::length(normal);
        for (std::size_t k = i; k < i + 3; ++k) vertices[k].normal = pack_normal(length > 0.0f ? normal / length : vec3(0, 1, 0));
    }
}

/// Appends all triangles once more, turned.
void show_backs(ModelPrimitive& result) {
    MeshData& mesh = result.mesh;
    mesh.both_sides = true;
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    result.visit_vertex_arrays([](auto& values) {
        const std::size_t once = values.size();
        values.reserve(2 * once);
        for (std::size_t i = 0; i < once; ++i) values.push_back(values[i]);
    });
    const auto turn = [&](auto& values, const auto& turned) {
        for (std::size_t i = values.size() / 2; i < values.size(); ++i) turned(values[i]);
    };
    const auto turn_vector = [](vec3& vector) { vector = -vector; };
    turn(mesh.vertices, [](Vertex& vertex) { vertex.normal = pack_normal(-unpack_normal(vertex.normal)); });
    // What leans to a side on the front leans to the opposite one on the back, as the normal does.
    turn(mesh.pictured, [](PicturedVertex& vertex) {
        vertex.tangent = pack_normal(-unpack_normal(vertex.tangent));
        vertex.hand = -vertex.hand;
    });
    for (ModelMorph& morph : result.morphs) {
        turn(morph.normals, turn_vector);
        turn(morph.tangents, turn_vector);
    }
    const std::size_t corners = mesh.indices.size();
    for (std::size_t i = 0; i + 2 < corners; i += 3) {
        for (const std::size_t k : {i, i + 2, i + 1}) mesh.indices.push_back(mesh.indices[k] + count);
    }
}

std::vector<ModelMorph> morphs_of(const json& primitive, GltfReader& reader) {
    std::vector<ModelMorph> morphs;
    for (const json& target : gltf_list(primitive, "targets")) {
        ModelMorph& morph = morphs.emplace_back();
        for (const auto& [name, moved] :
             {std::pair{"POSITION", &morph.positions}, {"NORMAL", &morph.normals}, {"TANGENT", &morph.tangents}}) {
            const AccessorValues values = attribute(target, name, reader);
            for (std::size_t vertex = 0; vertex < values.count; ++vertex) moved->push_back(finite(vector_at(values, vertex)));
        }
    }
    return morphs;
}

std::vector<ModelJoints> joints_of(const json& attributes, GltfReader& reader) {
    const AccessorValues joints = attribute(attributes, "JOINTS_0", reader), weights = attribute(attributes, "WEIGHTS_0", reader);
    if (joints.numbers.empty() || weights.numbers.empty()) return {};
    const std::size_t count = joints.count;
    std::vector<ModelJoints> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        float sum = 0.0f;
        for (int k = 0; k < 4; ++k) {
            const std::size_t at = 4 * i + static_cast<std::size_t>(k);
            result[i].joints[static_cast<std::size_t>(k)] =
                static_cast<std::uint16_t>(glm::clamp(joints.numbers[at], 0.0f, 65535.0f));
            result[i].weights[k] = std::isfinite(weights.numbers[at]) ? std::max(weights.numbers[at], 0.0f) : 0.0f;
            sum += result[i].weights[k];
        }
        result[i].weights = sum > 0.0f ? result[i].weights / sum : vec4(1, 0, 0, 0);
    }
    return result;
}

vec2 coordinates_at(const AccessorValues& values, std::size_t vertex) {
    if (values.numbers.empty()) return vec2(0.0f);
    const vec2 uv(values.numbers[2 * vertex], values.numbers[2 * vertex + 1]);
    return std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : vec2(0.0f);
}

AccessorValues coordinates_of(const json& attributes, std::size_t set, GltfReader& reader) {
    return attribute(attributes, fmt::format("TEXCOORD_{}", set), reader);
}

/// Tangents without normals count for nothing, as the format has it.
std::vector<PicturedVertex> pictured_vertices(const json& attributes, const ModelMaterial& material, std::size_t count,
                                              GltfReader& reader) {
    std::vector<PicturedVertex> vertices(count);
    const AccessorValues second = coordinates_of(attributes, material.uv_sets[1], reader);
    const AccessorValues tangents = attributes.contains("NORMAL") ? attribute(attributes, "TANGENT", reader) : AccessorValues{};
    for (std::size_t i = 0; i < count; ++i) {
        vertices[i].uv = coordinates_at(second, i);
        if (tangents.numbers.empty()) continue;
        const vec3 tangent = finite(vector_at(tangents, i));
        const float length = glm::length(tangent);
        vertices[i].tangent = pack_normal(length > 0.0f ? tangent / length : vec3(1, 0, 0));
        vertices[i].hand = tangents.numbers[4 * i + 3] < 0.0f ? -1.0f : 1.0f;
    }
    return vertices;
}

}  // namespace

std::optional<ModelPrimitive> gltf_primitive(const json& primitive, const std::vector<ModelMaterial>& materials,
                                             const std::string& where, GltfReader& reader) {
    const auto mode = static_cast<Mode>(gltf_whole_at(primitive, "mode", static_cast<std::size_t>(Mode::triangles)));
    if (mode != Mode::triangles && mode != Mode::triangle_strip && mode != Mode::triangle_fan) {
        reader.warn(where, "points and lines are not drawn");
        return std::nullopt;
    }
    const json& attributes = gltf_part(primitive, "attributes");
    const AccessorValues positions = attribute(attributes, "POSITION", reader);
    const auto index_accessor = gltf_find_whole(primitive, "indices");
    auto indices = index_accessor ? reader.indices(*index_accessor) : std::vector<std::uint32_t>();
    if (positions.numbers.empty() || !indices) {
        reader.warn(where, "it has no positions that are read, and is not drawn");
        return std::nullopt;
    }
    const std::size_t count = positions.count;
    if (!index_accessor) {
        indices->resize(count);
        std::iota(indices->begin(), indices->end(), 0u);
    }
    const auto material = gltf_find_whole(primitive, "material");
    const ModelMaterial surface = material ? materials[*material] : ModelMaterial{};
    const AccessorValues normals = attribute(attributes, "NORMAL", reader), colours = attribute(attributes, "COLOR_0", reader);
    const AccessorValues coordinates = coordinates_of(attributes, surface.uv_sets[0], reader);
    const bool makes_tangents = surface.normal_texture && (normals.numbers.empty() || !attributes.contains("TANGENT"));

    ModelPrimitive result;
    if (material) result.material = static_cast<std::int32_t>(*material);
    MeshData& mesh = result.mesh;
    mesh.vertices.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Vertex& vertex = mesh.vertices[i];
        vertex.position = vector_at(positions, i);
        for (int axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(vertex.position[axis]) || std::abs(vertex.position[axis]) > 1e12f)
                fail("{}/attributes/POSITION: vertex {} lies at {}", where, i, vertex.position[axis]);
        }
        if (!normals.numbers.empty()) {
            const vec3 normal = vector_at(normals, i);
            const float length = glm::length(normal);
            vertex.normal = pack_normal(std::isfinite(length) && length > 0.0f ? normal / length : vec3(0, 1, 0));
        }
        vertex.uv = coordinates_at(coordinates, i);
        if (!colours.numbers.empty()) {
            vec4 colour(vector_at(colours, i), colours.width == 4 ? colours.numbers[4 * i + 3] : 1.0f);
            for (int k = 0; k < 4; ++k) colour[k] = std::isfinite(colour[k]) ? colour[k] : 1.0f;
            vertex.colour = glm::packUnorm4x8(glm::clamp(colour, 0.0f, 1.0f));
        }
        mesh.bounds.add(vertex.position);
    }
    if (surface.needs_pictured_vertices()) mesh.pictured = pictured_vertices(attributes, surface, count, reader);
    mesh.indices = triangles_of(*indices, mode);
    result.morphs = morphs_of(primitive, reader);
    result.joints = joints_of(attributes, reader);
    if (normals.numbers.empty()) make_flat_normals(result);
    if (makes_tangents) make_tangents(result, surface.normal_texture);
    if (surface.two_sided) show_backs(result);
    return result;
}

}  // namespace sl
