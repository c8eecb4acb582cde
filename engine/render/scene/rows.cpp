// SPDX-License-Identifier: MIT
#include "engine/render/scene/rows.h"

namespace sl {

namespace {

/// `white`: nit that a camera exposes as 1.
MaterialParams material_params(const MaterialEntry& entry, std::uint32_t picture_row, float white) {
    const Material& m = entry.material;
    return {.base_colour = vec4(m.base_colour, m.roughness),
            .emission = vec4(entry.unlit ? vec3(0.0f) : m.emission_colour * m.emission, m.metallic),
            .specular = vec4(m.specular, entry.unlit ? white : 0.0f, 0, 0),
            .texture = uvec4(entry.texture_layer >= 0 ? static_cast<std::uint32_t>(entry.texture_layer) : no_texture, picture_row, 0, 0)};
}

}  // namespace

MaterialRows material_rows(const RenderScene& scene) {
    MaterialRows rows;
    rows.materials.reserve(scene.materials.size());
    const float white = scene.view ? scene.view->white() : 1.0f;
    for (const MaterialEntry& entry : scene.materials) {
        if (entry.pictures) rows.pictures.push_back(*entry.pictures);
        rows.materials.push_back(material_params(entry, entry.pictures ? static_cast<std::uint32_t>(rows.pictures.size()) : 0, white));
    }
    return rows;
}

mat4 normal_matrix(const mat4& matrix) {
    mat4 result(0.0f);
    result[0] = vec4(glm::cross(vec3(matrix[1]), vec3(matrix[2])), 0.0f);
    result[1] = vec4(glm::cross(vec3(matrix[2]), vec3(matrix[0])), 0.0f);
    result[2] = vec4(glm::cross(vec3(matrix[0]), vec3(matrix[1])), 0.0f);
    // A mirrored mesh turns its winding and its cofactors alike; the sign keeps the normal outward.
    const float sign = glm::dot(vec3(matrix[0]), vec3(result[0])) < 0.0f ? -1.0f : 1.0f;
    return sign * result;
}

}  // namespace sl
