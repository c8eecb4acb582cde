// SPDX-License-Identifier: MIT
#include "game/crystals/crystals.h"

#include <algorithm>
#include <array>

#include "engine/core/clock.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "engine/render/trace/light_meter.h"
#include "game/notice.h"
#include "game/session.h"

namespace sl {

namespace {

constexpr double measured_within = 25.0;  // m
/// So long the light must stay: a torch that is carried past does not count.
constexpr double lit_long_enough = 1.0;  // s
constexpr double celebrated_for = 6.0, celebrated_at_last = 20.0;  // s
/// From the middle to where light is measured: outside the crystal itself, m.
constexpr double to_its_sides = 0.4;
constexpr std::array<vec3, 5> sides{vec3(0, 1, 0), vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)};

std::string name_of(World& world, Entity entity) {
    const auto* name = world.find<Name>(entity);
    return name != nullptr ? name->value : "crystal";
}

/// Mean over its sides; nothing until all are known well enough.
std::optional<vec3> reflected_light(LightMeter& meter, const dvec3& middle) {
    vec3 sum(0.0f);
    bool known = true;
    for (const vec3 side : sides) {
        const auto reading = meter.irradiance_at(middle + to_its_sides * dvec3(side), side);
        if (reading) sum += reading->bounced;
        known = known && reading;
    }
    if (!known) return std::nullopt;
    return sum / static_cast<float>(sides.size());
}

void find_nearest(World& world, CrystalSearch& search) {
    const Entity camera = active_camera(world);
    const auto* eye = camera ? world.find<WorldTransform>(camera) : nullptr;
    const Entity before = search.nearest;
    search.nearest = {};
    search.awake = search.all = 0;
    double nearest = measured_within;
    for (auto [entity, crystal, place] : Query<const Crystal, const WorldTransform>(world)) {
        ++search.all;
        if (crystal.awake) ++search.awake;
        const double distance = eye != nullptr ? glm::length(place.origin - eye->origin) : measured_within;
        if (crystal.awake || distance >= nearest) continue;
        nearest = distance;
        search.nearest = entity;
    }
    search.distance = static_cast<float>(nearest);
    if (search.nearest == before) return;
    search.light.reset();
    search.hint.clear();
    search.lit_for = 0.0;
}

void wake(World& world, CrystalSearch& search) {
    world.get<Crystal>(search.nearest).awake = true;
    ++search.awake;
    const bool last = search.awake == search.all;
    search.celebration = last ? celebrated_at_last : celebrated_for;
    const std::string name = name_of(world, search.nearest);
    world.resource<Notice>().say(last ? fmt::format("{} wakes. All {} crystals shine: the valley is yours.", name, search.all) : fmt::format("{} wakes: {} of {}", name, search.awake, search.all),
                                 search.celebration);
    search.nearest = {};
    search.light.reset();
    search.hint.clear();
    search.lit_for = 0.0;
}

void measure_nearest(World& world, CrystalSearch& search) {
    auto* meter = world.find_resource<LightMeter>();
    if (!search.nearest || meter == nullptr) return;
    const Crystal& crystal = world.get<Crystal>(search.nearest);
    const auto light = reflected_light(*meter, world.get<WorldTransform>(search.nearest).origin);
    if (!light) return;
    search.light = crystal_light(crystal, *light);
    const bool enough = search.light->amount >= 1.0f && search.light->match >= crystal.purity;
    search.lit_for = enough ? search.lit_for + world.resource<FrameClock>().step : 0.0;
    if (search.lit_for >= lit_long_enough) wake(world, search);
}

void glow(World& world) {
    for (auto [entity, crystal, material] : Query<const Crystal, Material>(world)) {
        material.emission = crystal.awake ? crystal.glow : 0.0f;
        material.emission_colour = crystal.colour;
    }
}

void give_hints(World& world, CrystalSearch& search) {
    const auto* input = world.find_resource<Input>();
    if (input == nullptr || !input->pressed(Key::t) || search.all == 0) return;
    search.hint = search.nearest ? fmt::format("{}: {}", name_of(world, search.nearest), world.get<Crystal>(search.nearest).hint)
                  : search.awake == search.all ? "All crystals are awake."
                                               : "No sleeping crystal is near. Follow the paths of sand.";
}

}  // namespace

void crystals(World& world) {
    auto& search = world.resource<CrystalSearch>();
    find_nearest(world, search);
    measure_nearest(world, search);
    give_hints(world, search);
    glow(world);
    search.celebration = std::max(0.0, search.celebration - world.resource<FrameClock>().step);
}

std::vector<std::string> awake_crystals(World& world) {
    std::vector<std::string> names;
    for (auto [entity, crystal, name] : Query<const Crystal, const Name>(world)) {
        if (crystal.awake) names.push_back(name.value);
    }
    std::ranges::sort(names);
    return names;
}

void add_crystals(App& app) {
    add_player_resources(app.world);
    app.registry().add<Crystal>("crystal");
    app.world.add_resource(CrystalSearch{});
    app.schedule.add(Stage::simulate, "crystals", &crystals);
}

}  // namespace sl
