// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_expansion.h"
#include "engine/core/model/gltf_material.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

using testing::HasSubstr;

/// Valid files, made in memory, in which much refers to the same few numbers.
class SharedDataTest : public ModelTest {
  protected:
    static constexpr std::size_t vertices = 50'000;

    void SetUp() override {
        ModelTest::SetUp();
        std::vector<float> numbers(3 * vertices);
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(i % 97);
        positions_ = add_positions(numbers);
        std::vector<std::uint32_t> corners(6 * vertices);
        for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i % vertices);
        indices_ = add_accessor(corners, 5125, "SCALAR", corners.size());
    }

    Json primitive(Json more = Json::object()) const {
        more["attributes"]["POSITION"] = positions_;
        more["attributes"]["NORMAL"] = positions_;
        more["indices"] = indices_;
        return more;
    }
    static Json repeated(const Json& one, std::size_t count) { return std::vector<Json>(count, one); }
    void add_nodes(std::size_t count) {
        json["nodes"] = repeated({{"mesh", 0}}, count);
        for (std::size_t i = 0; i < count; ++i) json["scenes"][0]["nodes"].push_back(i);
    }

    std::string container() const {
        std::string binary = buffer_, document;
        binary.resize((binary.size() + 3) / 4 * 4);
        Json whole = json;
        whole["buffers"] = {{{"byteLength", binary.size()}}};
        document = whole.dump();
        document.resize((document.size() + 3) / 4 * 4, ' ');
        const auto word = [](std::size_t value) {
            const auto number = static_cast<std::uint32_t>(value);
            return std::string(reinterpret_cast<const char*>(&number), sizeof number);
        };
        const std::string chunks = word(document.size()) + "JSON" + document + word(binary.size()) + std::string("BIN\0", 4) + binary;
        return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
    }
    /// Why the file is not read; empty where it may be.
    std::string refusal() const {
        const std::string bytes = container();
        const GltfChecked file = check_gltf(std::as_bytes(std::span(bytes)), {});
        for (const GltfFault& fault : file.faults.list()) {
            if (fault.fatal) return fault.message;
        }
        try {
            GltfReader reader(file);
            check_gltf_expansion(file, gltf_materials(reader));
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    int positions_ = 0, indices_ = 0;
};

TEST_F(SharedDataTest, OfManyMeshesAndPrimitives) {
    json["meshes"] = repeated({{"primitives", {primitive()}}}, 20'000);
    EXPECT_THAT(refusal(), HasSubstr("MB by using the same numbers many times, which take 3 MB once; it may take 262 MB"));
    json["meshes"] = {{{"primitives", repeated(primitive(), 20'000)}}};
    EXPECT_THAT(refusal(), HasSubstr("by using the same numbers many times"));
    // Each has corners of its own, and few of them.
    json["meshes"] = Json::array();
    for (int i = 0; i < 1'000; ++i) {
        Json few = primitive();
        few["indices"] = add_accessor<std::uint32_t>({0, 1, 2}, 5125, "SCALAR", 3);
        json["meshes"].push_back({{"primitives", {few}}});
    }
    EXPECT_THAT(refusal(), HasSubstr("by using the same numbers many times"));
}

TEST_F(SharedDataTest, OfFlatMeshesThatAreSeenFromBothSides) {
    json["materials"] = {{{"doubleSided", true}}};
    Json flat = primitive({{"material", 0}});
    flat["attributes"].erase("NORMAL");
    json["meshes"] = repeated({{"primitives", {flat}}}, 1);
    EXPECT_EQ(refusal(), "") << "it takes much, but only once";
    json["meshes"] = repeated({{"primitives", {flat}}}, 30);
    EXPECT_THAT(refusal(), HasSubstr("by using the same numbers many times"));
}

TEST_F(SharedDataTest, OfMorphTargetsAndNodesThatMorph) {
    json["meshes"] = {{{"primitives", {primitive({{"targets", repeated({{"POSITION", positions_}}, 20'000)}})}}}};
    EXPECT_THAT(refusal(), HasSubstr("by using the same numbers many times"));
    json["meshes"] = {{{"primitives", {primitive({{"targets", {{{"POSITION", positions_}}}}})}}}};
    add_nodes(3);
    EXPECT_EQ(refusal(), "");
    add_nodes(20'000);
    EXPECT_THAT(refusal(), HasSubstr("by using the same numbers many times"));
}

TEST_F(SharedDataTest, OfSkinsAndAnimations) {
    const int matrices = add_accessor(std::vector<float>(16 * 10'000, 0.0f), 5126, "MAT4", 10'000);
    json["nodes"] = Json::array({Json::object()});
    json["skins"] = repeated({{"joints", {0}}, {"inverseBindMatrices", matrices}}, 10'000);
    EXPECT_THAT(refusal(), HasSubstr("by using the same numbers many times"));
    json.erase("skins");
    std::vector<float> times(vertices);
    for (std::size_t i = 0; i < vertices; ++i) times[i] = static_cast<float>(i);
    const int input = add_accessor(times, 5126, "SCALAR", vertices, {{"min", {0}}, {"max", {vertices - 1}}});
    const Json sampler{{"input", input}, {"output", positions_}}, channel{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}};
    json["animations"] = repeated({{"samplers", {sampler}}, {"channels", {channel}}}, 10'000);
    EXPECT_THAT(refusal(), HasSubstr("by using the same numbers many times"));
}

TEST_F(SharedDataTest, OfAccessorsThatOverlap) {
    json["meshes"] = Json::array();
    const Json view = json["accessors"][static_cast<std::size_t>(positions_)]["bufferView"], low = json["accessors"][0]["min"], high = json["accessors"][0]["max"];
    for (std::size_t i = 0; i < 200; ++i) {
        json["accessors"].push_back({{"bufferView", view}, {"byteOffset", 12 * i}, {"componentType", 5126}, {"type", "VEC3"}, {"count", vertices - i}, {"min", low}, {"max", high}});
        json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", json["accessors"].size() - 1}}}}}}});
    }
    EXPECT_THAT(refusal(), HasSubstr("by using the same numbers many times"));
    for (std::size_t i = 0; i < 2'000; ++i) json["accessors"].push_back(json["accessors"].back());
    EXPECT_THAT(refusal(), HasSubstr("bytes together, of"));
}

/// As programs write them: variants in other materials, forests, and animations whose channels have the same times.
TEST_F(SharedDataTest, ThatIsUsualIsRead) {
    json["materials"] = repeated(Json::object(), 20);
    for (int i = 0; i < 20; ++i) json["meshes"].push_back({{"primitives", {primitive({{"material", i}})}}});
    add_nodes(10'000);
    std::vector<float> times(1'000);
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<float>(i);
    const int input = add_accessor(times, 5126, "SCALAR", times.size(), {{"min", {0}}, {"max", {999}}});
    const int output = add_accessor(std::vector<float>(3 * times.size(), 1.0f), 5126, "VEC3", times.size());
    Json channels = Json::array();
    for (int i = 0; i < 300; ++i) channels.push_back({{"sampler", 0}, {"target", {{"node", i}, {"path", "scale"}}}});
    json["animations"] = {{{"samplers", {{{"input", input}, {"output", output}}}}, {"channels", channels}}};
    EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace sl
