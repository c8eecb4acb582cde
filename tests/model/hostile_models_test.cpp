// SPDX-License-Identifier: MIT
#include <limits>

#include "engine/core/model/model_pose.h"
#include "engine/core/model/picture.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Files that were made to break a loader. Each must end in one line, or in a model without what makes no sense.
class HostileModelTest : public ModelTest {
  protected:
    std::string fault_of(const std::string& content, const char* name = "model.gltf") {
        std::ofstream(folder / name, std::ios::binary) << content;
        try {
            (void)read_gltf(folder / name);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
    static std::string with(const std::string& members) { return "{\"asset\": {\"version\": \"2.0\"}, " + members + "}"; }
    static std::string word(std::uint32_t value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }

    /// A square that two joints move.
    void show_skinned(const std::vector<std::uint8_t>& joints, const std::vector<float>& weights) {
        Json primitive = square();
        primitive["attributes"]["JOINTS_0"] = add_accessor(joints, 5121, "VEC4", 4);
        primitive["attributes"]["WEIGHTS_0"] = add_accessor(weights, 5126, "VEC4", 4);
        show(primitive);
        json["nodes"].push_back({{"children", {2}}});
        json["nodes"].push_back(Json::object());
        json["scenes"][0]["nodes"].push_back(1);
        json["skins"] = {{{"joints", {1, 2}}}};
        json["nodes"][0]["skin"] = 0;
    }
    /// A node that a channel moves at such times.
    void show_moved(const std::vector<float>& times) {
        const int input = add_accessor(times, 5126, "SCALAR", times.size(), {{"min", {0}}, {"max", {1}}});
        const int output = add_accessor(std::vector<float>(3 * times.size(), 1.0f), 5126, "VEC3", times.size());
        json["nodes"] = Json::array({Json::object()});
        json["scenes"][0]["nodes"] = {0};
        json["animations"] = {{{"samplers", {{{"input", input}, {"output", output}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}}}}};
    }
};

TEST_F(HostileModelTest, DeepNesting) {
    const std::string open(100'000, '['), close(100'000, ']');
    EXPECT_THAT(fault_of(with("\"extras\": " + open + close)),
                HasSubstr("model.gltf: byte 551: is no JSON that can be read: nested deeper than 512 levels"));
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"extras\":";
    EXPECT_THAT(fault_of(objects), HasSubstr("nested deeper"));
}

TEST_F(HostileModelTest, NumbersThatAreNoCounts) {
    EXPECT_THAT(fault_of(with(R"("buffers": [{"byteLength": 1e400}])")), HasSubstr("number overflow parsing '1e400'"));
    for (const char* number :
         {"-1", "1.5", "1e300", "18446744073709551615", "18446744073709551616", "9007199254740992", "\"4\"", "null", "{}"}) {
        EXPECT_THAT(fault_of(with(fmt::format(R"("buffers": [{{"byteLength": {}}}])", number))),
                    HasSubstr("model.gltf: /buffers/0/byteLength: must be a whole number"))
            << number;
        EXPECT_THAT(fault_of(with(fmt::format(R"("nodes": [{{"mesh": {}}}])", number))),
                    HasSubstr("model.gltf: /nodes/0/mesh: must be a whole number"))
            << number;
    }
}

TEST_F(HostileModelTest, SumsThatWouldOverflow) {
    const std::string most = "9007199254740991";
    const std::string buffer = R"("buffers": [{"byteLength": 4, "uri": "data:application/octet-stream;base64,AAAAAA=="}], )";
    EXPECT_THAT(
        fault_of(with(buffer + fmt::format(R"("bufferViews": [{{"buffer": 0, "byteOffset": {0}, "byteLength": {0}}}])", most))),
        HasSubstr("/bufferViews/0: bytes 9007199254740991 to 18014398509481982 lie outside buffer 0"));
    EXPECT_THAT(fault_of(with(buffer + R"("bufferViews": [{"buffer": 0, "byteOffset": 18446744073709551614, "byteLength": 4}])")),
                HasSubstr("/bufferViews/0/byteOffset: must be a whole number"));
    EXPECT_THAT(fault_of(with(buffer + fmt::format(R"("bufferViews": [{{"buffer": 0, "byteLength": 4, "byteStride": 252}}],
        "accessors": [{{"bufferView": 0, "byteOffset": {0}, "count": {0}, "componentType": 5126, "type": "MAT4"}}])",
                                                   most))),
                HasSubstr("/accessors/0: ends at byte"));
}

TEST_F(HostileModelTest, NodesThatAreNoTree) {
    EXPECT_THAT(fault_of(with(R"("nodes": [{"children": [1]}, {"children": [2]}, {"children": [0]}])")),
                HasSubstr("/nodes/0: the node hangs on itself"));
    EXPECT_THAT(fault_of(with(R"("nodes": [{"children": [0]}])")), HasSubstr("/nodes/0: the node hangs on itself"));
    EXPECT_THAT(fault_of(with(R"("nodes": [{"children": [2]}, {"children": [2]}, {}])")),
                HasSubstr("/nodes/1/children/0: node 2 is already a child of node 0"));
    std::string chain = "\"nodes\": [";
    for (int i = 1; i < 100'000; ++i) chain += fmt::format("{{\"children\": [{}]}},", i);
    EXPECT_EQ(fault_of(with(chain + "{}]")), "");
    EXPECT_EQ(places_of(read_gltf(folder / "model.gltf"), 0).size(), 100'000u);
}

TEST_F(HostileModelTest, ElementsThatAreNotStored) {
    EXPECT_THAT(fault_of(with(R"("accessors": [{"componentType": 5126, "count": 1000000000000000, "type": "VEC3"}])")),
                HasSubstr("model.gltf: /accessors: hold 12000000000000000 bytes together, of 0 that are stored"));
    const std::string sparse = R"("accessors": [{{"componentType": 5126, "count": {0}, "type": "VEC3", "sparse": {{"count": {0},
        "indices": {{"bufferView": 0, "componentType": 5121}}, "values": {{"bufferView": 0}}}}}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 4}}], "buffers": [{{"byteLength": 4, "uri": "data:application/octet-stream;base64,AAAAAA=="}}])";
    EXPECT_THAT(fault_of(with(fmt::format(fmt::runtime(sparse), 1'000'000'000'000'000))),
                HasSubstr("/accessors/0/sparse/indices: ends at byte 1000000000000000 of buffer view 0, which has 4"));
    // A hundred thousand primitives of the same zeros: a file that is fine, of a model that nobody could keep.
    std::string primitives = R"({"attributes": {"POSITION": 0}})";
    for (int i = 1; i < 100'000; ++i) primitives += R"(,{"attributes": {"POSITION": 0}})";
    const std::string zeros =
        R"("accessors": [{"componentType": 5126, "count": 1000000, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}])";
    EXPECT_THAT(
        fault_of(with(zeros + R"(, "meshes": [{"primitives": [)" + primitives + "]}]")),
        HasSubstr("model.gltf: the model would take 7629395 MB by using the same numbers many times, which take 0 MB once; it may take 256 MB"));
}

TEST_F(HostileModelTest, ScenesThatShareARootOfManySkins) {
    constexpr int count = 20'000;
    std::string children = "1", nodes = R"({"mesh": 0, "skin": 0})", scenes = R"({"nodes": [0]})";
    for (int i = 2; i <= count; ++i) children += fmt::format(",{}", i);
    for (int i = 1; i < count; ++i) nodes += R"(,{"mesh": 0, "skin": 0})";
    for (int i = 1; i < count; ++i) scenes += R"(,{"nodes": [0]})";
    EXPECT_EQ(fault_of(with(fmt::format(R"("nodes": [{{"children": [{}]}}, {}], "scenes": [{}], "skins": [{{"joints": [0]}}],
        "accessors": [{{"componentType": 5121, "count": 1, "type": "VEC4"}}, {{"componentType": 5126, "count": 1, "type": "VEC4"}}],
        "meshes": [{{"primitives": [{{"attributes": {{"JOINTS_0": 0, "WEIGHTS_0": 1}}}}]}}])",
                                        children, nodes, scenes))),
              "");
    const Model model = read_gltf(folder / "model.gltf");
    EXPECT_EQ(model.scenes.size(), 20'000u);
    EXPECT_THAT(model.warnings, testing::ElementsAre(HasSubstr("it has no positions that are read")));
}

TEST_F(HostileModelTest, DataThatEndTooSoon) {
    for (const char* data : {"AAA", "AAAA====", "A*AA", "AAAAA"}) {
        EXPECT_THAT(fault_of(with(fmt::format(
                        R"("buffers": [{{"byteLength": 3, "uri": "data:application/octet-stream;base64,{}"}}])", data))),
                    HasSubstr("/buffers/0/uri: 'data:application/octet-stream;base64,"))
            << data;
    }
    EXPECT_THAT(fault_of(with(R"("buffers": [{"byteLength": 4, "uri": "data:application/octet-stream;base64,AAAA"}])")),
                HasSubstr("/buffers/0/byteLength: is 4, but there are only 3 bytes"));
    EXPECT_THAT(fault_of(with(R"("buffers": [{"byteLength": 4, "uri": "data:application/octet-stream;base64"}])")),
                HasSubstr("is no URI"));
}

TEST_F(HostileModelTest, ContainersThatLieAboutTheirLength) {
    const std::string document = with("\"scene\": 0, \"scenes\": [{}]   "),
                      chunk = word(static_cast<std::uint32_t>(document.size())) + "JSON" + document;
    ASSERT_EQ(document.size() % 4, 0u);
    const auto size = static_cast<std::uint32_t>(12 + chunk.size());
    EXPECT_EQ(fault_of("glTF" + word(2) + word(size) + chunk, "model.glb"), "");
    EXPECT_EQ(fault_of("glTF" + word(2) + word(0xffffffffu) + chunk, "model.glb"), "");
    EXPECT_THAT(
        read_gltf(folder / "model.glb").warnings,
        Contains(HasSubstr(fmt::format("byte 8: the container says that it is 4294967295 bytes long, the file has {}", size))));
    EXPECT_THAT(fault_of("glTF" + word(2) + word(size - 4) + chunk, "model.glb"),
                HasSubstr("model.glb: byte 12: chunk 0 says that it has"));
    EXPECT_THAT(fault_of("glTF" + word(2) + word(size) + word(0xffffffffu) + "JSON" + document, "model.glb"),
                HasSubstr("model.glb: byte 12: chunk 0 says that it has 4294967295 bytes"));
}

TEST_F(HostileModelTest, APictureThatClaimsTooMuchIsNotDecoded) {
    const std::string header("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\x86\xa0\0\1\x86\xa0\x08\2\0\0\0\x27\x30\x9c\x9f", 33);
    std::ofstream(folder / "large.png", std::ios::binary) << header;
    json["images"] = {{{"uri", "large.png"}}};
    show(square());
    const Model model = read();
    ASSERT_EQ(model.images.size(), 1u);
    for (const auto decode : {+[](const ModelImage& image) { (void)picture_size(image); },
                              +[](const ModelImage& image) { (void)decode_picture(image); }}) {
        try {
            decode(model.images[0]);
            ADD_FAILURE() << "it has been taken for a picture";
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("large.png"));
        }
    }
}

TEST_F(HostileModelTest, VerticesAndWeightsThatAreNoNumbers) {
    Json primitive = square();
    primitive["attributes"]["NORMAL"] = add_accessor<float>(std::vector<float>(12, not_a_number), 5126, "VEC3", 4);
    primitive["attributes"]["COLOR_0"] = add_accessor<float>(std::vector<float>(12, not_a_number), 5126, "VEC3", 4);
    show(primitive);
    const Model model = read();
    EXPECT_THAT(model.warnings, Contains(HasSubstr("12 components are no finite numbers")));
    for (const Vertex& vertex : model.meshes.at(0).primitives.at(0).mesh.vertices) {
        EXPECT_NEAR(glm::length(unpack_normal(vertex.normal)), 1.0f, 1e-3f);
        EXPECT_EQ(vertex.colour, 0xffffffffu);
    }
    json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
        add_accessor<float>(std::vector<float>(12, not_a_number), 5126, "VEC3", 4);
    EXPECT_THAT(fault(), HasSubstr("model.gltf: /meshes/0/primitives/0/attributes/POSITION: vertex 0 lies at nan"));
}

TEST_F(HostileModelTest, WeightsThatAreNoNumbersMoveNothing) {
    show_skinned(std::vector<std::uint8_t>(16, 0), std::vector<float>(16, not_a_number));
    const Model model = read();
    EXPECT_THAT(model.warnings, Contains(HasSubstr("16 components are no finite numbers")));
    for (const ModelJoints& joints : model.meshes.at(0).primitives.at(0).joints) EXPECT_EQ(joints.weights, vec4(1, 0, 0, 0));
}

TEST_F(HostileModelTest, KeysThatAreNoTimes) {
    show_moved({0.0f, not_a_number, 1.0f});
    Model model = read();
    EXPECT_TRUE(model.animations.at(0).channels.empty());
    EXPECT_EQ(model.animations[0].length, 0.0f);
    EXPECT_THAT(model.warnings, Contains(HasSubstr("/animations/0/channels/0: its times do not rise; it is left out")));
    EXPECT_EQ(pose_at(model, model.animations[0], 1.0).nodes.size(), 1u);
    json["animations"][0]["samplers"][0]["output"] = add_accessor<float>({1, 1, 1}, 5126, "VEC3", 1);
    EXPECT_THAT(fault(), HasSubstr("model.gltf: /animations/0/channels/0: accessor 2 has 1 values; 3 keys need 3"));
}

TEST_F(HostileModelTest, JointsThatAreNotThere) {
    std::vector<float> weights(16, 0.0f);
    for (std::size_t i = 0; i < 16; i += 4) weights[i] = 1.0f;
    show_skinned(std::vector<std::uint8_t>(16, 1), weights);
    EXPECT_EQ(fault(), "");
    json["skins"][0]["joints"] = {1, 7};
    EXPECT_THAT(fault(), HasSubstr("model.gltf: /skins/0/joints/1: refers to number 7 of /nodes, which has 3"));
    json["skins"][0]["joints"] = {1};
    EXPECT_THAT(fault(), HasSubstr("model.gltf: /nodes/0/skin: mesh 0 refers to joint 1; skin 0 has 1"));
    json["skins"][0] = Json::object();
    EXPECT_THAT(fault(), HasSubstr("model.gltf: /skins/0: the skin has no \"joints\""));
}

}  // namespace
}  // namespace sl
