// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_mesh.h"

#include <tiny_gltf.h>

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "engine/core/error.h"
#include "engine/core/model/gltf_accessor.h"

namespace sl {

namespace {

/// Values of a vertex attribute; empty where the primitive has none.
AccessorValues attribute(const tinygltf::Model& file, const std::map<std::string, int>& attributes, const char* name, const std::string& where) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? AccessorValues{} : accessor_values(file, found->second, fmt::format("{}/attributes/{}", where, name));
}

/// Throws unless an attribute is there for each vertex, with so many numbers; absent is fine.
void check_shape(const AccessorValues& values, std::size_t count, std::size_t least, std::size_t most, const char* name, const std::string& where) {
    if (values.numbers.empty()) return;
    if (values.count != count) fail("{}/attributes/{}: {} values for {} vertices", where, name, values.count, count);
    if (values.width < least || values.width > most) fail("{}/attributes/{}: {} numbers a vertex", where, name, values.width);
}

vec3 vector_at(const AccessorValues& values, std::size_t vertex) {
    const float* at = &values.numbers[vertex * values.width];
    return {at[0], at[1], at[2]};
}

/// Corners of triangles, three each, of lists, strips and fans.
std::vector<std::uint32_t> triangles_of(const std::vector<std::uint32_t>& indices, int mode) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return {indices.begin(), indices.end() - static_cast<std::ptrdiff_t>(indices.size() % 3)};
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
        // Every other triangle of a strip is wound the other way.
        const std::size_t odd = i % 2;
        const std::uint32_t a = fan ? indices[i + 1] : indices[i], b = fan ? indices[i + 2] : indices[i + 1 + odd], c = fan ? indices[0] : indices[i + 2 - odd];
        corners.insert(corners.end(), {a, b, c});
    }
    return corners;
}

/// Gives each triangle vertices of its own, for what differs from one to the next.
void part_triangles(ModelPrimitive& result) {
    const auto parted = [&](auto& values) {
        if (values.empty()) return;
        std::decay_t<decltype(values)> apart;
        apart.reserve(result.mesh.indices.size());
        for (const std::uint32_t index : result.mesh.indices) apart.push_back(values[index]);
        values = std::move(apart);
    };
    for (ModelMorph& morph : result.morphs) {
        parted(morph.positions);
        parted(morph.normals);
    }
    parted(result.joints);
    parted(result.mesh.vertices);
    for (std::size_t i = 0; i < result.mesh.indices.size(); ++i) result.mesh.indices[i] = static_cast<std::uint32_t>(i);
}

void make_flat_normals(ModelPrimitive& result) {
    part_triangles(result);
    std::vector<Vertex>& vertices = result.mesh.vertices;
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
        const vec3 normal = glm::cross(vertices[i + 1].position - vertices[i].position, vertices[i + 2].position - vertices[i].position);
        const float length = glm::length(normal);
        for (std::size_t k = i; k < i + 3; ++k) vertices[k].normal = pack_normal(length > 0.0f ? normal / length : vec3(0, 1, 0));
    }
}

/// Appends all triangles once more, turned.
void show_backs(ModelPrimitive& result) {
    MeshData& mesh = result.mesh;
    mesh.both_sides = true;
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        Vertex vertex = mesh.vertices[i];
        vertex.normal = pack_normal(-unpack_normal(vertex.normal));
        mesh.vertices.push_back(vertex);
    }
    const std::size_t corners = mesh.indices.size();
    for (std::size_t i = 0; i + 2 < corners; i += 3) {
        for (const std::size_t k : {i, i + 2, i + 1}) mesh.indices.push_back(mesh.indices[k] + count);
    }
    const auto twice = [](auto& values, float sign) {
        const std::size_t once = values.size();
        for (std::size_t i = 0; i < once; ++i) values.push_back(sign * values[i]);
    };
    for (ModelMorph& morph : result.morphs) {
        twice(morph.positions, 1.0f);
        twice(morph.normals, -1.0f);
    }
    const std::vector<ModelJoints> joints = result.joints;
    result.joints.insert(result.joints.end(), joints.begin(), joints.end());
}

std::vector<ModelMorph> morphs_of(const tinygltf::Model& file, const tinygltf::Primitive& primitive, std::size_t count, const std::string& where) {
    std::vector<ModelMorph> morphs;
    for (std::size_t i = 0; i < primitive.targets.size(); ++i) {
        const std::string place = fmt::format("{}/targets/{}", where, i);
        ModelMorph& morph = morphs.emplace_back();
        for (const auto& [name, moved] : {std::pair{"POSITION", &morph.positions}, std::pair{"NORMAL", &morph.normals}}) {
            const AccessorValues values = attribute(file, primitive.targets[i], name, place);
            check_shape(values, count, 3, 3, name, place);
            for (std::size_t vertex = 0; vertex < values.count; ++vertex) moved->push_back(vector_at(values, vertex));
        }
    }
    return morphs;
}

std::vector<ModelJoints> joints_of(const tinygltf::Model& file, const tinygltf::Primitive& primitive, std::size_t count, const std::string& where) {
    const AccessorValues joints = attribute(file, primitive.attributes, "JOINTS_0", where), weights = attribute(file, primitive.attributes, "WEIGHTS_0", where);
    if (joints.numbers.empty() || weights.numbers.empty()) return {};
    check_shape(joints, count, 4, 4, "JOINTS_0", where);
    check_shape(weights, count, 4, 4, "WEIGHTS_0", where);
    std::vector<ModelJoints> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        float sum = 0.0f;
        for (int k = 0; k < 4; ++k) {
            const std::size_t at = 4 * i + static_cast<std::size_t>(k);
            result[i].joints[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(glm::clamp(joints.numbers[at], 0.0f, 65535.0f));
            result[i].weights[k] = std::isfinite(weights.numbers[at]) ? std::max(weights.numbers[at], 0.0f) : 0.0f;
            sum += result[i].weights[k];
        }
        result[i].weights = sum > 0.0f ? result[i].weights / sum : vec4(1, 0, 0, 0);
    }
    return result;
}

}  // namespace

std::optional<ModelPrimitive> gltf_primitive(const tinygltf::Model& file, const tinygltf::Primitive& primitive, const Model& model, const std::string& where,
                                             std::vector<std::string>& warnings) {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN) {
        warnings.push_back(fmt::format("{}: points and lines are not drawn", where));
        return std::nullopt;
    }
    const AccessorValues positions = attribute(file, primitive.attributes, "POSITION", where);
    if (positions.numbers.empty()) {
        warnings.push_back(fmt::format("{}: it has no positions and is not drawn", where));
        return std::nullopt;
    }
    const std::size_t count = positions.count;
    check_shape(positions, count, 3, 3, "POSITION", where);
    const AccessorValues normals = attribute(file, primitive.attributes, "NORMAL", where), colours = attribute(file, primitive.attributes, "COLOR_0", where);
    const AccessorValues coordinates = attribute(file, primitive.attributes, "TEXCOORD_0", where);
    check_shape(normals, count, 3, 3, "NORMAL", where);
    check_shape(colours, count, 3, 4, "COLOR_0", where);
    check_shape(coordinates, count, 2, 2, "TEXCOORD_0", where);

    ModelPrimitive result;
    if (primitive.material >= 0 && static_cast<std::size_t>(primitive.material) < model.materials.size()) result.material = primitive.material;
    MeshData& mesh = result.mesh;
    mesh.vertices.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Vertex& vertex = mesh.vertices[i];
        vertex.position = vector_at(positions, i);
        for (int axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(vertex.position[axis]) || std::abs(vertex.position[axis]) > 1e12f) fail("{}/attributes/POSITION: vertex {} lies at {}", where, i, vertex.position[axis]);
        }
        if (!normals.numbers.empty()) {
            const vec3 normal = vector_at(normals, i);
            const float length = glm::length(normal);
            vertex.normal = pack_normal(std::isfinite(length) && length > 0.0f ? normal / length : vec3(0, 1, 0));
        }
        if (!coordinates.numbers.empty()) {
            vertex.uv = vec2(coordinates.numbers[2 * i], coordinates.numbers[2 * i + 1]);
            if (!std::isfinite(vertex.uv.x) || !std::isfinite(vertex.uv.y)) vertex.uv = vec2(0.0f);
        }
        if (!colours.numbers.empty()) {
            vec4 colour(vector_at(colours, i), colours.width == 4 ? colours.numbers[4 * i + 3] : 1.0f);
            for (int k = 0; k < 4; ++k) colour[k] = std::isfinite(colour[k]) ? colour[k] : 1.0f;
            vertex.colour = glm::packUnorm4x8(glm::clamp(colour, 0.0f, 1.0f));
        }
        mesh.bounds.add(vertex.position);
    }
    std::vector<std::uint32_t> indices;
    if (primitive.indices >= 0) {
        indices = accessor_indices(file, primitive.indices, where + "/indices");
    } else {
        indices.resize(count);
        for (std::size_t i = 0; i < count; ++i) indices[i] = static_cast<std::uint32_t>(i);
    }
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] >= count) fail("{}/indices: index {} is vertex {} of {}", where, i, indices[i], count);
    }
    mesh.indices = triangles_of(indices, mode);
    result.morphs = morphs_of(file, primitive, count, where);
    result.joints = joints_of(file, primitive, count, where);
    if (normals.numbers.empty()) make_flat_normals(result);
    if (result.material >= 0 && model.materials[static_cast<std::size_t>(result.material)].two_sided) show_backs(result);
    return result;
}

}  // namespace sl
