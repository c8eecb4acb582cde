// SPDX-License-Identifier: MIT
// Normal textures, and pictures that lie each in its own way: what is drawn is what is traced.
#include "tests/frames_small/square_model.h"

namespace sl {
namespace {

class ReliefModelTest : public SquareModelTest {
  protected:
    /// Directions that lean to all sides, others in each square.
    static vec3 lean(std::uint32_t x, std::uint32_t y) {
        const float angle = 0.7f + 2.1f * static_cast<float>(x) + 1.3f * static_cast<float>(y), tilt = 0.15f + 0.1f * static_cast<float>((x + y) % 4);
        return {std::sin(tilt) * std::cos(angle), std::sin(tilt) * std::sin(angle), std::cos(tilt)};
    }
    void add_normals() {
        add_picture("normals.png", [](std::uint32_t x, std::uint32_t y) { return lean(x, y) * 0.5f + 0.5f; });
    }
    /// Normals that are drawn, and that rays find, against those that the file asks for; returns how far off they are at most.
    float most_off(const std::filesystem::path& file, vec3 eye, const std::function<vec3(std::uint32_t, std::uint32_t)>& expected) {
        Seen seen = drawn(file, eye);
        const Traced rays = traced(file, eye);
        float most = 0.0f;
        for (std::uint32_t y = 0; y < 4; ++y) {
            for (std::uint32_t x = 0; x < 4; ++x) {
                most = std::max(most, glm::length(seen.at("normal", x, y) - expected(x, y)));
                most = std::max(most, glm::length(rays.tracer->first_surface({place_of(x), place_of(y)}).normal - expected(x, y)));
            }
        }
        return most;
    }
    /// Two bytes of a picture lean this far: 2 / 255 / 2 each, and a little for what is smoothed on the way.
    static constexpr float byte = 0.012f;
};

TEST_F(ReliefModelTest, NormalsLeanAsTheTextureSays) {
    add_normals();
    show_square({{"normalTexture", {{"index", 0}}}});
    EXPECT_LT(most_off(write(), vec3(0.5f, 0.5f, 1), lean), byte);
    json["materials"][0]["normalTexture"]["scale"] = 2.0;
    const auto twice = [](std::uint32_t x, std::uint32_t y) { return glm::normalize(lean(x, y) * vec3(2, 2, 1)); };
    EXPECT_LT(most_off(write("scaled.gltf"), vec3(0.5f, 0.5f, 1), twice), 2 * byte);
}

TEST_F(ReliefModelTest, MirroredAndStretchedTheyLeanWithTheirSurface) {
    add_normals();
    // Seen in a mirror, right is left: the square stays where it is, its texture and its lean are mirrored.
    show_square({{"normalTexture", {{"index", 0}}}}, {{"scale", {-1, 1, 3}}, {"translation", {1, 0, 0}}});
    const auto mirrored = [](std::uint32_t x, std::uint32_t y) { return lean(3 - x, y) * vec3(-1, 1, 1); };
    EXPECT_LT(most_off(write(), vec3(0.5f, 0.5f, 1), mirrored), byte);
}

TEST_F(ReliefModelTest, ABackIsTheReliefFromBehind) {
    add_normals();
    show_square({{"normalTexture", {{"index", 0}}}, {"doubleSided", true}});
    const auto behind = [](std::uint32_t x, std::uint32_t y) { return -lean(3 - x, y); };
    EXPECT_LT(most_off(write(), vec3(0.5f, 0.5f, -1), behind), byte);
}

TEST_F(ReliefModelTest, EachPictureLiesInItsOwnWay) {
    add_picture("colours.png", [](std::uint32_t x, std::uint32_t y) { return vec3(x % 2, y % 2, 0); });
    add_picture("glow.png", [](std::uint32_t x, std::uint32_t y) { return vec3(x / 2, y / 2, 1); });
    add_normals();
    Json primitive = square({{"material", 0}});
    // The second coordinates show the picture upside down.
    primitive["attributes"]["TEXCOORD_1"] = add_accessor<float>({1, 0, 0, 0, 0, 1, 1, 1}, 5126, "VEC2", 4);
    json["extensionsUsed"] = {"KHR_texture_transform"};
    json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}},
                          {"emissiveTexture", {{"index", 1}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}}},
                          {"emissiveFactor", {1, 1, 1}},
                          {"normalTexture", {{"index", 2}, {"texCoord", 1}}}}};
    show(primitive);
    const auto file = write();
    // Upside down, right is left and up is down.
    const auto turned = [](std::uint32_t x, std::uint32_t y) { return lean(3 - x, 3 - y) * vec3(-1, -1, 1); };
    EXPECT_LT(most_off(file, vec3(0.5f, 0.5f, 1), turned), byte);
    Seen seen = drawn(file, vec3(0.5f, 0.5f, 1));
    const Traced rays = traced(file, vec3(0.5f, 0.5f, 1));
    for (std::uint32_t y = 0; y < 4; ++y) {
        for (std::uint32_t x = 0; x < 4; ++x) {
            const vec3 colour(x % 2, y % 2, 0), glow(x % 2, y % 2, 1);
            EXPECT_EQ(seen.at("albedo", x, y), colour);
            EXPECT_EQ(rays.tracer->first_surface({place_of(x), place_of(y)}).albedo, colour);
            // Between the middles of texels: the glow is seen at half its size.
            EXPECT_LT(glm::length(seen.at("direct", x, y) - rays.tracer->sample({place_of(x), place_of(y)}, 0).direct), 0.02f);
        }
    }
    EXPECT_LT(glm::length(seen.at("direct", 0, 0) - vec3(0, 0, 1)), 0.02f);
    EXPECT_LT(glm::length(seen.at("direct", 1, 1) - vec3(1, 1, 1)), 0.02f);
}

TEST_F(ReliefModelTest, LightIsReflectedByTheLeanAndNoneComesThroughFromBehind) {
    add_normals();
    json["extensionsUsed"] = {"KHR_lights_punctual"};
    json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}, {"intensity", 1000.0}}};
    show_square({{"normalTexture", {{"index", 0}, {"scale", 2.0}}}, {"pbrMetallicRoughness", matte}});
    // Turned round y: light that comes from the right, in front of the surface by 0.2 rad or behind it by as much.
    for (const float elevation : {0.2f, -0.2f}) {
        const float half = 0.5f * (0.5f * pi - elevation);
        json["nodes"][1] = {{"rotation", {0, std::sin(half), 0, std::cos(half)}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
        json["scenes"][0]["nodes"] = {0, 1};
        const auto file = write(elevation > 0.0f ? "front.gltf" : "behind.gltf");
        Seen seen = drawn(file, vec3(0.5f, 0.5f, 1));
        const Traced rays = traced(file, vec3(0.5f, 0.5f, 1));
        float least = 1e9f, most = 0.0f;
        for (std::uint32_t y = 0; y < 4; ++y) {
            for (std::uint32_t x = 0; x < 4; ++x) {
                const vec3 truth = rays.tracer->sample({place_of(x), place_of(y)}, 0).direct, here = seen.at("direct", x, y);
                EXPECT_NEAR(here.x, truth.x, 0.03f * truth.x + 1.0f) << x << " " << y;
                least = std::min(least, here.x);
                most = std::max(most, here.x);
            }
        }
        if (elevation > 0.0f) {
            EXPECT_GT(most, 3.0f * least + 100.0f) << "what leans towards the light is brighter";
        } else {
            EXPECT_EQ(most, 0.0f);
        }
    }
}

TEST_F(ReliefModelTest, FacetsFindTheirLightUnderARelief) {
    // Steep enough for other sides of the lattice, were it asked with the normal that light sees.
    add_picture("normals.png", [](std::uint32_t x, std::uint32_t y) { return (x + y) % 2 == 0 ? vec3(1.0f, 0.5f, 0.55f) : vec3(0.0f, 0.5f, 0.55f); });
    show_square({{"normalTexture", {{"index", 0}}}, {"pbrMetallicRoughness", matte}});
    Seen seen = drawn(write(), vec3(0.5f, 0.5f, 1), "facets");
    // A square under the open sky: as much light everywhere.
    const float middle = seen.at("irradiance", 1, 1).x;
    EXPECT_GT(middle, 0.0f);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) EXPECT_NEAR(seen.layers.at("irradiance").pixel(x, y)[0], middle, 0.05f * middle) << x << " " << y;
    }
}

}  // namespace
}  // namespace sl
