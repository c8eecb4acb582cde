// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_schema.h"

#include <algorithm>
#include <array>

namespace sl {

namespace {

/// "2.0".
bool is_version(std::string_view text) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto dot = std::find_if_not(text.begin(), text.end(), is_digit);
    return dot != text.begin() && dot != text.end() && *dot == '.' && dot + 1 != text.end() &&
           std::all_of(dot + 1, text.end(), is_digit);
}

constexpr GltfProperty version(std::string_view name) {
    return gltf_text(name)
        .with(&GltfProperty::is_well_formed, &is_version)
        .with(&GltfProperty::form, "a version such as \"2.0\"");
}

constexpr std::array component_types{5120, 5121, 5122, 5123, 5125, 5126};
constexpr std::array index_component_types{5121, 5123, 5125};
constexpr std::array view_targets{34962, 34963};
constexpr std::array magnifying_filters{9728, 9729};
constexpr std::array minifying_filters{9728, 9729, 9984, 9985, 9986, 9987};
constexpr std::array wraps{33071, 33648, 10497};
constexpr std::array primitive_modes{0, 1, 2, 3, 4, 5, 6};
constexpr std::array<std::string_view, 3> interpolations{"LINEAR", "STEP", "CUBICSPLINE"};
constexpr std::array<std::string_view, 3> alpha_modes{"OPAQUE", "MASK", "BLEND"};
constexpr double least_stride = 4, most_stride = 252;
constexpr std::size_t most_components = 16;

const GltfProperty name = gltf_text("name");

const GltfObject asset{
    "asset",
    {version("version").needed(), version("minVersion"), gltf_text("generator"), gltf_text("copyright")},
    {}};

const GltfObject sparse_indices{"sparse indices",
                                {gltf_index("bufferView", "bufferViews").needed(), gltf_whole("byteOffset"),
                                 gltf_whole("componentType").needed().among(index_component_types)},
                                {}};
const GltfObject sparse_values{
    "sparse values", {gltf_index("bufferView", "bufferViews").needed(), gltf_whole("byteOffset")}, {}};
const GltfObject sparse{"sparse",
                        {gltf_whole("count").at_least(1).needed(), gltf_object("indices", sparse_indices).needed(),
                         gltf_object("values", sparse_values).needed()},
                        {}};
const GltfObject accessor{
    "accessor",
    {name, gltf_index("bufferView", "bufferViews"), gltf_whole("byteOffset").beside("bufferView"),
     gltf_whole("componentType").needed().among(component_types), gltf_flag("normalized"),
     gltf_whole("count").at_least(1).needed(), gltf_text("type").needed(),
     gltf_number("min").array().with(&GltfProperty::most_length, most_components),
     gltf_number("max").array().with(&GltfProperty::most_length, most_components), gltf_object("sparse", sparse)},
    {}};
const GltfObject buffer{"buffer", {name, gltf_text("uri"), gltf_whole("byteLength").at_least(1).needed()}, {}};
const GltfObject view{"buffer view",
                      {name, gltf_index("buffer", "buffers").needed(), gltf_whole("byteOffset"),
                       gltf_whole("byteLength").at_least(1).needed(),
                       gltf_whole("byteStride").within(least_stride, most_stride).in_steps_of(4),
                       gltf_whole("target").among(view_targets)},
                      {}};

const GltfObject animation_target{"animation target", {gltf_index("node", "nodes"), gltf_text("path").needed()}, {}};
const GltfObject animation_channel{
    "animation channel",
    {gltf_index("sampler", "samplers").with(&GltfProperty::is_target_local, true).needed(),
     gltf_object("target", animation_target).needed()},
    {}};
const GltfObject animation_sampler{"animation sampler",
                                   {gltf_index("input", "accessors").needed(), gltf_index("output", "accessors").needed(),
                                    gltf_text("interpolation").among(interpolations)},
                                   {}};
const GltfObject animation{"animation",
                           {name, gltf_object("channels", animation_channel).array().needed(),
                            gltf_object("samplers", animation_sampler).array().needed()},
                           {}};

const GltfObject orthographic{"orthographic camera",
                              {gltf_number("xmag").needed(), gltf_number("ymag").needed(),
                               gltf_number("zfar").above(0).needed(), gltf_number("znear").at_least(0).needed()},
                              {}};
const GltfObject perspective{"perspective camera",
                             {gltf_number("aspectRatio").above(0), gltf_number("yfov").above(0).needed(),
                              gltf_number("zfar").above(0), gltf_number("znear").above(0).needed()},
                             {}};
const GltfObject camera{
    "camera",
    {name, gltf_text("type").needed(), gltf_object("perspective", perspective).needed_for("perspective"),
     gltf_object("orthographic", orthographic).needed_for("orthographic")},
    {"perspective", "orthographic"}};

const GltfObject image{"image",
                       {name, gltf_text("uri"), gltf_text("mimeType"),
                        gltf_index("bufferView", "bufferViews").beside("mimeType")},
                       {"uri", "bufferView"}};
const GltfObject sampler{"sampler",
                         {name, gltf_whole("magFilter").among(magnifying_filters),
                          gltf_whole("minFilter").among(minifying_filters), gltf_whole("wrapS").among(wraps),
                          gltf_whole("wrapT").among(wraps)},
                         {}};
const GltfObject texture{"texture", {name, gltf_index("sampler", "samplers"), gltf_index("source", "images")}, {}};

const GltfProperty texture_index = gltf_index("index", "textures").needed();
const GltfObject texture_info{"texture info", {texture_index, gltf_whole("texCoord")}, {}};
const GltfObject normal_texture_info{
    "normal texture info", {texture_index, gltf_whole("texCoord"), gltf_number("scale")}, {}};
const GltfObject occlusion_texture_info{
    "occlusion texture info",
    {texture_index, gltf_whole("texCoord"), gltf_number("strength").within(0, 1)},
    {}};
const GltfObject metallic_roughness{
    "metallic roughness",
    {gltf_number("baseColorFactor").within(0, 1).array_of(4), gltf_object("baseColorTexture", texture_info),
     gltf_number("metallicFactor").within(0, 1), gltf_number("roughnessFactor").within(0, 1),
     gltf_object("metallicRoughnessTexture", texture_info)},
    {}};
const GltfObject material{
    "material",
    {name, gltf_object("pbrMetallicRoughness", metallic_roughness), gltf_object("normalTexture", normal_texture_info),
     gltf_object("occlusionTexture", occlusion_texture_info), gltf_object("emissiveTexture", texture_info),
     gltf_number("emissiveFactor").within(0, 1).array_of(3), gltf_text("alphaMode").among(alpha_modes),
     gltf_number("alphaCutoff").at_least(0), gltf_flag("doubleSided")},
    {}};

const GltfProperty attributes = gltf_index("attributes", "accessors").with(&GltfProperty::is_map, true);
const GltfObject primitive{
    "primitive",
    {attributes.needed(), gltf_index("indices", "accessors"), gltf_index("material", "materials"),
     gltf_whole("mode").among(primitive_modes), attributes.with(&GltfProperty::name, "targets").array()},
    {}};
const GltfObject mesh{
    "mesh", {name, gltf_object("primitives", primitive).array().needed(), gltf_number("weights").array()}, {}};

const GltfObject node{
    "node",
    {name, gltf_index("camera", "cameras"), gltf_index("children", "nodes").array(),
     gltf_index("skin", "skins").beside("mesh"), gltf_number("matrix").array_of(16), gltf_index("mesh", "meshes"),
     gltf_number("rotation").within(-1, 1).array_of(4), gltf_number("scale").array_of(3),
     gltf_number("translation").array_of(3), gltf_number("weights").array().beside("mesh")},
    {}};
const GltfObject scene{"scene", {name, gltf_index("nodes", "nodes").array().distinct()}, {}};
const GltfObject skin{"skin",
                      {name, gltf_index("inverseBindMatrices", "accessors"), gltf_index("skeleton", "nodes"),
                       gltf_index("joints", "nodes").array().distinct().needed()},
                      {}};

const GltfObject document{
    "document",
    {gltf_object("asset", asset).needed(), gltf_text("extensionsUsed").array().distinct(),
     gltf_text("extensionsRequired").array().distinct().beside("extensionsUsed"),
     gltf_object("accessors", accessor).array(), gltf_object("animations", animation).array(),
     gltf_object("buffers", buffer).array(), gltf_object("bufferViews", view).array(),
     gltf_object("cameras", camera).array(), gltf_object("images", image).array(),
     gltf_object("materials", material).array(), gltf_object("meshes", mesh).array(),
     gltf_object("nodes", node).array(), gltf_object("samplers", sampler).array(), gltf_index("scene", "scenes"),
     gltf_object("scenes", scene).array(), gltf_object("skins", skin).array(), gltf_object("textures", texture).array()},
    {}};

}  // namespace

const GltfObject& gltf_document() {
    return document;
}
const GltfObject& gltf_texture_info() {
    return texture_info;
}
const GltfObject& gltf_normal_texture_info() {
    return normal_texture_info;
}

}  // namespace sl
