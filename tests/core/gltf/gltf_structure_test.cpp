// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_structure.h"

#include "tests/core/gltf/gltf_fixture.h"

namespace sl {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(GltfStructure, Types) {
    EXPECT_THAT(faults_with(R"("scene": "hello")"), IsOnly("fatal /scene", "a whole number from 0 to 2^53 - 1, not 'hello'"));
    EXPECT_THAT(faults_with(R"("scene": -1)"), IsOnly("fatal /scene", "not -1"));
    EXPECT_THAT(faults_with(R"("scene": 0.5)"), IsOnly("fatal /scene", "not 0.5"));
    EXPECT_THAT(faults_with(R"("samplers": {})"), IsOnly("fatal /samplers", "must be an array, not an object"));
    EXPECT_THAT(faults_with(R"("samplers": [null])"), IsOnly("fatal /samplers/0", "must be an object, not null"));
    EXPECT_THAT(faults_with(R"("nodes": [{"name": 42}])"), IsOnly("fatal /nodes/0/name", "must be a text, not 42"));
    EXPECT_THAT(faults_with(R"("materials": [{"doubleSided": 1}])"), IsOnly("fatal /materials/0/doubleSided", "true or false"));
    EXPECT_THAT(faults_with(R"("nodes": [{"scale": [1, "2", 3]}])"), IsOnly("fatal /nodes/0/scale/1", "must be a number"));
    EXPECT_THAT(faults_with(R"("meshes": [{"primitives": [{"attributes": []}]}])"),
                IsOnly("fatal /meshes/0/primitives/0/attributes", "must be an object"));
    EXPECT_THAT(faults_with(R"("nodes": [{"children": [1.0]}, {}])"), IsEmpty());
}

TEST(GltfStructure, Lengths) {
    EXPECT_THAT(faults_with(R"("nodes": [])"), IsOnly("note /nodes", "empty array"));
    EXPECT_THAT(faults_with(R"("nodes": [{"translation": [1, 2]}])"), IsOnly("fatal /nodes/0/translation", "has 2 elements; it must have 3"));
    EXPECT_THAT(faults_with(R"("nodes": [{"translation": [1, 2, 3, 4]}])"), IsOnly("fatal /nodes/0/translation", "at most 3"));
}

TEST(GltfStructure, Ranges) {
    EXPECT_THAT(faults_with(R"("materials": [{"alphaCutoff": -1}])"), IsOnly("note /materials/0/alphaCutoff", "is -1; must be at least 0"));
    EXPECT_THAT(faults_with(R"("materials": [{"emissiveFactor": [0, 2, 0]}])"),
                IsOnly("note /materials/0/emissiveFactor/1", "between 0 and 1"));
    EXPECT_THAT(faults_with(R"("cameras": [{"type": "perspective", "perspective": {"yfov": 0, "znear": 1}}])"),
                IsOnly("note /cameras/0/perspective/yfov", "above 0"));
    // Whoever reckons with a count must be able to trust it.
    EXPECT_THAT(faults_with(R"("buffers": [{"byteLength": 0}])"), IsOnly("fatal /buffers/0/byteLength", "at least 1"));
    EXPECT_THAT(faults_with(R"("buffers": [{"byteLength": 1e300}])"), IsOnly("fatal /buffers/0/byteLength", "1e+300"));
    EXPECT_THAT(faults_with(R"("buffers": [{"byteLength": 18446744073709551615}])"), IsOnly("fatal /buffers/0/byteLength", "whole number"));
    const auto with_stride = [](int stride) {
        return faults_with(fmt::format(R"("buffers": [{{"byteLength": 300}}], "bufferViews": [{{"buffer": 0, "byteLength": 300,
            "byteStride": {}}}])", stride));
    };
    EXPECT_THAT(with_stride(252), IsEmpty());
    EXPECT_THAT(with_stride(6), IsOnly("note /bufferViews/0/byteStride", "multiple of 4"));
    EXPECT_THAT(with_stride(256), IsOnly("fatal /bufferViews/0/byteStride", "between 4 and 252"));
}

TEST(GltfStructure, ChoicesAreToldWhereTheyAreClosed) {
    EXPECT_THAT(faults_with(R"("samplers": [{"wrapS": 7}])"), IsOnly("note /samplers/0/wrapS", "is 7; known are 33071"));
    EXPECT_THAT(faults_with(R"("materials": [{"alphaMode": "GLASS"}])"), IsOnly("note /materials/0/alphaMode", "OPAQUE, MASK, BLEND"));
    EXPECT_THAT(faults_with(R"("accessors": [{"componentType": 5126, "count": 1, "type": "VEC9"}])"), IsEmpty());
}

TEST(GltfStructure, WhatIsMissing) {
    EXPECT_THAT(faults_with(R"("accessors": [{"count": 1, "type": "VEC3"}])"), IsOnly("fatal /accessors/0", "has no \"componentType\""));
    EXPECT_THAT(faults_with(R"("accessors": [{"count": 1, "type": "VEC3", "componentType": 5126, "byteOffset": 0}])"),
                IsOnly("note /accessors/0/byteOffset", "needs \"bufferView\""));
    EXPECT_THAT(faults_with(R"("images": [{}])"), IsOnly("note /images/0", "has none of uri, bufferView"));
    EXPECT_THAT(faults_with(R"("cameras": [{"type": "perspective"}])"), IsOnly("fatal /cameras/0", "has no \"perspective\""));
    EXPECT_THAT(faults_with(R"("cameras": [{"type": "fisheye"}])"), IsEmpty());
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual":
                            {"lights": [{"type": "spot"}]}})"),
                IsOnly("fatal /extensions/KHR_lights_punctual/lights/0", "has no \"spot\""));
}

TEST(GltfStructure, References) {
    EXPECT_THAT(faults_with(R"("scene": 0)"), IsOnly("fatal /scene", "refers to number 0 of /scenes, which has 0"));
    EXPECT_THAT(faults_with(R"("nodes": [{"children": [1]}])"), IsOnly("fatal /nodes/0/children/0", "number 1 of /nodes"));
    EXPECT_THAT(faults_with(R"("meshes": [{"primitives": [{"attributes": {"a/b~c": 3}}]}])"),
                IsOnly("fatal /meshes/0/primitives/0/attributes/a~1b~0c", "number 3 of /accessors"));
    // The samplers of the same animation.
    EXPECT_THAT(faults_with(R"("accessors": [{"componentType": 5126, "count": 1, "type": "SCALAR"}], "samplers": [{}, {}],
                            "animations": [{"samplers": [{"input": 0, "output": 0}],
                            "channels": [{"sampler": 1, "target": {"path": "scale"}}]}])"),
                IsOnly("fatal /animations/0/channels/0/sampler", "number 1 of /samplers, which has 1"));
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["KHR_lights_punctual"], "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}}])"),
                IsOnly("fatal /nodes/0/extensions/KHR_lights_punctual/light", "number 0 of /extensions/KHR_lights_punctual/lights"));
}

TEST(GltfStructure, Extensions) {
    EXPECT_THAT(faults_with(R"("extensions": {"MINE": {}})"), IsOnly("note /extensions/MINE", "does not stand in /extensionsUsed"));
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["MINE"], "extensions": {"MINE": {"anything": [null]}})"), IsEmpty());
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["MINE"], "extensions": {"MINE": 42})"), IsOnly("fatal /extensions/MINE", "must be an object"));
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["MINE", "MINE"])"), IsOnly("note /extensionsUsed/1", "twice"));
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["KHR_materials_unlit"], "samplers": [{"extensions": {"KHR_materials_unlit": {}}}])"),
                IsOnly("note /samplers/0/extensions/KHR_materials_unlit", "has no place in the extensions of the sampler"));
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["KHR_materials_ior"], "materials": [
                            {"extensions": {"KHR_materials_ior": {"ior": 0}}}, {"extensions": {"KHR_materials_ior": {"ior": 0.5}}}])"),
                IsOnly("note /materials/1/extensions/KHR_materials_ior/ior", "must be 0 or at least 1"));
    EXPECT_THAT(faults_with(R"("extensionsUsed": ["KHR_mesh_quantization"])"), IsOnly("note /extensionsRequired", "must be required too"));
}

TEST(GltfStructure, RequiredExtensions) {
    const std::string members = R"("extensionsUsed": ["MINE", "KHR_materials_unlit"], "extensionsRequired": ["MINE", "KHR_materials_unlit"])";
    EXPECT_THAT(faults_with(members), IsOnly("fatal /extensionsRequired/0", "needs 'MINE'"));
    const auto json = nlohmann::json::parse(document_with(members));
    GltfFaults faults;
    const std::array<std::string_view, 1> supported{"MINE"};
    check_gltf_structure(json, faults, supported);
    ASSERT_EQ(faults.list().size(), 1u);
    EXPECT_EQ(faults.list()[0].where, "/extensionsRequired/1");
    EXPECT_THAT(faults_with(R"("extensionsRequired": ["KHR_materials_unlit"])"), Contains(HasSubstr("does not stand in /extensionsUsed")));
}

TEST(GltfStructure, Versions) {
    const auto with = [](std::string_view asset) { return gltf_faults(fmt::format(R"({{"asset": {{{}}}}})", asset)); };
    EXPECT_THAT(with(R"("version": "2.1", "minVersion": "2.0")"), IsEmpty());
    EXPECT_THAT(with(R"("version": "1.0")"), IsOnly("fatal /asset/version", "is '1.0'; this program reads 2.0"));
    EXPECT_THAT(with(R"("version": "2")"), IsOnly("fatal /asset/version", "must be a version"));
    EXPECT_THAT(with(R"("version": "2.0", "minVersion": "2.1")"), IsOnly("fatal /asset/minVersion", "later than the version '2.0'"));
    EXPECT_THAT(with(""), IsOnly("fatal /asset", "has no \"version\""));
}

TEST(GltfStructure, KeepsFiftyFaultsAndAlwaysTheFatalOne) {
    std::string materials;
    for (int i = 0; i < 1000; ++i) materials += R"({"alphaCutoff": -1},)";
    const auto notes = faults_with(fmt::format(R"("materials": [{}{{}}])", materials));
    EXPECT_EQ(notes.size(), most_gltf_faults);
    const auto with_fatal = faults_with(fmt::format(R"("materials": [{}{{"doubleSided": 1}}])", materials));
    ASSERT_EQ(with_fatal.size(), most_gltf_faults);
    EXPECT_THAT(with_fatal.back(), HasSubstr("fatal /materials/1000/doubleSided"));
}

TEST(GltfStructure, MessagesStayOnOneShortLine) {
    const auto faults = faults_with(fmt::format(R"("scene": "{}\n")", std::string(1'000'000, 'x')));
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_LT(faults[0].size(), 300u);
    EXPECT_EQ(faults[0].find('\n'), std::string::npos);
}

}  // namespace
}  // namespace sl
