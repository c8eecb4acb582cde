// SPDX-License-Identifier: MIT
// Worlds far out, surfaces that give all or nothing back, and energy.
#include "engine/ecs/components.h"
#include "engine/ecs/world.h"
#include "engine/render/scene/extract.h"
#include "tests/hard_cases/hard_case_test.h"

namespace sl {
namespace {

/// A box and a wall on a floor under a sun and a lamp, as entities of a world, `offset` away from its origin.
void fill(World& world, dvec3 offset) {
    MeshPool& meshes = world.resource<MeshPool>();
    const auto add = [&](const Shape& shape, dvec3 place, vec3 albedo) {
        const Entity entity = world.create();
        MeshData mesh = make_shape_mesh(shape);
        static std::uint32_t meshes_made = 0x10000;  // one renderer draws all worlds: no version twice
        mesh.version = ++meshes_made;
        world.add(entity, MeshInstance{.mesh = meshes.insert(std::move(mesh))});
        world.add(entity, WorldTransform{.origin = offset + place});
        world.add(entity, SceneBuilder::matte(albedo));
    };
    add({Shape::Kind::quad, vec3(8, 0, 8)}, dvec3(0), vec3(0.5f, 0.4f, 0.3f));
    add({Shape::Kind::box, vec3(1, 2, 1.3f)}, dvec3(-0.8, 1.2, 0.3), vec3(0.7f, 0.2f, 0.2f));
    add({Shape::Kind::sphere, vec3(1.5f)}, dvec3(1.2, 1, -0.2), vec3(0.3f, 0.6f, 0.3f));
    const auto turned = [](vec3 forward) { return glm::transpose(mat3(view_from_world(vec3(0), forward, vec3(0, 1, 0)))); };
    const Entity sun_entity = world.create(), lamp = world.create(), camera = world.create();
    world.add(sun_entity, DirectionalLight{.illuminance = 1000, .shadow_size = 256});
    world.add(sun_entity, WorldTransform{.origin = offset, .linear = turned(vec3(0.5f, -1, 0.2f))});
    world.add(lamp, SpotLight{.intensity = 3000, .shadow_size = 256});
    world.add(lamp, WorldTransform{.origin = offset + dvec3(2, 4, 2), .linear = turned(vec3(-0.5f, -1, -0.5f))});
    world.add(camera, Camera{});
    world.add(camera, WorldTransform{.origin = offset + dvec3(0, 2.5, 6), .linear = turned(vec3(0, -0.3f, -1))});
}

TEST_P(HardCases, FarFromTheOrigin) {
    const auto picture = [&](dvec3 offset) {
        World world;
        world.emplace_resource<MeshPool>();
        fill(world, offset);
        RenderScene scene;
        extract(world, scene);
        LightMethod with = rough();
        renderer->forget();
        with.transport.light_paths = false;  // where they go hangs on every rounding, and with them a picture's noise
        const Picture drawn = picture_of(with, scene, *renderer, {16, 12});
        EXPECT_EQ(insane_pixel(drawn), "");
        return drawn;
    };
    const Picture home = picture(dvec3(0));
    for (const double metres : {1e5, 1e6}) {
        const Picture far = picture(dvec3(metres + 0.3, -0.7, -metres));
        const double change = deviation(far, home).inner;
        // As at the end of relative coordinates, see tests/relations/motion_test.cpp.
        // The lattice of facets of half a picture's width lies otherwise there, as in "moved by 1 km".
        EXPECT_LT(change, is("facets") ? 0.4 : 0.02);
        survives(fmt::format("world coordinates of 10{} m: change of the picture", metres < 5e5 ? "⁵" : "⁶"), ResultTable::figure(change));
    }
}

/// A sphere seen from inside.
MeshData hollow_sphere(float diameter) {
    MeshData mesh = make_shape_mesh({Shape::Kind::sphere, vec3(diameter)});
    for (Vertex& vertex : mesh.vertices) vertex.normal = pack_normal(-vertex.position);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    return mesh;
}

void closed_sphere(SceneBuilder& builder, float albedo) {
    builder.add(hollow_sphere(4.0f), mat4(1.0f), SceneBuilder::matte(vec3(albedo)));
    builder.add(spot(vec3(0.3f, 0.2f, -0.4f), vec3(0.3f, -1, 0.2f), 1000.0f, 0.7f));
    builder.look(vec3(0.3f, 0.2f, 0.1f), vec3(1, 0.2f, 0.4f), vec3(0, 1, 0), 1.2f);
}

TEST_P(HardCases, AlbedoOneInAClosedSphere) {
    SceneBuilder builder;
    closed_sphere(builder, 1.0f);
    // One bounce is the same everywhere inside: E = ρΦ / (4πR²), with Φ = I · 2π (1 - cos θ).
    const double truth = 1000.0 * 2.0 * M_PI * (1.0 - std::cos(0.7)) / (4.0 * M_PI * 4.0);
    expect_value("albedo 1 in a closed sphere, one bounce", draw(builder, {16, 12}, one_bounce()).mean_brightness(), truth, {0.03, 0.1, 0.03});
    if (!method().traced() && !is("facets")) return;
    // All bounces never end; a path does, by chance.
    LightMethod endless = method();
    endless.transport.bounces = TransportSettings::until_converged;
    endless.samples = 16;
    EXPECT_GT(draw(builder, {4, 3}, endless).mean_brightness(), 10.0 * truth);
}

TEST_P(HardCases, BlackAlbedo) {
    SceneBuilder builder;
    closed_sphere(builder, 0.0f);
    EXPECT_EQ(draw(builder).mean(), glm::dvec3(0.0));
    survives("black albedo", "0, as it should");
}

TEST_P(HardCases, MoreLightThanHalfFloatsHold) {
    // 10⁹ candela at 1 cm: 10¹³ lux.
    SceneBuilder builder;
    builder.add({Shape::Kind::quad, vec3(4)}, mat4(1.0f), vec3(1.0f));
    builder.add({Shape::Kind::box, vec3(1)}, at(vec3(1, 0.5f, 0)), vec3(1.0f));
    builder.add(spot(vec3(0, 0.01f, 0), vec3(0, -1, 0), 1e9f, 0.9f));
    builder.look(vec3(-1, 1.5f, 1), vec3(1, -0.8f, -1), vec3(0, 1, 0), 0.9f);
    (void)draw(builder);
    survives("light of 10⁹ cd, 1 cm over the floor");
}

}  // namespace
}  // namespace sl
