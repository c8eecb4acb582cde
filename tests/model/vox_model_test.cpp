// SPDX-License-Identifier: MIT
#include "engine/core/model/vox_model.h"

#include "engine/core/model/voxel_mesh.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

/// MagicaVoxel files made by a test.
class VoxModelTest : public ModelTest {
  protected:
    static std::string number(std::int32_t value) { return {reinterpret_cast<const char*>(&value), 4}; }
    static std::string text(const std::string& value) { return number(static_cast<std::int32_t>(value.size())) + value; }
    static std::string chunk(const std::string& name, const std::string& content) { return name + number(static_cast<std::int32_t>(content.size())) + number(0) + content; }
    static std::string grid(ivec3 size, const std::vector<std::array<std::uint8_t, 4>>& voxels) {
        std::string content = number(static_cast<std::int32_t>(voxels.size()));
        for (const auto& voxel : voxels) content.append(reinterpret_cast<const char*>(voxel.data()), 4);
        return chunk("SIZE", number(size.x) + number(size.y) + number(size.z)) + chunk("XYZI", content);
    }
    static std::string file(const std::string& chunks) { return "VOX " + number(150) + "MAIN" + number(0) + number(static_cast<std::int32_t>(chunks.size())) + chunks; }
    Model model_of(const std::string& bytes) {
        std::ofstream(folder / "model.vox", std::ios::binary) << bytes;
        return read_vox(folder / "model.vox");
    }
    std::string fault_of(const std::string& bytes) {
        try {
            (void)model_of(bytes);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(VoxModelTest, HiddenFacesAreLeftOutAndEqualOnesMerged) {
    const Model model = model_of(file(grid({3, 2, 2}, {{0, 0, 0, 5}, {1, 0, 0, 5}, {2, 0, 0, 9}})));
    const MeshData& mesh = model.meshes.at(0).primitives.at(0).mesh;
    // Two of the long side's four faces have two colours, so they are two quads; the ends are one each.
    EXPECT_EQ(mesh.indices.size() / 6, 4u * 2 + 2);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
        EXPECT_GT(glm::dot(glm::cross(at(1).position - at(0).position, at(2).position - at(0).position), unpack_normal(at(0).normal)), 0.0f);
    }
}

TEST_F(VoxModelTest, ZIsUp) {
    const Model model = model_of(file(grid({1, 1, 5}, {{0, 0, 4, 1}})));
    EXPECT_NEAR(bounds_of(model, 0).high.y, 5 * vox_voxel_size, 1e-5f);
}

TEST_F(VoxModelTest, ColoursComeFromThePaletteAndGlowFromMaterials) {
    std::string palette;
    for (int i = 0; i < 256; ++i) palette += std::string{static_cast<char>(i == 6 ? 255 : 0), 0, 0, static_cast<char>(255)};
    const std::string glow = number(7) + number(3) + text("_type") + text("_emit") + text("_emit") + text("0.5") + text("_flux") + text("1");
    const Model model = model_of(file(grid({1, 1, 1}, {{0, 0, 0, 7}}) + chunk("RGBA", palette) + chunk("MATL", glow)));
    const Vertex& vertex = model.meshes.at(0).primitives.at(0).mesh.vertices.at(0);
    const ModelMaterial& material = model.materials.at(vertex.material);
    EXPECT_EQ(material.base_colour, vec3(1, 0, 0));
    EXPECT_FLOAT_EQ(material.emission.x, vox_emission * 0.5f * 10.0f);
}

TEST_F(VoxModelTest, ASceneTurnsAndMovesItsModels) {
    const std::string none = number(0);
    const std::string frame = number(2) + text("_r") + text("17") + text("_t") + text("10 20 30");  // x and y change places, one of them turned
    const std::string scene = chunk("nTRN", number(0) + none + number(1) + number(-1) + number(-1) + number(1) + none) + chunk("nGRP", number(1) + none + number(1) + number(2)) +
                              chunk("nTRN", number(2) + none + number(3) + number(-1) + number(0) + number(1) + frame) + chunk("nSHP", number(3) + none + number(1) + number(0) + none);
    const Model model = model_of(file(grid({2, 2, 2}, {{0, 0, 0, 1}, {1, 1, 1, 1}}) + scene));
    ASSERT_EQ(model.nodes.size(), 1u);
    EXPECT_LT(glm::length(vec3(model.nodes[0].translation) - vox_voxel_size * vec3(10, 30, -20)), 1e-5f);
    EXPECT_NEAR(glm::length(model.nodes[0].rotation), 1.0f, 1e-5f);
}

TEST_F(VoxModelTest, FaultsNameTheByte) {
    using testing::HasSubstr;
    EXPECT_THAT(fault_of("VOX"), HasSubstr("byte 0"));
    EXPECT_THAT(fault_of("PNG and more"), HasSubstr("it is no MagicaVoxel file"));
    EXPECT_THAT(fault_of(file(grid({2, 2, 2}, {{5, 0, 0, 1}}))), HasSubstr("the voxel 5 0 0 lies outside"));
    EXPECT_THAT(fault_of(file(chunk("SIZE", number(1000) + number(1) + number(1)))), HasSubstr("a model's side of 1000"));
    EXPECT_THAT(fault_of(file(chunk("XYZI", number(0)))), HasSubstr("voxels without a size"));
    const std::string whole = file(grid({2, 2, 2}, {{0, 0, 0, 1}}));
    for (std::size_t size = 0; size + 1 < whole.size(); ++size) (void)fault_of(whole.substr(0, size));  // no crash
    const std::string none = number(0);
    EXPECT_THAT(fault_of(file(grid({1, 1, 1}, {}) + chunk("nGRP", number(0) + none + number(2) + number(0) + number(0)))), HasSubstr("stands above itself"));
    // A group of 1000 times one shape, which shows its model 1000 times.
    std::string group = number(0) + none + number(1000), shape = number(1) + none + number(1000);
    for (int i = 0; i < 1000; ++i) {
        group += number(1);
        shape += number(0) + none;
    }
    EXPECT_THAT(fault_of(file(grid({1, 1, 1}, {}) + chunk("nGRP", group) + chunk("nSHP", shape))), HasSubstr("shown more than 100000 times"));
}

TEST_F(VoxModelTest, FacesAreThoseBetweenFullAndEmptyCells) {
    VoxelGrid grid{.size = {5, 4, 3}, .cells = std::vector<std::uint8_t>(60)};
    for (std::size_t i = 0; i < grid.cells.size(); ++i) grid.cells[i] = i * i % 7 < 3 ? static_cast<std::uint8_t>(1 + i % 2) : std::uint8_t{0};
    std::size_t left = 1000;
    const MeshData mesh = voxel_mesh(grid, vec3(0.0f), left);
    EXPECT_EQ(left, 1000 - mesh.indices.size() / 6);
    float area = 0.0f;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const vec3 a = mesh.vertices[mesh.indices[i]].position, b = mesh.vertices[mesh.indices[i + 1]].position, c = mesh.vertices[mesh.indices[i + 2]].position;
        area += 0.5f * glm::length(glm::cross(b - a, c - a));
    }
    float faces = 0.0f;
    for (int z = 0; z < grid.size.z; ++z) {
        for (int y = 0; y < grid.size.y; ++y) {
            for (int x = 0; x < grid.size.x; ++x) {
                for (const ivec3 side : {ivec3(1, 0, 0), ivec3(0, 1, 0), ivec3(0, 0, 1)}) {
                    const ivec3 cell(x, y, z);
                    if (grid.at(cell) != 0) faces += (grid.at(cell + side) == 0 ? 1.0f : 0.0f) + (grid.at(cell - side) == 0 ? 1.0f : 0.0f);
                }
            }
        }
    }
    EXPECT_EQ(area, faces);
    left = 5;
    EXPECT_THROW((void)voxel_mesh({.size = {1, 1, 1}, .cells = {1}}, vec3(0.0f), left), Error) << "a cube has six";
}

}  // namespace
}  // namespace sl
