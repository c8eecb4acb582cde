// SPDX-License-Identifier: MIT
// Tangents: read, made, turned with backs; and which texture coordinates a mesh brings.
#include "engine/core/image.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

class TangentsTest : public ModelTest {
  protected:
    /// A material with a normal texture and more.
    void add_material(const Json& normal_texture = Json::object(), Json more = Json::object()) {
        json["images"] = {{{"uri", "picture.png"}}};
        write_png(folder / "picture.png", Image(1, 1, 4));
        json["textures"] = {{{"source", 0}}};
        Json texture{{"index", 0}};
        texture.update(normal_texture);
        more["normalTexture"] = texture;
        json["materials"].push_back(more);
    }
    Json with_normals(Json primitive) {
        primitive["attributes"]["NORMAL"] = add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 4);
        return primitive;
    }
    MeshData mesh() {
        model = read();
        return model.meshes.at(0).primitives.at(0).mesh;
    }
    /// How far apart unit vectors may be that were packed.
    static constexpr float packed = 1e-4f;
    static void expect_all(const MeshData& mesh, vec3 tangent, float hand) {
        ASSERT_EQ(mesh.pictured.size(), mesh.vertices.size());
        for (const PicturedVertex& vertex : mesh.pictured) {
            EXPECT_LT(glm::length(unpack_normal(vertex.tangent) - tangent), packed);
            EXPECT_EQ(vertex.hand, hand);
        }
    }
    Model model;
};

TEST_F(TangentsTest, WhereNoneAreToldTheyLieAsTheTextureDoes) {
    add_material();
    show(with_normals(square({{"material", 0}})));
    expect_all(mesh(), vec3(1, 0, 0), 1.0f);
    EXPECT_EQ(model.meshes[0].primitives[0].mesh.vertices.size(), 4u) << "nothing is mirrored, so no vertex is parted";
}

TEST_F(TangentsTest, ATransformOfTheTextureTurnsThem) {
    // Coordinates turn counter-clockwise, so the picture turns clockwise: its right lies below.
    add_material({{"extensions", {{"KHR_texture_transform", {{"rotation", 1.57079633}}}}}});
    show(square({{"material", 0}}));
    const vec3 tangent = unpack_normal(mesh().pictured.at(0).tangent);
    EXPECT_LT(glm::length(tangent - vec3(0, -1, 0)), packed) << tangent.x << " " << tangent.y;
    EXPECT_EQ(model.meshes[0].primitives[0].mesh.pictured[0].hand, 1.0f);
}

TEST_F(TangentsTest, MirroredTexturesHaveTheOtherHandAndShareNoVertices) {
    add_material();
    // Two squares side by side that share an edge; u runs towards it from both sides.
    Json primitive{{"material", 0}};
    primitive["attributes"] = {{"POSITION", add_positions({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0})},
                               {"NORMAL", add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 6)},
                               {"TEXCOORD_0", add_accessor<float>({0, 1, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0}, 5126, "VEC2", 6)}};
    primitive["indices"] = add_accessor<std::uint16_t>({0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}, 5123, "SCALAR", 12);
    show(primitive);
    const MeshData all = mesh();
    EXPECT_EQ(all.vertices.size(), 8u);
    EXPECT_EQ(all.pictured.size(), 8u);
    for (std::size_t i = 0; i < all.indices.size(); ++i) {
        const float side = i < 6 ? 1.0f : -1.0f;
        const PicturedVertex& vertex = all.pictured[all.indices[i]];
        EXPECT_LT(glm::length(unpack_normal(vertex.tangent) - vec3(side, 0, 0)), packed) << "corner " << i;
        EXPECT_EQ(vertex.hand, side) << "corner " << i;
    }
}

TEST_F(TangentsTest, WithoutTextureCoordinatesTheyStillLieAlongTheSurface) {
    add_material();
    Json primitive = square({{"material", 0}});
    primitive["attributes"].erase("TEXCOORD_0");
    show(primitive);
    for (const PicturedVertex& vertex : mesh().pictured) EXPECT_NEAR(unpack_normal(vertex.tangent).z, 0.0f, packed);
}

TEST_F(TangentsTest, ThoseOfTheFileAreTakenWhereItTellsNormals) {
    add_material();
    Json primitive = square({{"material", 0}});
    primitive["attributes"]["TANGENT"] = add_accessor<float>({0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1}, 5126, "VEC4", 4);
    show(primitive);
    expect_all(mesh(), vec3(1, 0, 0), 1.0f);  // made: the format has them ignored without normals
    json["meshes"][0]["primitives"][0] = with_normals(primitive);
    expect_all(mesh(), vec3(0, 1, 0), -1.0f);
}

TEST_F(TangentsTest, ABackLeansTheOppositeWay) {
    add_material(Json::object(), {{"doubleSided", true}});
    show(square({{"material", 0}}));
    const MeshData both = mesh();
    ASSERT_EQ(both.pictured.size(), both.vertices.size());
    for (std::size_t i = 0; i < both.vertices.size() / 2; ++i) {
        const std::size_t back = i + both.vertices.size() / 2;
        const vec3 tangent = unpack_normal(both.pictured[back].tangent), normal = unpack_normal(both.vertices[back].normal);
        EXPECT_LT(glm::length(tangent - vec3(-1, 0, 0)), packed);
        EXPECT_LT(glm::length(both.pictured[back].hand * glm::cross(normal, tangent) - vec3(0, -1, 0)), packed);
    }
}

TEST_F(TangentsTest, MeshesBringTheTwoCoordinatesThatTheirMaterialReads) {
    add_material({{"texCoord", 0}}, {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 2}}}}},
                                     {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}}});
    Json primitive = square({{"material", 0}});
    primitive["attributes"]["TEXCOORD_1"] = add_accessor<float>({5, 5, 5, 5, 5, 5, 5, 5}, 5126, "VEC2", 4);
    primitive["attributes"]["TEXCOORD_2"] = add_accessor<float>({7, 7, 7, 7, 7, 7, 7, 7}, 5126, "VEC2", 4);
    show(primitive);
    const MeshData read_mesh = mesh();
    const ModelMaterial& material = model.materials.at(0);
    EXPECT_THAT(material.uv_sets, ElementsAre(2u, 0u));
    EXPECT_FALSE(material.base_colour_texture.second_uv);
    EXPECT_TRUE(material.normal_texture.second_uv);
    EXPECT_THAT(model.warnings, Each(HasSubstr("a third set of texture coordinates (1)")));
    EXPECT_EQ(model.warnings.size(), 1u);
    for (const Vertex& vertex : read_mesh.vertices) EXPECT_EQ(vertex.uv, vec2(7));
    EXPECT_LE(read_mesh.pictured.at(0).uv.x, 1.0f);
    expect_all(read_mesh, vec3(1, 0, 0), 1.0f);
}

TEST_F(TangentsTest, AMeshWithOneSetAndNoNormalTextureCarriesNothingMore) {
    add_material();
    json["materials"][0] = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}};
    Json primitive = square({{"material", 0}});
    primitive["attributes"]["TEXCOORD_1"] = add_accessor<float>({5, 5, 5, 5, 5, 5, 5, 5}, 5126, "VEC2", 4);
    show(primitive);
    const MeshData one = mesh();
    EXPECT_TRUE(one.pictured.empty());
    for (const Vertex& vertex : one.vertices) EXPECT_EQ(vertex.uv, vec2(5));
    EXPECT_THAT(model.warnings, testing::IsEmpty());
}

}  // namespace
}  // namespace sl
