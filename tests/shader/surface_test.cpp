// SPDX-License-Identifier: MIT
// lib/surface.glsl: base colour from table, vertex and texture.
#include "shared/scene.h"
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

class SurfaceLibrary : public LibraryTest {
  protected:
    static constexpr std::uint32_t side = 4;

    /// Two layers of 4 × 4 whose texels all differ, with mips of one grey each.
    void SetUp() override {
        LibraryTest::SetUp();
        gl::Texture& textures = give_image("block_textures", {.width = side, .height = side, .layers = 2, .mips = 3, .format = Format::rgba8}, Sampling::pixel_art);
        for (std::uint32_t layer = 0; layer < 2; ++layer) {
            std::vector<glm::u8vec4> texels(std::size_t{side} * side);
            for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = texel(layer, i);
            upload(textures, texels, layer, 0);
            upload(textures, std::vector<glm::u8vec4>(4, glm::u8vec4(20)), layer, 1);
            upload(textures, std::vector<glm::u8vec4>(1, glm::u8vec4(90)), layer, 2);
        }
        MaterialParams plain{}, textured{};
        plain.base_colour = vec4(0.8f, 0.4f, 0.2f, 1);
        plain.texture.x = no_texture;
        textured.base_colour = vec4(0.5f, 1.0f, 0.25f, 1);
        textured.texture.x = 1;
        materials = {plain, textured};
        give("Materials", materials);
    }

    static glm::u8vec4 texel(std::uint32_t layer, std::size_t i) { return glm::u8vec4(10 * i + layer, 255 - 10 * i, 7 * i + 100 * layer, 255); }

    /// The base colour at each of 4 × 4 pixels; `repeats` of the texture lie side by side. Odd columns have no texture, so
    /// that within each quad of fragments materials differ.
    std::vector<vec4> colours(int repeats) {
        write("surface.frag", fmt::format("#include \"lib/surface.glsl\"\nin vec2 ndc;\nout vec4 colour;\nvoid main() {{\n"
                              "    MaterialParams material = materials[int(gl_FragCoord.x) % 2 == 0 ? 1 : 0];\n"
                              "    colour = vec4(base_colour_of(material, (ndc * 0.5 + 0.5) * {}.0, vec3(1.0, 0.5, 0.75)), 1.0);\n}}\n", repeats));
        return draw("lib/fullscreen.vert", "surface.frag", side, side, [](const gl::Program&) { glDrawArrays(GL_TRIANGLES, 0, 3); });
    }

    std::vector<MaterialParams> materials;
    const vec3 tint{1.0f, 0.5f, 0.75f};
};

constexpr float byte_precision = 1e-6f;  // products of exact bytes over 255: float rounding alone

TEST_F(SurfaceLibrary, BaseColourIsTableTimesVertexTimesTexture) {
    const auto pixels = colours(1);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const vec3 expected = i % 2 == 0 ? vec3(materials[1].base_colour) * tint * vec3(texel(1, i)) / 255.0f : vec3(materials[0].base_colour) * tint;
        expect_close(pixels[i], vec4(expected, 1), byte_precision, i);
    }
}

TEST_F(SurfaceLibrary, TextureSeenFromAfarIsItsMip) {
    // Derivatives are of the pixel, also where its neighbour's material has no texture.
    for (const auto& [repeats, grey] : {std::pair{2, 20.0f}, std::pair{4, 90.0f}}) {
        const auto pixels = colours(repeats);
        for (std::size_t i = 0; i < pixels.size(); i += 2) {
            expect_close(pixels[i], vec4(vec3(materials[1].base_colour) * tint * grey / 255.0f, 1), byte_precision, i);
        }
    }
}

}  // namespace
}  // namespace sl
