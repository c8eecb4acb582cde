// SPDX-License-Identifier: MIT
// Broken meshes, nothing at all, odd frames, and settings at the ends of their ranges.
#include "tests/hard_cases/hard_case_test.h"

namespace sl {
namespace {

/// Something for light to fall on, a sun, and a camera.
void plain_scene(SceneBuilder& builder) {
    builder.add({Shape::Kind::quad, vec3(4)}, mat4(1.0f), vec3(0.5f));
    builder.add({Shape::Kind::box, vec3(1)}, at(vec3(0.5f, 0.5f, 0)), vec3(0.7f, 0.2f, 0.2f));
    builder.add(sun(vec3(-1, -1, -0.5f)));
    builder.look(vec3(-1, 1.5f, 2), vec3(1, -0.8f, -2), vec3(0, 1, 0), 0.9f);
}

TEST_P(HardCases, ZeroAreaTriangles) {
    SceneBuilder with, without;
    plain_scene(without);
    plain_scene(with);
    MeshData mesh = make_shape_mesh({Shape::Kind::quad, vec3(1)});
    const auto any = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    mesh.indices = {0, 0, 0, 0, 1, 1, 1, 2, 1, any, any, any};
    with.add(mesh, at(vec3(0, 1, 0)), SceneBuilder::matte(vec3(1)));
    // A triangle without area is hit by nothing, so it changes nothing.
    EXPECT_TRUE(same_bytes(draw(with, {8, 8}, rough()), draw(without, {8, 8}, rough())));
    survives("zero-area triangles", "change nothing");
}

TEST_P(HardCases, BadNormals) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<std::pair<std::string, std::vector<vec3>>> cases{
        {"zero normals", {vec3(0)}}, {"NaN normals", {vec3(nan), vec3(nan, 1, 0), vec3(0, nan, 0)}}, {"infinite normals", {vec3(inf), vec3(0, -inf, 0)}},
        {"normals that cancel within a triangle", {vec3(0, 1, 0), vec3(0, -1, 0)}}};
    for (const auto& [name, normals] : cases) {
        SceneBuilder builder;
        plain_scene(builder);
        MeshData mesh = make_shape_mesh({Shape::Kind::box, vec3(0.8f)});
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) mesh.vertices[i].normal = pack_normal(normals[i % normals.size()]);
        builder.add(mesh, at(vec3(-0.5f, 0.5f, 0.3f)), SceneBuilder::matte(vec3(0.9f)));
        (void)draw(builder, {24, 18}, rough());
        survives(name);
    }
    // An un-normalised normal is the same direction.
    const auto picture = [&](float length) {
        SceneBuilder builder;
        plain_scene(builder);
        MeshData mesh = make_shape_mesh({Shape::Kind::quad, vec3(0.8f)});
        for (Vertex& vertex : mesh.vertices) vertex.normal = pack_normal(vec3(0.5f, 1, 0.25f) * length);
        builder.add(mesh, at(vec3(-0.5f, 0.5f, 0.3f)), SceneBuilder::matte(vec3(0.9f)));
        return draw(builder, {8, 8}, rough());
    };
    EXPECT_TRUE(same_bytes(picture(1.0f), picture(64.0f)));
    survives("un-normalised normals", "change nothing");
}

TEST_P(HardCases, FlattenedDraws) {
    SceneBuilder builder;
    plain_scene(builder);
    // At its rim a sphere scaled to a disc has no normal at all; scaled to a line or a point it has none anywhere.
    for (const vec3 scale : {vec3(1, 0, 1), vec3(0, 1, 0), vec3(0), vec3(1e-30f)}) {
        builder.add({Shape::Kind::sphere, vec3(1)}, glm::scale(at(vec3(-0.5f, 0.7f, 0.3f)), scale), vec3(0.9f));
        builder.add({Shape::Kind::box, vec3(1)}, glm::scale(at(vec3(-0.2f, 0.9f, 0.3f)), scale), vec3(0.9f));
    }
    (void)draw(builder, {24, 18}, rough());
    survives("draws scaled to a plane, a line, a point");
}

TEST_P(HardCases, NothingThere) {
    SceneBuilder no_light, empty, unlit, no_camera;
    plain_scene(no_light);
    no_light.scene().lights.clear();
    EXPECT_EQ(draw(no_light).mean(), glm::dvec3(0.0));
    survives("no light", "black");

    empty.add(sun(vec3(0, -1, 0)));
    empty.look(vec3(0), vec3(0, 0, -1), vec3(0, 1, 0), 1.0f);
    EXPECT_EQ(draw(empty).mean(), glm::dvec3(0.0));
    survives("empty scene", "black");

    plain_scene(unlit);
    unlit.scene().lights = {spot(vec3(0, 3, 0), vec3(0, 1, 0), 100.0f, 0.5f)};
    EXPECT_EQ(draw(unlit).mean(), glm::dvec3(0.0));
    survives("empty RSM: the light looks away", "black");

    if (method().traced()) return survives("no camera", "a caller's error");
    plain_scene(no_camera);
    no_camera.scene().view.reset();
    no_camera.use(*method().gi);
    EXPECT_FALSE(renderer->render(no_camera.scene(), {}).drawn);
    survives("no camera", "nothing drawn");
}

TEST_P(HardCases, OddFrames) {
    SceneBuilder builder;
    plain_scene(builder);
    LightMethod quick = method();
    quick.samples = 4;
    if (auto* exact = quick.traced() ? nullptr : quick.gi->get_if<RsmExact>()) exact->rsm_size = 16;
    if (auto* grid = quick.traced() ? nullptr : quick.gi->get_if<RsmGrid>()) grid->rsm_size = 16;
    if (auto* disc = quick.traced() ? nullptr : quick.gi->get_if<RsmDisc>()) disc->samples = 64;
    if (auto* facets = quick.facets() ? quick.gi->get_if<Facets>() : nullptr) facets->noise = 0.3f;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Picture> seen;
    for (const uvec2 size : {uvec2(1, 1), uvec2(7680, 1), uvec2(1, 300), uvec2(13, 7), uvec2(1, 1), uvec2(13, 7)}) {
        const Picture picture = draw(builder, size, quick);
        const auto [known, fresh] = seen.try_emplace({size.x, size.y}, picture);
        EXPECT_TRUE(fresh || same_bytes(picture, known->second)) << "after frames of other sizes";
    }
    survives("frames of 1×1, 7680×1, 1×300; resize between frames", "same bytes after a resize");
}

TEST_P(HardCases, SettingsAtTheEndsOfTheirRanges) {
    if (method().traced()) return;
    SceneBuilder builder;
    plain_scene(builder);
    const auto with = [&](auto settings) {
        LightMethod other = method();
        other.gi = settings;
        return draw(builder, {16, 12}, other).mean_brightness();
    };
    if (is("rsm_exact")) {
        EXPECT_EQ(with(RsmExact{.rsm_size = 16, .strength = 0.0f}), 0.0);
        EXPECT_GT(with(RsmExact{.rsm_size = 4}), 0.0);
    } else if (is("rsm_grid")) {
        EXPECT_EQ(with(RsmGrid{.rsm_size = 16, .strength = 0.0f}), 0.0);
        EXPECT_EQ(with(RsmGrid{.rsm_size = 16, .cutoff = 1.0f}), 0.0);
        EXPECT_EQ(with(RsmGrid{.rsm_size = 16, .angle_threshold = 1.0f}), 0.0);
        EXPECT_GT(with(RsmGrid{.rsm_size = 16, .distance_attenuation = 0.0f, .cutoff = 0.0f}), 0.0);
        EXPECT_GE(with(RsmGrid{.rsm_size = 4, .step = 64}), 0.0);
    } else if (is("facets")) {
        EXPECT_EQ(with(Facets{.strength = 0.0f}), 0.0);
        EXPECT_EQ(with(Facets{.bounces = 0}), 0.0);
        EXPECT_GT(with(Facets{.bounces = 1}), 0.0);
        EXPECT_GT(with(Facets{.spacing = 64.0f, .noise = 1.0f}), 0.0);
        EXPECT_GT(with(Facets{.spacing = 1.0f, .noise = 1.0f}), 0.0);
    } else {
        EXPECT_EQ(with(RsmDisc{.rsm_size = 16, .strength = 0.0f}), 0.0);
        EXPECT_EQ(with(RsmDisc{.rsm_size = 16, .samples = 0}), 0.0);
        EXPECT_EQ(with(RsmDisc{.rsm_size = 16, .radius = 0.0f}), 0.0);
        EXPECT_GE(with(RsmDisc{.rsm_size = 16, .samples = 1}), 0.0);
        EXPECT_GT(with(RsmDisc{.rsm_size = 4, .samples = 64, .radius = 1.5f}), 0.0);
        EXPECT_GT(with(RsmDisc{.rsm_size = 64, .low_resolution = 32, .position_tolerance = 0.0f, .normal_tolerance = 1.0f}), 0.0);
    }
    survives("strength 0; samples 0 and 1; radius 0; smallest map", is("facets") ? "survives: strength and bounces 0, widest and narrowest" : "survives");
}

/// Light on a vertical line of a wall over a sunlit, narrow strip of ground, from its foot up.
std::vector<double> profile(SceneBuilder& builder, HardCases& test, const LightMethod& with) {
    builder.add({Shape::Kind::quad, vec3(1, 0, 4)}, at(vec3(0, 0, 1.5f)), vec3(0.6f));
    builder.add({Shape::Kind::quad, vec3(4)}, at(vec3(0, 2, -3), facing_front), vec3(0.0f));
    builder.add(sun(vec3(0, -1, 0)));
    builder.look(vec3(0, 0.5f, -1), vec3(0, 0, -1), vec3(0, 1, 0), 0.45f);
    const Picture picture = test.draw(builder, {1, 96}, with);
    std::vector<double> values;
    for (auto row = picture.irradiance.rbegin(); row != picture.irradiance.rend(); ++row) values.push_back(row->y);
    return values;
}

TEST_P(HardCases, ThePapersArtefact) {
    if (method().traced()) return;  // its noise is larger than a step
    LightMethod paper = method();
    if (is("rsm_grid")) paper.gi->get<RsmGrid>() = {.rsm_size = 128, .strength = 0.6f, .angle_threshold = 0.05f};
    SceneBuilder builder;
    const std::vector<double> light = profile(builder, *this, paper);
    double largest = 0.0, peak = 0.0;
    for (std::size_t i = 1; i < light.size(); ++i) {
        largest = std::max(largest, std::abs(light[i] - light[i - 1]));
        peak = std::max(peak, light[i]);
    }
    ASSERT_GT(peak, 0.0);
    const double step = largest / peak;
    // 96 pixels: a smooth rise to the peak takes a few per cent a pixel at most.
    if (is("rsm_grid")) {
        EXPECT_GT(step, 0.05);
    } else {
        EXPECT_LT(step, 0.05);
    }
    survives("the paper's artefact setting (`rsm_grid`): largest step between two pixels of a smooth wall", ResultTable::figure(step));
}

}  // namespace
}  // namespace sl
