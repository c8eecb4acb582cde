// SPDX-License-Identifier: MIT
// lib/gbuffer.glsl: point_at gives back the positions and normals that the CPU wrote into depth and normal.
#include <random>

#include "shared/octahedral.h"
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

TEST_F(LibraryTest, PointAtGivesBackWhatTheDepthWasMadeFrom) {
    constexpr std::uint32_t width = 31, height = 17;
    constexpr std::size_t pixels = std::size_t{width} * height;
    RenderScene scene;
    scene.view = RenderScene::View{.position = vec3(3, 2, 1), .forward = glm::normalize(vec3(1, -0.4f, 0.3f)), .fov_y = 1.1f, .near = 0.02f};
    const FrameParams frame = frame_params(scene, width, height, 0);

    std::mt19937 engine(11);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<vec3> positions(pixels), normals(pixels);
    std::vector<float> depths(pixels);
    std::vector<std::uint16_t> encoded;
    for (std::size_t i = 0; i < pixels; ++i) {
        // The way to each pixel undoes the projection by its inverse, not by the ray that point_at takes.
        const vec2 ndc = (vec2(static_cast<float>(i % width), static_cast<float>(i / width)) + 0.5f) / vec2(width, height) * 2.0f - 1.0f;
        const glm::dvec4 far_point = glm::inverse(dmat4(frame.clip_from_world)) * glm::dvec4(ndc, 1e-5, 1.0);  // 2 km ahead
        const dvec3 ray = (dvec3(far_point) / far_point.w - dvec3(scene.view->position)) / 2000.0;
        positions[i] = vec3(dvec3(scene.view->position) + ray * std::pow(10.0, -1.0 + 4.0 * unit(engine)));  // 0.1 m to 1 km
        const glm::dvec4 clip = dmat4(frame.clip_from_world) * glm::dvec4(positions[i], 1.0);
        depths[i] = i % 10 == 3 ? 0.0f : static_cast<float>(clip.z / clip.w);
        normals[i] = glm::normalize(vec3(unit(engine), unit(engine), unit(engine)) - 0.5f + vec3(0, 0, 1e-4f));
        const vec2 square = octahedral_encode(normals[i]) * 0.5f + 0.5f;
        for (int c = 0; c < 2; ++c) encoded.push_back(static_cast<std::uint16_t>(std::lround(square[c] * 65535.0f)));
    }
    give("Frame", frame);
    upload(give_image("depth", {.width = width, .height = height, .format = Format::depth32f}), depths);
    upload(give_image("normal", {.width = width, .height = height, .format = Format::rg16}), encoded);

    const std::string at = fmt::format("    Point point = point_at(ivec2(i % {0}u, i / {0}u));\n", width);
    const auto places = compute("#include \"lib/gbuffer.glsl\"\n", at + "    result = vec4(point.position, point.distance);", pixels);
    const auto facings = compute("#include \"lib/gbuffer.glsl\"\n", at + "    result.xyz = point.normal;", pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (i % 10 == 3) {
            ASSERT_LT(places[i].w, 0.0f) << "there is no surface";
            continue;
        }
        // Depth as a float carries seven digits at any distance, and so does the position.
        const float distance = glm::length(positions[i] - scene.view->position);
        ASSERT_LT(glm::length(vec3(places[i]) - positions[i]), 2e-6f * (distance + 4.0f)) << "pixel " << i;
        ASSERT_NEAR(places[i].w, glm::dot(positions[i] - scene.view->position, scene.view->forward), 1e-5f * distance);
        // Half a step of 1/65535 in a square that is 2 wide, stretched at most threefold by the decoding.
        ASSERT_LT(glm::length(vec3(facings[i]) - normals[i]), 1e-4f) << "pixel " << i;
    }
}

}  // namespace
}  // namespace sl
