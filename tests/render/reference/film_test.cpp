// SPDX-License-Identifier: MIT
// A reference repeats exactly on any number of threads, in any split, and knows its own noise.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/core/error.h"
#include "engine/render/reference/reference.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

constexpr uvec2 size{12, 9};

/// A floor, a box on it, a spot light and a sky: all kinds of noise.
void fill(SceneBuilder& builder) {
    builder.add({Shape::Kind::quad, vec3(4)}, mat4(1.0f), vec3(0.6f, 0.5f, 0.4f));
    builder.add({Shape::Kind::box, vec3(1)}, glm::translate(mat4(1.0f), vec3(0.3f, 0.5f, 0)), vec3(0.2f, 0.7f, 0.3f));
    builder.add({.kind = RenderScene::Light::Kind::spot, .position = vec3(2, 3, 1), .direction = glm::normalize(vec3(-2, -3, -1)), .intensity = vec3(100), .inner_cone = 0.3f,
                 .outer_cone = 0.6f, .casts_shadow = true, .bounces = true});
    builder.scene().sky_radiance = vec3(1, 2, 3);
    builder.look(vec3(0, 1.5f, 3), vec3(0, -0.4f, -1), vec3(0, 1, 0), 0.9f);
}

void expect_same_pictures(const Film& one, const Film& other) {
    const auto a = one.layers(), b = other.layers();
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].image.data, b[i].image.data) << a[i].name;
}

TEST(Film, TheSameOnOneThreadAndOnMany) {
    SceneBuilder builder;
    fill(builder);
    Film alone(size);
    tbb::task_arena(1).execute([&] { alone = trace_film(builder.scene(), size, {}, 32); });
    expect_same_pictures(alone, trace_film(builder.scene(), size, {}, 32));
}

TEST(Film, PiecesMergeIntoTheWhole) {
    SceneBuilder builder;
    fill(builder);
    const PathTracer tracer(builder.scene(), size, {});
    const auto piece = [&](const FilmBlock& block) {
        Film film(size);
        trace_reference(tracer, film, {.block = block}, {});
        return film;
    };
    const Film whole = piece({.high = size, .last = 32});
    Film merged = piece({.high = {5, 9}, .last = 32});
    merged.add(piece({.low = {5, 0}, .high = size, .last = 16}));
    merged.add(piece({.low = {5, 0}, .high = size, .first = 16, .last = 32}));
    expect_same_pictures(whole, merged);
}

TEST(Film, AContinuedFilmIsTheSameAsOneGo) {
    SceneBuilder builder;
    fill(builder);
    const PathTracer tracer(builder.scene(), size, {});
    Film film(size);
    trace_reference(tracer, film, {.block = {.high = size, .last = 10}}, {});
    trace_reference(tracer, film, {.block = {.high = size, .last = 32}}, {});
    EXPECT_EQ(film.blocks(), std::vector<FilmBlock>({{.high = size, .last = 32}}));
    expect_same_pictures(film, trace_film(builder.scene(), size, {}, 32));
}

TEST(Film, RefusesToCountSamplesTwice) {
    SceneBuilder builder;
    fill(builder);
    Film film = trace_film(builder.scene(), size, {}, 8);
    EXPECT_THROW(film.add(film), Error);
    EXPECT_THROW(film.add(Film(uvec2(3, 3))), Error);
}

TEST(Film, NoiseFallsWithTheRootOfSamplesAndTheHalvesAgreeWithIt) {
    SceneBuilder builder;
    fill(builder);
    // Well-spread samples do better than the root; their estimate, made as if they were random, shows the root. An estimate
    // from few samples is noisy itself: the mean over some seeds is what can be foretold.
    double few = 0.0, more = 0.0;
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        few += trace_film(builder.scene(), size, {.seed = seed}, 64).noise();
        more += trace_film(builder.scene(), size, {.seed = seed}, 1024).noise();
    }
    EXPECT_NEAR(few / more, 4.0, 0.6);
    const Film many = trace_film(builder.scene(), size, {}, 1024);
    const auto layers = many.layers();
    const auto image = [&](std::string_view name) { return std::ranges::find(layers, name, &ImageLayer::name)->image; };
    const double halves = noise_of_halves(image("irradiance"), image("irradiance_half"), image("depth").data);
    EXPECT_GT(halves, 0.0);
    EXPECT_LT(halves, 1.5 * many.noise());
}

TEST(Film, StopsAtANoiseTargetAndWhenTold) {
    SceneBuilder builder;
    fill(builder);
    const PathTracer tracer(builder.scene(), size, {});
    Film film(size);
    const auto progress = trace_reference(tracer, film, {.block = {.high = size, .last = 1u << 20}, .noise = 0.05}, {});
    EXPECT_LE(progress.noise, 0.05);
    EXPECT_LT(progress.samples, 1u << 14);
    Film stopped(size);
    int told = 0, saved = 0;
    trace_reference(tracer, stopped, {.block = {.high = size, .last = 1u << 20}}, [&](const ReferenceProgress&) { return ++told < 3; }, [&] { ++saved; });
    EXPECT_EQ(told, 3);
    EXPECT_EQ(saved, 2) << "what was traced is saved soon, and when it stops";
}

}  // namespace
}  // namespace sl
