// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_data_check.h"

#include <limits>

#include "tests/core/gltf/gltf_fixture.h"

namespace sl {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// One accessor on the file "a.bin", and what else a document needs.
std::vector<std::string> with_data(const std::string& data, std::string_view accessor, std::string_view more = "") {
    return faults_with(fmt::format(R"("buffers": [{{"byteLength": {0}, "uri": "a.bin"}}], "bufferViews": [{{"buffer": 0, "byteLength": {0}}}],
        "accessors": [{{"bufferView": 0, {1}}}, {{"componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}},
        {{"componentType": 5126, "count": 1, "type": "VEC3"}}]{2})", data.size(), accessor, more), {{"a.bin", data}});
}

std::string scalars(std::size_t count) {
    return fmt::format(R"("componentType": 5126, "count": {}, "type": "SCALAR")", count);
}

TEST(GltfData, Buffers) {
    const std::string members = R"("buffers": [{"byteLength": 4, "uri": "a%20b.bin"}])";
    EXPECT_THAT(faults_with(members, {{"a b.bin", "1234"}}), IsEmpty());
    EXPECT_THAT(faults_with(members, {{"a b.bin", "123"}}), IsOnly("fatal /buffers/0/byteLength", "is 4, but there are only 3 bytes"));
    EXPECT_THAT(faults_with(members, {{"a b.bin", ""}}), IsOnly("fatal /buffers/0/byteLength", "only 0 bytes"));
    EXPECT_THAT(faults_with(members), IsOnly("fatal /buffers/0/uri", "a b.bin: there is no such file"));
    EXPECT_THAT(faults_with(R"("buffers": [{"byteLength": 4, "uri": "http://x/a.bin"}, {"byteLength": 4}])"), IsEmpty());
    EXPECT_THAT(faults_with(R"("buffers": [{"byteLength": 1, "uri": "data:image/png;base64,AA=="}])"), IsOnly("note /buffers/0/uri", "image/png"));
    EXPECT_THAT(gltf_faults(container(json_chunk(document_with(R"("buffers": [{"byteLength": 5}])")) + chunk(binary_kind, "abcd"))),
                IsOnly("fatal /buffers/0/byteLength", "is 5, but there are only 4"));
    EXPECT_THAT(gltf_faults(container(json_chunk(document_with(R"("buffers": [{"byteLength": 4}])")))),
                IsOnly("fatal /buffers/0", "no BIN chunk"));
}

TEST(GltfData, EachFileIsLoadedOnce) {
    int loads = 0;
    const std::string file = document_with(R"("buffers": [{"byteLength": 2, "uri": "a.bin"}, {"byteLength": 1, "uri": "a.bin"}])");
    const GltfChecked checked = check_gltf(bytes_of(file), [&](const std::string&) {
        ++loads;
        return std::vector<std::byte>(2);
    });
    EXPECT_EQ(loads, 1);
    EXPECT_EQ(checked.resources.stored_bytes(), 2u);
    EXPECT_EQ(checked.resources.buffers()[0].size(), 2u);
    EXPECT_EQ(checked.resources.buffers()[1].size(), 1u);
}

TEST(GltfData, Bounds) {
    const std::string data = packed<float>({0.1f, 0.5f});
    EXPECT_THAT(with_data(data, scalars(2) + R"(, "min": [0.1], "max": [0.5])"), IsEmpty());
    EXPECT_THAT(with_data(data, scalars(2) + R"(, "min": [0.2], "max": [0.5])"), IsOnly("note /accessors/0/min/0", "is 0.2; the elements' is 0.1"));
    EXPECT_THAT(with_data(data, scalars(2) + R"(, "min": [0.1], "max": [1e300])"), IsOnly("note /accessors/0/max/0", "1e+300"));
    EXPECT_THAT(with_data(packed<std::int8_t>({-3, 4, -5, 6}), R"("componentType": 5120, "count": 2, "type": "VEC2", "min": [-5, 4], "max": [-3, 6])"), IsEmpty());
}

TEST(GltfData, WhatIsNoNumber) {
    EXPECT_THAT(with_data(packed({1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}), scalars(3)),
                IsOnly("note /accessors/0", "2 components are no finite numbers, first in element 1"));
}

TEST(GltfData, Indices) {
    const auto with = [](std::initializer_list<std::uint8_t> indices, int accessor = 1) {
        return with_data(packed(indices), R"("componentType": 5121, "count": 3, "type": "SCALAR")",
                         fmt::format(R"(, "meshes": [{{"primitives": [{{"attributes": {{"NORMAL": {}}}, "indices": 0}}]}}])", accessor));
    };
    EXPECT_THAT(with({0, 1, 2}), IsEmpty());
    EXPECT_THAT(with({0, 1, 3}), IsOnly("fatal /meshes/0/primitives/0/indices", "leads to vertex 3; there are 3"));
    EXPECT_THAT(with({0, 1, 255}), Contains(HasSubstr("note /meshes/0/primitives/0/indices: accessor 0 holds 255, which would begin")));
}

TEST(GltfData, SparseElements) {
    const auto with = [](std::uint8_t first, std::uint8_t second, std::string_view more = "") {
        const std::string data = packed<float>({0.0f, 0.0f, 0.0f, 5.0f, 7.0f}) + packed<std::uint8_t>({first, second});
        return faults_with(fmt::format(R"("buffers": [{{"byteLength": 22, "uri": "a.bin"}}], "bufferViews": [{{"buffer": 0, "byteLength": 22}}],
            "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "SCALAR", "sparse": {{"count": 2,
            "indices": {{"bufferView": 0, "byteOffset": 20, "componentType": 5121}}, "values": {{"bufferView": 0, "byteOffset": 12}}}}{}}}])", more), {{"a.bin", data}});
    };
    EXPECT_THAT(with(1, 2, R"(, "min": [0], "max": [7])"), IsEmpty());
    EXPECT_THAT(with(1, 2, R"(, "min": [0], "max": [0])"), IsOnly("note /accessors/0/max/0", "is 0; the elements' is 7"));
    EXPECT_THAT(with(2, 1), IsOnly("note /accessors/0/sparse/indices", "number 1 is 1, after 2"));
    EXPECT_THAT(with(1, 3), IsOnly("fatal /accessors/0/sparse/indices", "number 1 is 3, in an accessor of 3 elements"));
}

TEST(GltfData, Vertices) {
    const auto with = [](std::string_view name, std::initializer_list<float> numbers) {
        return with_data(packed(numbers), fmt::format(R"("componentType": 5126, "count": 1, "type": "VEC{}")", numbers.size()),
                         fmt::format(R"(, "meshes": [{{"primitives": [{{"attributes": {{"{}": 0}}}}]}}])", name));
    };
    EXPECT_THAT(with("NORMAL", {0, 0.6f, 0.8f}), IsEmpty());
    EXPECT_THAT(with("NORMAL", {0, 0, 0}), IsOnly("note /meshes/0/primitives/0/attributes/NORMAL", "has the length 0, not 1"));
    EXPECT_THAT(with("TANGENT", {0, 1, 0, -1}), IsEmpty());
    EXPECT_THAT(with("TANGENT", {0, 1, 0, 0.5f}), IsOnly("note /meshes/0/primitives/0/attributes/TANGENT", "is 0.5, not 1 or -1"));
    EXPECT_THAT(with("COLOR_0", {0, 1, 1.5f}), IsOnly("note /meshes/0/primitives/0/attributes/COLOR_0", "holds 1.5, not between 0 and 1"));
}

TEST(GltfData, JointsAndWeights) {
    const auto with = [](std::initializer_list<std::uint8_t> joints, std::initializer_list<float> weights) {
        return faults_with(R"("buffers": [{"byteLength": 20, "uri": "a.bin"}], "bufferViews": [{"buffer": 0, "byteLength": 4},
            {"buffer": 0, "byteOffset": 4, "byteLength": 16}], "accessors": [{"bufferView": 0, "componentType": 5121, "count": 1, "type": "VEC4"},
            {"bufferView": 1, "componentType": 5126, "count": 1, "type": "VEC4"}],
            "meshes": [{"primitives": [{"attributes": {"JOINTS_0": 0, "WEIGHTS_0": 1}}]}],
            "nodes": [{"children": [1]}, {}, {"mesh": 0, "skin": 0}], "skins": [{"joints": [0, 1]}])", {{"a.bin", packed(joints) + packed(weights)}});
    };
    EXPECT_THAT(with({0, 1, 0, 0}, {0.25f, 0.75f, 0, 0}), IsEmpty());
    EXPECT_THAT(with({0, 2, 0, 0}, {0.25f, 0.75f, 0, 0}), IsOnly("fatal /nodes/2/skin", "mesh 0 refers to joint 2; skin 0 has 2"));
    EXPECT_THAT(with({0, 1, 0, 0}, {0.25f, 0.5f, 0, 0}), IsOnly("note /meshes/0/primitives/0/attributes", "sum to 0.75"));
    EXPECT_THAT(with({1, 1, 0, 0}, {0.25f, 0.75f, 0, 0}), IsOnly("note /meshes/0/primitives/0/attributes", "hangs on joint 1 twice"));
    EXPECT_THAT(with({0, 1, 0, 0}, {-0.25f, 1.25f, 0, 0}), IsOnly("note /meshes/0/primitives/0/attributes", "has the weight -0.25"));
}

TEST(GltfData, KeyTimes) {
    const auto with = [](std::initializer_list<float> times) {
        const float least = std::min(times), most = std::max(times);
        return with_data(packed(times), fmt::format(R"({}, "min": [{}], "max": [{}])", scalars(times.size()), least, most),
                         R"(, "nodes": [{}], "animations": [{"samplers": [{"input": 0, "output": 1}], "channels": [
                         {"sampler": 0, "target": {"node": 0, "path": "scale"}}]}])");
    };
    EXPECT_THAT(with({0, 1, 2}), IsEmpty());
    EXPECT_THAT(with({0, 1, 1}), IsOnly("note /animations/0/samplers/0/input", "key 2 of accessor 0 is at 1 seconds, the one before it at 1"));
    EXPECT_THAT(with({-1, 1, 2}), IsOnly("note /animations/0/samplers/0/input", "before 0"));
}

TEST(GltfData, ShortFilesDoNotClaimMuch) {
    EXPECT_THAT(faults_with(R"("accessors": [{"componentType": 5126, "count": 4000000000, "type": "VEC3"}])"), IsOnly("fatal /accessors", "hold 48000000000 bytes"));
    EXPECT_THAT(faults_with(R"("accessors": [{"componentType": 5126, "count": 9007199254740991, "type": "MAT4"},
                            {"componentType": 5126, "count": 9007199254740991, "type": "MAT4"}])"), IsOnly("fatal /accessors", "together"));
    const std::string accessor = R"({"bufferView": 0, "componentType": 5121, "count": 1000000, "type": "SCALAR"})";
    std::string many = accessor;
    for (int i = 0; i < 1000; ++i) many += ", " + accessor;
    EXPECT_THAT(faults_with(fmt::format(R"("buffers": [{{"byteLength": 1000000, "uri": "a.bin"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 1000000}}], "accessors": [{}])", many), {{"a.bin", std::string(1'000'000, '\0')}}),
                IsOnly("fatal /accessors", "hold 1001000000 bytes together, of 1000000 that are stored"));
}

}  // namespace
}  // namespace sl
