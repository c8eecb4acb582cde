// SPDX-License-Identifier: MIT
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

using testing::HasSubstr;

vec3 corner(const MeshData& mesh, std::size_t i) { return mesh.vertices[mesh.indices[i]].position; }

TEST_F(ModelTest, ASquareHasFlatNormalsWhereItTellsNone) {
    show(square());
    const Model model = read();
    ASSERT_EQ(model.meshes.size(), 1u);
    const MeshData& mesh = model.meshes[0].primitives.at(0).mesh;
    EXPECT_EQ(mesh.indices.size(), 6u);
    for (const Vertex& vertex : mesh.vertices) EXPECT_EQ(unpack_normal(vertex.normal), vec3(0, 0, 1));
    EXPECT_EQ(mesh.bounds.high, vec3(1, 1, 0));
    EXPECT_THAT(model.warnings, testing::IsEmpty());
}

TEST_F(ModelTest, StripsAndFansAreTrianglesThatFaceAsTheFirst) {
    const std::vector<float> zigzag{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, round{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0};
    show({{"attributes", {{"POSITION", add_positions(zigzag)}}}, {"mode", 5}});
    show({{"attributes", {{"POSITION", add_positions(round)}}}, {"mode", 6}});
    for (const ModelMesh& mesh : read().meshes) {
        const MeshData& data = mesh.primitives.at(0).mesh;
        ASSERT_EQ(data.indices.size(), 9u);
        for (std::size_t i = 0; i < 9; i += 3) EXPECT_GT(glm::cross(corner(data, i + 1) - corner(data, i), corner(data, i + 2) - corner(data, i)).z, 0.0f);
    }
}

TEST_F(ModelTest, CamerasSeeInPerspectiveOrOrthographically) {
    show(square());
    json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.2}}}},
                       {{"type", "orthographic"}, {"orthographic", {{"xmag", 4}, {"ymag", 3}, {"znear", 0}, {"zfar", 10}}}}};
    const Model model = read();
    ASSERT_EQ(model.cameras.size(), 2u);
    EXPECT_EQ(model.cameras[0].fov_y, 0.5f);
    EXPECT_EQ(model.cameras[0].height, 0.0f);
    EXPECT_EQ(model.cameras[1].height, 6.0f);
    EXPECT_GT(model.cameras[1].near, 0.0f);
    EXPECT_THAT(model.warnings, testing::IsEmpty());
}

TEST_F(ModelTest, PointsAndLinesAreToldAndLeftOut) {
    show({{"attributes", {{"POSITION", add_positions({0, 0, 0, 1, 0, 0})}}}, {"mode", 1}});
    const Model model = read();
    EXPECT_TRUE(model.meshes.at(0).primitives.empty());
    EXPECT_THAT(model.warnings, testing::ElementsAre(HasSubstr("/meshes/0/primitives/0: points and lines")));
}

TEST_F(ModelTest, TwoSidedTrianglesAreThereTwice) {
    json["materials"].push_back({{"doubleSided", true}});
    show(square({{"material", 0}}));
    const MeshData mesh = read().meshes.at(0).primitives.at(0).mesh;
    EXPECT_TRUE(mesh.both_sides);
    ASSERT_EQ(mesh.indices.size(), 12u);
    EXPECT_LT(glm::cross(corner(mesh, 7) - corner(mesh, 6), corner(mesh, 8) - corner(mesh, 6)).z, 0.0f);
    EXPECT_EQ(unpack_normal(mesh.vertices[mesh.indices[6]].normal), vec3(0, 0, -1));
}

TEST_F(ModelTest, NormalizedIntegersAndSparseElementsAreRead) {
    Json primitive = square();
    primitive["attributes"]["COLOR_0"] = add_accessor<std::uint8_t>({255, 0, 0, 255, 0, 51, 0, 255, 0, 0, 255, 0, 255, 255, 255, 255}, 5121, "VEC4", 4, {{"normalized", true}});
    const int indices = add_accessor<std::uint8_t>({2}, 5121, "SCALAR", 1), values = add_accessor<float>({5, 6, 7}, 5126, "VEC3", 1);
    const auto view = [&](int accessor) { return json["accessors"][static_cast<std::size_t>(accessor)]["bufferView"]; };
    Json& positions = json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    positions["sparse"] = {{"count", 1}, {"indices", {{"bufferView", view(indices)}, {"componentType", 5121}}}, {"values", {{"bufferView", view(values)}}}};
    positions["max"] = {5, 6, 7};
    show(primitive);
    const MeshData mesh = read().meshes.at(0).primitives.at(0).mesh;
    EXPECT_EQ(mesh.bounds.high, vec3(5, 6, 7));
    EXPECT_EQ(mesh.vertices[mesh.indices[1]].colour, 0xff003300u);
}

TEST_F(ModelTest, NodesComeAfterTheirParentsAndMatricesAreTakenApart) {
    json["nodes"] = {{{"name", "child"}, {"translation", {0, 0, 3}}}, {{"name", "root"}, {"children", {0}}, {"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, -2, 0, 4, 5, 6, 1}}}};
    json["scenes"][0]["nodes"] = {1};
    const Model model = read();
    ASSERT_EQ(model.nodes.size(), 2u);
    EXPECT_EQ(model.nodes[0].name, "root");
    EXPECT_EQ(model.nodes[1].parent, 0);
    const auto places = places_of(model, 0);
    const vec3 child((*places[1])[3]);
    EXPECT_LT(glm::length(child - vec3(4, 5, 0)), 1e-5f) << "a quarter turn, mirrored and doubled";
    EXPECT_LT(glm::determinant(mat3(*places[0])), 0.0f);
}

TEST_F(ModelTest, LightsCamerasAndGlowKeepTheirUnits) {
    json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_emissive_strength"};
    json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"intensity", 250.0}, {"color", {1, 0.5, 0}}, {"range", 7.0}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}}};
    json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.5}}}}};
    json["materials"] = {{{"emissiveFactor", {1, 0.5, 0}}, {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 400}}}}}}};
    json["nodes"] = {{{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
    json["scenes"][0]["nodes"] = {0};
    const Model model = read();
    EXPECT_EQ(model.nodes[0].light, 0);
    EXPECT_EQ(model.lights[0].intensity, 250.0f);
    EXPECT_EQ(model.lights[0].range, 7.0f);
    EXPECT_FLOAT_EQ(model.lights[0].outer_cone, 0.3f);
    EXPECT_FLOAT_EQ(model.cameras[0].fov_y, 0.7f);
    EXPECT_EQ(model.materials[0].emission, vec3(400, 200, 0));
}

TEST_F(ModelTest, AnUnknownExtensionIsToldAndARequiredOneRefused) {
    json["extensionsUsed"] = {"ACME_glitter"};
    show(square());
    EXPECT_THAT(read().warnings, testing::ElementsAre(HasSubstr("ACME_glitter")));
    json["extensionsRequired"] = {"ACME_glitter"};
    EXPECT_THAT(fault(), HasSubstr("model.gltf: /extensionsRequired/0: the file needs 'ACME_glitter'"));
}

TEST_F(ModelTest, OnlyAHundredWarningsAreKept) {
    for (int i = 0; i < 250; ++i) json["extensionsUsed"].push_back(fmt::format("ACME_{}", i));
    show(square());
    const Model model = read();
    ASSERT_EQ(model.warnings.size(), 101u);
    EXPECT_EQ(model.warnings.back(), "and 150 more");
}

TEST_F(ModelTest, APictureThatIsNotReadIsTold) {
    json["images"] = {{{"uri", "none.png"}}, {{"uri", "../outside.png"}}, {{"uri", "http://x/a.png"}}};
    show(square());
    const Model model = read();
    EXPECT_EQ(model.images.size(), 3u);
    for (const char* warning : {"none.png: there is no such file", "/images/1/uri: ../outside.png: it lies outside the model's folder", "/images/2/uri: only files beside the model are read",
                                "/images/0: the picture cannot be read, and is white", "/images/2: the picture cannot be read"}) {
        EXPECT_THAT(model.warnings, testing::Contains(HasSubstr(warning)));
    }
}

TEST_F(ModelTest, FilesOutsideTheFolderAreRefusedUnlessAllowed) {
    show(square());
    const auto path = write();
    const auto outside = folder.parent_path() / fmt::format("{}_outside.bin", folder.filename().string());
    std::filesystem::rename(folder / "data.bin", outside);
    // What is no file beside the model is not looked for: the format does not ask for it.
    for (const std::string& way : {outside.string(), "file://" + outside.string()}) {
        json["buffers"][0]["uri"] = way;
        std::ofstream(path) << json.dump();
        const Model model = read_gltf(path, {.files_anywhere = true});
        EXPECT_TRUE(model.meshes.at(0).primitives.empty()) << way;
        EXPECT_THAT(model.warnings, testing::ElementsAre(HasSubstr("/buffers/0/uri: only files beside"), HasSubstr("/meshes/0/primitives/0: it has no positions")));
    }
    json["buffers"][0]["uri"] = "../" + outside.filename().string();
    std::ofstream(path) << json.dump();
    EXPECT_THROW((void)read_gltf(path), Error);
    EXPECT_EQ(read_gltf(path, {.files_anywhere = true}).meshes.size(), 1u);
    // A link leads out just as well.
    std::filesystem::create_symlink(outside, folder / "link.bin");
    json["buffers"][0]["uri"] = "link.bin";
    std::ofstream(path) << json.dump();
    EXPECT_THROW((void)read_gltf(path), Error);
    std::filesystem::remove(outside);
}

TEST_F(ModelTest, FaultsNameFileAndPlace) {
    show(square());
    const Json good = json;
    const auto with = [&](const Json::json_pointer& place, const Json& value) {
        json = good;
        json[place] = value;
        return fault();
    };
    using Place = Json::json_pointer;
    EXPECT_THAT(with(Place("/accessors/0/count"), 4000), HasSubstr("model.gltf: /accessors/0: ends at byte 48000 of buffer view 0, which has 48"));
    EXPECT_THAT(with(Place("/bufferViews/0/byteLength"), 1000000000), HasSubstr("model.gltf: /bufferViews/0: bytes 0 to 1000000000 lie outside buffer 0"));
    EXPECT_THAT(with(Place("/meshes/0/primitives/0/indices"), 7), HasSubstr("model.gltf: /meshes/0/primitives/0/indices: refers to number 7"));
    EXPECT_THAT(with(Place("/nodes/0/children"), Json{0}), HasSubstr("/nodes/0: the node hangs on itself"));
    EXPECT_THAT(with(Place("/scenes/0/nodes"), Json{5}), HasSubstr("/scenes/0/nodes/0: refers to number 5 of /nodes"));
    std::filesystem::remove(folder / "data.bin");
    json = good;
    json["buffers"] = {{{"byteLength", buffer_.size()}, {"uri", "missing.bin"}}};
    buffer_.clear();
    EXPECT_THAT(fault(), testing::MatchesRegex(".*model.gltf: /buffers/0/uri: .*missing.bin: there is no such file"));
}

TEST_F(ModelTest, WhatIsNoModelIsRefused) {
    for (const std::string& text : {std::string(), std::string("{"), std::string("[]"), std::string("glTF"), std::string("glTF\2\0\0\0\xff\xff\xff\xff", 12), std::string("{\"asset\":{\"version\":\"1.0\"}}")}) {
        std::ofstream(folder / "bad.glb", std::ios::binary) << text;
        EXPECT_THROW((void)read_gltf(folder / "bad.glb"), Error) << text;
    }
    EXPECT_THROW((void)read_gltf(folder / "not_there.glb"), Error);
    EXPECT_THROW((void)read_gltf(folder), Error);
    EXPECT_THROW((void)read_gltf("/dev/zero"), Error);
}

TEST_F(ModelTest, ChannelsKnowTheirKeys) {
    const int times = add_accessor<float>({0, 1, 3}, 5126, "SCALAR", 3, {{"min", {0}}, {"max", {3}}}), turns = add_accessor<float>({0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, -1}, 5126, "VEC4", 3);
    json["nodes"] = {{{"name", "turned"}}};
    json["scenes"][0]["nodes"] = {0};
    json["animations"] = {{{"samplers", {{{"input", times}, {"output", turns}}}}, {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}};
    const Model model = read();
    ASSERT_EQ(model.animations.at(0).channels.size(), 1u);
    EXPECT_EQ(model.animations[0].length, 3.0f);
    EXPECT_EQ(model.animations[0].channels[0].width, 4u);
}

}  // namespace
}  // namespace sl
