// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <vector>

#include "engine/core/math.h"
#include "engine/ecs/query.h"

namespace sl::ecs_bench {

struct Position {
    vec3 value{0.0f};
};
struct Velocity {
    vec3 value{1.0f, 2.0f, 3.0f};
};
struct Mass {
    float value = 2.0f;
};

inline constexpr float step = 1.0f / 60.0f;

// One function per loop, so that arrays and queries do the same by construction.
inline void fall(Position& position) {
    position.value.y -= step;
}
inline void move(Position& position, const Velocity& velocity) {
    position.value += velocity.value * step;
}
inline void push(Position& position, const Velocity& velocity, const Mass& mass) {
    position.value += velocity.value * (step * mass.value);
}

inline void count_each(benchmark::State& state, std::int64_t items) {
    state.counters["each"] =
        benchmark::Counter(static_cast<double>(items),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The same data without an ECS.
struct Arrays {
    explicit Arrays(std::int64_t size)
        : positions(static_cast<std::size_t>(size)), velocities(positions.size()), masses(positions.size()) {
        benchmark::DoNotOptimize(positions.data());
        benchmark::DoNotOptimize(velocities.data());
        benchmark::DoNotOptimize(masses.data());
    }
    std::vector<Position> positions;
    std::vector<Velocity> velocities;
    std::vector<Mass> masses;
};

inline std::vector<Entity> fill(World& world, std::int64_t size) {
    std::vector<Entity> entities;
    for (std::int64_t i = 0; i < size; ++i) entities.push_back(world.create(Position{}, Velocity{}, Mass{}));
    return entities;
}

/// Every entity has a position, half of them a velocity, and no pool has the order of another.
inline void fill_scattered(World& world, std::int64_t size) {
    std::mt19937 random(1);
    std::vector<Entity> entities;
    for (std::int64_t i = 0; i < size; ++i) entities.push_back(world.create());
    std::shuffle(entities.begin(), entities.end(), random);
    for (const Entity entity : entities) world.add(entity, Position{});
    std::shuffle(entities.begin(), entities.end(), random);
    for (std::size_t i = 0; i < entities.size() / 2; ++i) world.add(entities[i], Velocity{});
}

inline void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMicrosecond);
}

}  // namespace sl::ecs_bench
