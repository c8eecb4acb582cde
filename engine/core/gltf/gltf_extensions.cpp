// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace sl {

namespace {

/// The addresses alone are taken before main: the order in which tables are made does not matter.
GltfProperty texture(std::string_view name) {
    return gltf_object(name, gltf_texture_info());
}
constexpr GltfProperty factor(std::string_view name) {
    return gltf_number(name).within(0, 1);
}
constexpr GltfProperty colour(std::string_view name) {
    return factor(name).array_of(3);
}

/// Each part begins with '/'; '~' is followed by 0 or 1.
bool is_json_pointer(std::string_view text) {
    if (!text.empty() && text.front() != '/') return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '~' && (i + 1 == text.size() || (text[i + 1] != '0' && text[i + 1] != '1'))) return false;
    }
    return true;
}

const GltfObject animation_pointer{"animation pointer",
                                   {gltf_text("pointer")
                                        .needed()
                                        .with(&GltfProperty::is_well_formed, &is_json_pointer)
                                        .with(&GltfProperty::form, "a JSON pointer such as \"/nodes/0/scale\"")},
                                   {}};

constexpr double right_angle = std::numbers::pi / 2;
const GltfObject spot{"spot",
                      {gltf_number("innerConeAngle").within(0, right_angle),
                       gltf_number("outerConeAngle").within(0, right_angle).with(&GltfProperty::is_above_least, true)},
                      {}};
const GltfObject light{"light",
                       {gltf_text("name"), gltf_text("type").needed(), colour("color"),
                        gltf_number("intensity").at_least(0), gltf_number("range").above(0),
                        gltf_object("spot", spot).needed_for("spot")},
                       {}};
const GltfObject lights{"lights", {gltf_object("lights", light).array().needed()}, {}};
const GltfObject node_light{
    "light of a node", {gltf_index("light", "extensions/KHR_lights_punctual/lights").needed()}, {}};

const GltfObject anisotropy{
    "anisotropy", {factor("anisotropyStrength"), gltf_number("anisotropyRotation"), texture("anisotropyTexture")}, {}};
const GltfObject clearcoat{"clearcoat",
                           {factor("clearcoatFactor"), texture("clearcoatTexture"), factor("clearcoatRoughnessFactor"),
                            texture("clearcoatRoughnessTexture"),
                            gltf_object("clearcoatNormalTexture", gltf_normal_texture_info())},
                           {}};
const GltfObject dispersion{"dispersion", {gltf_number("dispersion").at_least(0)}, {}};
const GltfObject emissive_strength{"emissive strength", {gltf_number("emissiveStrength").at_least(0)}, {}};
const GltfObject refraction{"index of refraction", {gltf_number("ior").at_least(1).or_zero()}, {}};
const GltfObject iridescence{
    "iridescence",
    {factor("iridescenceFactor"), texture("iridescenceTexture"), gltf_number("iridescenceIor").at_least(1),
     gltf_number("iridescenceThicknessMinimum").at_least(0), gltf_number("iridescenceThicknessMaximum").at_least(0),
     texture("iridescenceThicknessTexture")},
    {}};
const GltfObject specular_glossiness{
    "specular glossiness",
    {factor("diffuseFactor").array_of(4), texture("diffuseTexture"), colour("specularFactor"),
     factor("glossinessFactor"), texture("specularGlossinessTexture")},
    {}};
const GltfObject sheen{"sheen",
                       {colour("sheenColorFactor"), texture("sheenColorTexture"), factor("sheenRoughnessFactor"),
                        texture("sheenRoughnessTexture")},
                       {}};
const GltfObject specular{"specular",
                          {factor("specularFactor"), texture("specularTexture"),
                           gltf_number("specularColorFactor").at_least(0).array_of(3), texture("specularColorTexture")},
                          {}};
const GltfObject transmission{"transmission", {factor("transmissionFactor"), texture("transmissionTexture")}, {}};
const GltfObject unlit{"unlit", {}, {}};
const GltfObject volume{"volume",
                        {gltf_number("thicknessFactor").at_least(0), texture("thicknessTexture"),
                         gltf_number("attenuationDistance").above(0), colour("attenuationColor")},
                        {}};

const GltfObject variant{"variant", {gltf_text("name").needed()}, {}};
const GltfObject variants{"variants", {gltf_object("variants", variant).array().needed()}, {}};
const GltfObject variant_mapping{
    "variant mapping",
    {gltf_text("name"), gltf_index("material", "materials").needed(),
     gltf_index("variants", "extensions/KHR_materials_variants/variants").array().distinct().needed()},
    {}};
const GltfObject variant_mappings{"variant mappings", {gltf_object("mappings", variant_mapping).array().needed()}, {}};

const GltfObject visibility{"visibility", {gltf_flag("visible")}, {}};
const GltfObject texture_transform{"texture transform",
                                   {gltf_number("offset").array_of(2), gltf_number("rotation"),
                                    gltf_number("scale").array_of(2), gltf_whole("texCoord")},
                                   {}};
const GltfObject other_source{"texture source", {gltf_index("source", "images")}, {}};

const std::array extensions{
    GltfExtension{"EXT_texture_webp", "texture", &other_source},
    GltfExtension{"KHR_animation_pointer", "animation target", &animation_pointer},
    GltfExtension{"KHR_lights_punctual", "document", &lights},
    GltfExtension{"KHR_lights_punctual", "node", &node_light},
    GltfExtension{"KHR_materials_anisotropy", "material", &anisotropy},
    GltfExtension{"KHR_materials_clearcoat", "material", &clearcoat},
    GltfExtension{"KHR_materials_dispersion", "material", &dispersion},
    GltfExtension{"KHR_materials_emissive_strength", "material", &emissive_strength},
    GltfExtension{"KHR_materials_ior", "material", &refraction},
    GltfExtension{"KHR_materials_iridescence", "material", &iridescence},
    GltfExtension{"KHR_materials_pbrSpecularGlossiness", "material", &specular_glossiness},
    GltfExtension{"KHR_materials_sheen", "material", &sheen},
    GltfExtension{"KHR_materials_specular", "material", &specular},
    GltfExtension{"KHR_materials_transmission", "material", &transmission},
    GltfExtension{"KHR_materials_unlit", "material", &unlit},
    GltfExtension{"KHR_materials_variants", "document", &variants},
    GltfExtension{"KHR_materials_variants", "primitive", &variant_mappings},
    GltfExtension{"KHR_materials_volume", "material", &volume},
    GltfExtension{"KHR_mesh_quantization", ""},
    GltfExtension{"KHR_node_visibility", "node", &visibility},
    GltfExtension{"KHR_texture_transform", "texture info", &texture_transform},
    GltfExtension{"KHR_texture_transform", "normal texture info", &texture_transform},
    GltfExtension{"KHR_texture_transform", "occlusion texture info", &texture_transform},
};

}  // namespace

std::span<const GltfExtension> gltf_extensions() {
    return extensions;
}

bool is_known_gltf_extension(std::string_view name) {
    return std::any_of(extensions.begin(), extensions.end(), [&](const auto& known) { return known.name == name; });
}

}  // namespace sl
