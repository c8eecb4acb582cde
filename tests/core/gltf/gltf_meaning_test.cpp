// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_meaning.h"

#include "tests/core/gltf/gltf_fixture.h"

namespace sl {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Accessors on one view of one buffer.
std::vector<std::string> with_accessor(std::string_view accessor, std::string_view view = R"("byteLength": 64)") {
    return faults_with(fmt::format(R"("buffers": [{{"byteLength": 64}}], "bufferViews": [{{"buffer": 0, {}}}], "accessors": [{{{}}}])",
                                   view, accessor));
}

TEST(GltfMeaning, ViewsLieWithinBuffers) {
    const std::string accessor = R"("componentType": 5121, "count": 1, "type": "SCALAR")";
    EXPECT_THAT(with_accessor(accessor, R"("byteOffset": 60, "byteLength": 4)"), IsEmpty());
    EXPECT_THAT(with_accessor(accessor, R"("byteOffset": 60, "byteLength": 5)"), IsOnly("fatal /bufferViews/0", "bytes 60 to 65 lie outside buffer 0, which has 64"));
    EXPECT_THAT(with_accessor(accessor, R"("byteOffset": 9007199254740991, "byteLength": 9007199254740991)"),
                IsOnly("fatal /bufferViews/0", "lie outside"));
    EXPECT_THAT(with_accessor(accessor, R"("byteLength": 4, "byteStride": 8)"), IsOnly("note /bufferViews/0/byteStride", "more than the whole view"));
}

TEST(GltfMeaning, AccessorsLieWithinViews) {
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC4")"), IsEmpty());
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC4")"),
                IsOnly("fatal /accessors/0", "ends at byte 80 of buffer view 0, which has 64"));
    // The last element needs no stride, and the last column no padding.
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "componentType": 5121, "count": 2, "type": "MAT3")", R"("byteLength": 23)"), IsEmpty());
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "componentType": 5121, "count": 2, "type": "MAT3")", R"("byteLength": 22)"),
                IsOnly("fatal /accessors/0", "ends at byte 23"));
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "byteOffset": 9007199254740991, "componentType": 5126, "count": 9007199254740991, "type": "MAT4")",
                              R"("byteLength": 64, "byteStride": 252)"),
                Contains(HasSubstr("fatal /accessors/0: ends at byte")));
}

TEST(GltfMeaning, AlignmentIsTold) {
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "byteOffset": 2, "componentType": 5126, "count": 1, "type": "SCALAR")"),
                IsOnly("note /accessors/0/byteOffset", "is 2, no multiple of the component's 4 bytes"));
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "componentType": 5123, "count": 1, "type": "SCALAR")", R"("byteOffset": 1, "byteLength": 8)"),
                IsOnly("note /accessors/0/byteOffset", "is 1 in the buffer"));
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "byteOffset": 2, "componentType": 5121, "count": 1, "type": "MAT2")"),
                IsOnly("note /accessors/0", "matrices do not begin"));
    EXPECT_THAT(with_accessor(R"("bufferView": 0, "componentType": 5126, "count": 1, "type": "VEC4")", R"("byteLength": 64, "byteStride": 4)"),
                IsOnly("note /accessors/0", "they overlap"));
    EXPECT_THAT(with_accessor(R"("componentType": 5126, "count": 1, "type": "SCALAR", "normalized": true)"),
                IsOnly("note /accessors/0/normalized", "float32 cannot be normalized"));
    EXPECT_THAT(with_accessor(R"("componentType": 5126, "count": 1, "type": "VEC2", "min": [1])"), IsOnly("note /accessors/0/min", "has 1 numbers"));
}

TEST(GltfMeaning, SparseAccessors) {
    const auto with = [](std::string_view sparse) {
        return with_accessor(fmt::format(R"("componentType": 5126, "count": 4, "type": "SCALAR", "sparse": {{{}}})", sparse));
    };
    const auto parts = [](int count, int index_offset, int value_offset) {
        return fmt::format(R"("count": {}, "indices": {{"bufferView": 0, "byteOffset": {}, "componentType": 5123}},
                           "values": {{"bufferView": 0, "byteOffset": {}}})", count, index_offset, value_offset);
    };
    EXPECT_THAT(with(parts(4, 0, 48)), IsEmpty());
    EXPECT_THAT(with(parts(5, 0, 8)), IsOnly("fatal /accessors/0/sparse/count", "replaces 5 elements of 4"));
    EXPECT_THAT(with(parts(4, 58, 0)), IsOnly("fatal /accessors/0/sparse/indices", "ends at byte 66"));
    EXPECT_THAT(with(parts(4, 0, 52)), IsOnly("fatal /accessors/0/sparse/values", "ends at byte 68"));
}

TEST(GltfMeaning, NodesAreTrees) {
    EXPECT_THAT(faults_with(R"("nodes": [{"children": [1]}, {"children": [0]}])"), IsOnly("fatal /nodes/0", "hangs on itself"));
    EXPECT_THAT(faults_with(R"("nodes": [{"children": [0]}])"), IsOnly("fatal /nodes/0", "hangs on itself"));
    EXPECT_THAT(faults_with(R"("nodes": [{"children": [2]}, {"children": [2]}, {}])"),
                IsOnly("fatal /nodes/1/children/0", "node 2 is already a child of node 0"));
    EXPECT_THAT(faults_with(R"("nodes": [{"children": [1, 1]}, {}])"), IsOnly("fatal /nodes/0/children/1", "already a child"));
    EXPECT_THAT(faults_with(R"("nodes": [{"children": [1]}, {}], "scenes": [{"nodes": [1]}])"),
                IsOnly("note /scenes/0/nodes/0", "node 1 is no root: it is a child of node 0"));
    std::string chain = "\"nodes\": [";
    for (int i = 1; i < 100'000; ++i) chain += fmt::format("{{\"children\": [{}]}},", i);
    EXPECT_THAT(faults_with(chain + "{}]"), IsEmpty());
    EXPECT_THAT(faults_with(chain + "{\"children\": [0]}]"), IsOnly("fatal /nodes/0", "hangs on itself"));
}

TEST(GltfMeaning, Transforms) {
    EXPECT_THAT(faults_with(R"("nodes": [{"rotation": [1, 1, 1, 1]}])"), IsOnly("note /nodes/0/rotation", "length 2"));
    EXPECT_THAT(faults_with(R"("nodes": [{"matrix": [1,0,0,0, 1,1,0,0, 0,0,1,0, 0,0,0,1]}])"), IsOnly("note /nodes/0/matrix", "no product"));
    EXPECT_THAT(faults_with(R"("nodes": [{"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]}])"), IsOnly("note /nodes/0/matrix", "no product"));
    EXPECT_THAT(faults_with(R"("nodes": [{"matrix": [0,-2,0,0, 1,0,0,0, 0,0,1e-9,0, 5,6,7,1]}])"), IsEmpty());
    EXPECT_THAT(faults_with(R"("nodes": [{"scale": [1,1,1], "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])"), IsOnly("note /nodes/0", "beside"));
}

const std::string triangle_accessors = R"("accessors": [
    {"componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]},
    {"componentType": 5126, "count": 3, "type": "VEC2"}, {"componentType": 5123, "count": 3, "type": "SCALAR"},
    {"componentType": 5123, "count": 3, "type": "VEC4"}, {"componentType": 5126, "count": 3, "type": "VEC4"},
    {"componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]},
    {"componentType": 5126, "count": 3, "type": "VEC3"}, {"componentType": 5125, "count": 3, "type": "VEC3"},
    {"componentType": 5126, "count": 2, "type": "MAT4"}, {"componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [0]},
    {"componentType": 5126, "count": 2, "type": "VEC3"}, {"componentType": 5126, "count": 6, "type": "VEC4"}])";

std::vector<std::string> with_primitive(std::string_view primitive, std::string_view more = R"("asset2": 0)") {
    return faults_with(fmt::format(R"({}, "meshes": [{{"primitives": [{{{}}}]}}], {})", triangle_accessors, primitive, more));
}

TEST(GltfMeaning, Attributes) {
    const std::string at = "/meshes/0/primitives/0/attributes";
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0, "TEXCOORD_0": 1, "JOINTS_0": 3, "WEIGHTS_0": 4, "_MINE": 1}, "indices": 2)"), IsEmpty());
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 4})"), Contains(HasSubstr("VEC4 of float32; it must be VEC3 of float32")));
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0, "NORMAL": 5})"), IsOnly("fatal " + at + "/NORMAL", "has 4 elements for 3 vertices"));
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 6})"), IsOnly("note " + at + "/POSITION", "no min and max"));
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0, "_MINE": 7})"), IsOnly("note " + at + "/_MINE", "anything but uint32"));
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0, "JOINTS_0": 3})"), IsOnly("note " + at, "1 JOINTS and 0 WEIGHTS"));
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0, "TEXCOORD_1": 1})"), IsOnly("note " + at, "without a gap; here 1 go up to 1"));
    for (const char* name : {"TEXCOORD", "TEXCOORD_", "TEXCOORD_00", "TEXCOORD_x", "TEXCOORD_1_1", "COLOUR_0", "", "POSITION_0",
                             "TEXCOORD_99999999999999999999999"}) {
        EXPECT_THAT(with_primitive(fmt::format(R"("attributes": {{"POSITION": 0, "{}": 1}})", name)),
                    IsOnly("note " + at + "/" + name, "is no attribute of the format"));
    }
}

TEST(GltfMeaning, IndicesAndTargets) {
    const std::string at = "/meshes/0/primitives/0";
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0}, "indices": 1)"), IsOnly("fatal " + at + "/indices", "must be SCALAR of uint8"));
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0}, "targets": [{"POSITION": 0}])"), IsEmpty());
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0}, "targets": [{"POSITION": 5}])"), IsOnly("fatal " + at + "/targets/0/POSITION", "has 4 elements for 3"));
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0}, "targets": [{"NORMAL": 6}])"), IsOnly("note " + at + "/targets/0/NORMAL", "no NORMAL to add it to"));
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0, "TANGENT": 4}, "targets": [{"TANGENT": 6}])"), IsEmpty());
    EXPECT_THAT(with_primitive(R"("attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 0}, "targets": [{"POSITION": 0}])"),
                IsOnly("note /meshes/0/primitives/1/targets", "has 1 morph targets; the mesh's first primitive has 0"));
}

TEST(GltfMeaning, QuantizedMeshes) {
    const std::string extension = R"("extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"])";
    const std::string members = R"("accessors": [{"componentType": 5122, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}],
                                   "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}])";
    EXPECT_THAT(faults_with(members), IsOnly("fatal /meshes/0/primitives/0/attributes/POSITION", "VEC3 of int16; it must be VEC3 of float32"));
    EXPECT_THAT(faults_with(members + ", " + extension), IsEmpty());
}

TEST(GltfMeaning, MaterialsNeedCoordinatesAndTangents) {
    const std::string at = "note /meshes/0/primitives/0/material";
    const auto with = [](std::string_view material, std::string_view more = "") {
        return with_primitive(fmt::format(R"("material": 0, "attributes": {{"POSITION": 0, "TEXCOORD_0": 1{}}})", more),
                              fmt::format(R"("textures": [{{}}], "extensionsUsed": ["KHR_texture_transform", "KHR_materials_clearcoat"],
                                          "materials": [{{{}}}])", material));
    };
    EXPECT_THAT(with(R"("emissiveTexture": {"index": 0})"), IsEmpty());
    EXPECT_THAT(with(R"("emissiveTexture": {"index": 0, "texCoord": 1})"), IsOnly(at, "needs TEXCOORD_1; the primitive has 1"));
    EXPECT_THAT(with(R"("emissiveTexture": {"index": 0, "texCoord": 1, "extensions": {"KHR_texture_transform": {"texCoord": 0}}})"), IsEmpty());
    EXPECT_THAT(with(R"("extensions": {"KHR_materials_clearcoat": {"clearcoatNormalTexture": {"index": 0}}})"), IsOnly(at, "needs NORMAL and TANGENT"));
    EXPECT_THAT(with(R"("extensions": {"KHR_materials_clearcoat": {"clearcoatNormalTexture": {"index": 0}}})", R"(, "NORMAL": 6, "TANGENT": 4)"), IsEmpty());
}

TEST(GltfMeaning, Skins) {
    const auto with = [](std::string_view skin) {
        return faults_with(fmt::format(R"({}, "nodes": [{{"children": [1, 2]}}, {{}}, {{}}, {{}}], "skins": [{{{}}}])", triangle_accessors, skin));
    };
    EXPECT_THAT(with(R"("joints": [1, 2], "skeleton": 0, "inverseBindMatrices": 8)"), IsEmpty());
    EXPECT_THAT(with(R"("joints": [1, 3])"), IsOnly("note /skins/0/joints", "nodes 1 and 3 have no common root"));
    EXPECT_THAT(with(R"("joints": [1, 2], "skeleton": 1)"), IsOnly("note /skins/0/skeleton", "joint 2 is not below node 1"));
    EXPECT_THAT(with(R"("joints": [0, 1, 2], "inverseBindMatrices": 8)"), IsOnly("fatal /skins/0/inverseBindMatrices", "has 2 matrices for 3 joints"));
    EXPECT_THAT(with(R"("joints": [0], "inverseBindMatrices": 0)"), IsOnly("fatal /skins/0/inverseBindMatrices", "must be MAT4 of float32"));
}

TEST(GltfMeaning, Animations) {
    const auto with = [](std::string_view sampler, std::string_view target) {
        return faults_with(fmt::format(R"({}, "nodes": [{{}}, {{"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}}],
            "animations": [{{"samplers": [{{{}}}], "channels": [{{"sampler": 0, "target": {{{}}}}}]}}])", triangle_accessors, sampler, target));
    };
    EXPECT_THAT(with(R"("input": 9, "output": 10)", R"("node": 0, "path": "scale")"), IsEmpty());
    EXPECT_THAT(with(R"("input": 9, "output": 11, "interpolation": "CUBICSPLINE")", R"("node": 0, "path": "rotation")"), IsEmpty());
    EXPECT_THAT(with(R"("input": 9, "output": 11)", R"("node": 0, "path": "rotation")"), IsOnly("note /animations/0/channels/0", "has 6 values; 2 keys need 2"));
    EXPECT_THAT(with(R"("input": 9, "output": 10, "interpolation": "CUBICSPLINE")", R"("node": 0, "path": "scale")"),
                IsOnly("fatal /animations/0/channels/0", "has 2 values; 2 keys need 6"));
    EXPECT_THAT(with(R"("input": 9, "output": 9)", R"("node": 0, "path": "scale")"), IsOnly("fatal /animations/0/channels/0", "for scale it must be VEC3"));
    EXPECT_THAT(with(R"("input": 2, "output": 6)", R"("node": 0, "path": "scale")"), Contains(HasSubstr("fatal /animations/0/samplers/0/input")));
    EXPECT_THAT(with(R"("input": 9, "output": 10)", R"("node": 1, "path": "scale")"), IsOnly("note /animations/0/channels/0/target", "has a matrix"));
    EXPECT_THAT(with(R"("input": 9, "output": 9)", R"("node": 0, "path": "weights")"), IsOnly("note /animations/0/channels/0/target", "no morph targets"));
    EXPECT_THAT(with(R"("input": 9, "output": 10)", R"("node": 0, "path": "colour")"), IsEmpty());
}

TEST(GltfMeaning, AViewServesInOneWay) {
    const auto with = [](std::string_view view) {
        return faults_with(fmt::format(R"("buffers": [{{"byteLength": 64}}], "bufferViews": [{{"buffer": 0, "byteLength": 64{}}}], "accessors": [
            {{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}},
            {{"bufferView": 0, "componentType": 5123, "count": 3, "type": "SCALAR"}}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}])", view));
    };
    EXPECT_THAT(with(""), IsOnly("note /meshes/0/primitives/0/indices", "view 0 holds vertices, so that it cannot hold indices"));
    EXPECT_THAT(with(R"(, "target": 34963)"), IsOnly("note /meshes/0/primitives/0/attributes/POSITION", "holds indices"));
    EXPECT_THAT(with(R"(, "byteStride": 12)"), Contains(HasSubstr("has a byteStride, which only views of vertices may have")));
    EXPECT_THAT(faults_with(R"("buffers": [{"byteLength": 72}], "bufferViews": [{"buffer": 0, "byteLength": 72}], "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]},
            {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}])"),
                IsOnly("note /meshes/0/primitives/0/attributes/POSITION", "has no byteStride, which it needs"));
}

TEST(GltfMeaning, CamerasAndLights) {
    const auto with = [](std::string_view camera) {
        return faults_with(fmt::format(R"("cameras": [{{"type": "orthographic", "orthographic": {{{}}}}}])", camera));
    };
    EXPECT_THAT(with(R"("xmag": 1, "ymag": 1, "znear": 0, "zfar": 1)"), IsEmpty());
    EXPECT_THAT(with(R"("xmag": 1, "ymag": 1, "znear": 2, "zfar": 1)"), IsOnly("note /cameras/0/orthographic", "zfar is 1, not more than znear, 2"));
    EXPECT_THAT(with(R"("xmag": 0, "ymag": 1, "znear": 0, "zfar": 1)"), IsOnly("note /cameras/0/orthographic", "xmag is 0"));
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [
                            {"type": "spot", "spot": {"innerConeAngle": 0.8}}]}})"),
                IsOnly("note /extensions/KHR_lights_punctual/lights/0/spot", "innerConeAngle is 0.8, not less than outerConeAngle"));
}

}  // namespace
}  // namespace sl
