// SPDX-License-Identifier: MIT
// Creating, destroying, adding, removing and reordering. The counter "each" is the processor time per entity.
#include <memory>

#include "bench/ecs_bench.h"

namespace sl::ecs_bench {
namespace {

void align(benchmark::State& state) {
    for (auto _ : state) {
        state.PauseTiming();
        auto world = std::make_unique<World>();
        fill_scattered(*world, state.range(0));
        state.ResumeTiming();
        world->align<Position, Velocity>();
        state.PauseTiming();
        world.reset();
        state.ResumeTiming();
    }
    count_each(state, state.range(0));
}

void create_2(benchmark::State& state) {
    for (auto _ : state) {
        state.PauseTiming();
        auto world = std::make_unique<World>();
        state.ResumeTiming();
        for (std::int64_t i = 0; i < state.range(0); ++i) {
            benchmark::DoNotOptimize(world->create(Position{}, Velocity{}));
        }
        state.PauseTiming();
        world.reset();
        state.ResumeTiming();
    }
    count_each(state, state.range(0));
}
/// A world that has held as many before, as after a change of level.
void create_2_again(benchmark::State& state) {
    World world;
    for (auto _ : state) {
        state.PauseTiming();
        world.clear();
        state.ResumeTiming();
        for (std::int64_t i = 0; i < state.range(0); ++i) {
            benchmark::DoNotOptimize(world.create(Position{}, Velocity{}));
        }
    }
    count_each(state, state.range(0));
}

void destroy_in(benchmark::State& state, bool shuffled) {
    std::mt19937 random(1);
    World world;
    std::vector<Entity> entities(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        state.PauseTiming();
        for (Entity& entity : entities) entity = world.create(Position{}, Velocity{});
        if (shuffled) std::shuffle(entities.begin(), entities.end(), random);
        state.ResumeTiming();
        for (const Entity entity : entities) world.destroy(entity);
    }
    count_each(state, state.range(0));
}
void destroy(benchmark::State& state) {
    destroy_in(state, false);
}
void destroy_shuffled(benchmark::State& state) {
    destroy_in(state, true);
}

void add_remove(benchmark::State& state) {
    World world;
    std::vector<Entity> entities;
    for (std::int64_t i = 0; i < state.range(0); ++i)
        entities.push_back(world.create(Position{}, Velocity{}));
    for (auto _ : state) {
        for (const Entity entity : entities) world.add(entity, Mass{});
        for (const Entity entity : entities) world.remove<Mass>(entity);
    }
    count_each(state, state.range(0));
}

BENCHMARK(align)->Apply(sizes);
BENCHMARK(create_2)->Apply(sizes);
BENCHMARK(create_2_again)->Apply(sizes);
BENCHMARK(destroy)->Apply(sizes);
BENCHMARK(destroy_shuffled)->Apply(sizes);
BENCHMARK(add_remove)->Apply(sizes);

}  // namespace
}  // namespace sl::ecs_bench
