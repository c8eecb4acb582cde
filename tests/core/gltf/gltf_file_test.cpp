// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_file.h"

#include <random>

#include "tests/core/gltf/gltf_fixture.h"

namespace sl {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string smallest = document_with("");

TEST(GltfFile, ReadsTextAndContainer) {
    EXPECT_THAT(gltf_faults(smallest), IsEmpty());
    GltfFaults faults;
    const std::string file = container(json_chunk(document_with(R"("buffers": [{"byteLength": 3}])")) + chunk(binary_kind, "abcd"));
    const GltfFile read = read_gltf_file(bytes_of(file), faults);
    EXPECT_TRUE(read.is_container);
    EXPECT_EQ(read.json["buffers"].size(), 1u);
    ASSERT_TRUE(read.binary);
    EXPECT_EQ(read.binary->size(), 4u);
    EXPECT_THAT(faults.list(), IsEmpty());
    EXPECT_THAT(gltf_faults(file), IsEmpty());
}

TEST(GltfFile, WhatIsNoFile) {
    EXPECT_THAT(gltf_faults(""), IsOnly("fatal byte 0", "empty"));
    EXPECT_THAT(gltf_faults(std::string(12, '\0')), IsOnly("fatal byte 0", "neither a container"));
    EXPECT_THAT(gltf_faults("{]"), IsOnly("fatal byte 1", "is no JSON"));
    EXPECT_THAT(gltf_faults("[]"), IsOnly("fatal ", "the document must be an object, not an array"));
    EXPECT_THAT(gltf_faults("{}"), IsOnly("fatal ", "the document has no \"asset\""));
}

TEST(GltfFile, BrokenContainers) {
    const std::string json = json_chunk(smallest);
    EXPECT_THAT(gltf_faults("glTF"), IsOnly("fatal byte 4", "ends within the container's header"));
    EXPECT_THAT(gltf_faults("glTF" + word(1) + word(20)), IsOnly("fatal byte 4", "has version 1"));
    EXPECT_THAT(gltf_faults("glTF" + word(2) + word(12)), IsOnly("fatal byte 8", "12 bytes long, too short"));
    EXPECT_THAT(gltf_faults(container(chunk(binary_kind, "abcd"))), IsOnly("fatal byte 16", "first chunk must be JSON"));
    EXPECT_THAT(gltf_faults(container(chunk("JSON", ""))), IsOnly("fatal byte 20", "JSON chunk is empty"));
    EXPECT_THAT(gltf_faults(container(json + json)), Contains(HasSubstr("second JSON chunk")));
    EXPECT_THAT(gltf_faults(container(json + chunk(binary_kind, "abcd") + chunk(binary_kind, "abcd"))),
                Contains(HasSubstr("second BIN chunk")));
    EXPECT_THAT(gltf_faults(container(json + chunk("MINE", "abcd") + chunk(binary_kind, "abcd"))),
                Contains(HasSubstr("BIN chunk must be the second, not number 3")));
    EXPECT_THAT(gltf_faults(container(json + word(100) + "MINE")), Contains(HasSubstr("says that it has 100 bytes; 0 are left")));
    EXPECT_THAT(gltf_faults(container(chunk("JSON", smallest + (smallest.size() % 4 == 3 ? "  " : " ")))),
                testing::Not(Contains(HasSubstr("fatal"))));
    EXPECT_THAT(gltf_faults(container(json + chunk("MINE", "abcd"))), IsEmpty());
}

TEST(GltfFile, EveryBeginningOfAContainerIsToldAndDoesNotCrash) {
    const std::string file = container(json_chunk(smallest) + chunk(binary_kind, "abcd"));
    for (std::size_t size = 0; size < file.size(); ++size) {
        EXPECT_FALSE(gltf_faults(file.substr(0, size)).empty()) << size;
    }
}

TEST(GltfFile, JsonThatOthersTakeInDifferentWays) {
    EXPECT_THAT(gltf_faults("\xef\xbb\xbf" + smallest), IsOnly("note byte 0", "byte order mark"));
    EXPECT_THAT(gltf_faults(container(chunk("JSON", smallest + std::string(4 - smallest.size() % 4, '\0')))),
                Contains(HasSubstr("padded with zeros")));
    EXPECT_THAT(gltf_faults(smallest + '\0' + smallest), IsOnly(fmt::format("fatal byte {}", smallest.size()), "a zero byte stands"));
    EXPECT_THAT(gltf_faults(R"({"asset": {"version": "2.0"}, "asset": {"version": "2.0"}})"),
                IsOnly("note ", "the key 'asset' twice"));
    EXPECT_THAT(gltf_faults(document_with(R"("extras": 1e400)")), Contains(HasSubstr("number overflow")));
    EXPECT_THAT(gltf_faults(document_with("\"extras\": \"\xff\"")), Contains(HasSubstr("is no JSON")));
}

TEST(GltfFile, DeepNesting) {
    const auto nested = [](std::size_t depth) {
        return document_with("\"extras\": " + std::string(depth, '[') + std::string(depth, ']'));
    };
    EXPECT_THAT(gltf_faults(nested(511)), IsEmpty());
    EXPECT_THAT(gltf_faults(nested(512)), IsOnly("fatal byte 551", "deeper than 512"));
    EXPECT_THAT(gltf_faults(std::string(10'000'000, '[')), IsOnly("fatal byte 512", "deeper than 512"));
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
    EXPECT_THAT(gltf_faults(objects), IsOnly("fatal byte 2560", "deeper than 512"));
}

TEST(GltfFile, LongArraysTakeTimeInProportion) {
    std::string nodes = "\"nodes\": [{}";
    for (int i = 1; i < 300'000; ++i) nodes += ",{}";
    EXPECT_THAT(faults_with(nodes + "]"), IsEmpty());
}

TEST(GltfFile, JsonThatWouldFillTheMemoryIsRefused) {
    std::string small = "[0";
    for (int i = 0; i < 1'800'000; ++i) small += ",{\"\":0}";
    EXPECT_THAT(faults_with("\"extras\": " + small + "]"), IsOnly("fatal byte 0", "more values than are read"));
}

TEST(GltfFile, BytesChangedAtRandomDoNotCrash) {
    const std::string file = container(json_chunk(document_with(
                                           R"("buffers": [{"byteLength": 44}], "bufferViews": [{"buffer": 0, "byteLength": 36},
        {"buffer": 0, "byteOffset": 36, "byteLength": 6}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3,
        "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}, {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "nodes": [{"mesh": 0, "children": [1]}, {}],
        "scenes": [{"nodes": [0]}], "scene": 0)")) + chunk(binary_kind, std::string(44, '\0')));
    EXPECT_THAT(gltf_faults(file), IsEmpty());
    std::minstd_rand random(7);
    for (int i = 0; i < 3000; ++i) {
        std::string changed = file;
        for (int k = 0; k < 1 + i % 3; ++k) changed[random() % changed.size()] = static_cast<char>(random() % 2 ? '0' + random() % 75 : random());
        gltf_faults(changed);
    }
}

}  // namespace
}  // namespace sl
