// SPDX-License-Identifier: MIT
// Walking components, beside plain arrays of the same structs with the same arithmetic: as fast as it can
// get.
//     ecs_bench --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
// The counter "each" is the processor time per visited entity.
#include "bench/ecs_bench.h"

#include <numeric>

namespace sl::ecs_bench {
namespace {

template <class F>
void repeat(benchmark::State& state, std::int64_t visited, F loop) {
    for (auto _ : state) {
        loop();
        benchmark::ClobberMemory();
    }
    count_each(state, visited);
}

void iterate_1_array(benchmark::State& state) {
    Arrays arrays(state.range(0));
    repeat(state, state.range(0), [&] {
        for (std::size_t i = 0; i < arrays.positions.size(); ++i) fall(arrays.positions[i]);
    });
}
void iterate_1(benchmark::State& state) {
    World world;
    fill(world, state.range(0));
    repeat(state, state.range(0),
           [&] { Query<Position>(world).each([](Position& position) { fall(position); }); });
}

void iterate_2_array(benchmark::State& state) {
    Arrays arrays(state.range(0));
    repeat(state, state.range(0), [&] {
        for (std::size_t i = 0; i < arrays.positions.size(); ++i)
            move(arrays.positions[i], arrays.velocities[i]);
    });
}
void iterate_2(benchmark::State& state) {
    World world;
    fill(world, state.range(0));
    repeat(state, state.range(0), [&] {
        Query<Position, const Velocity>(world).each(
            [](Position& position, const Velocity& velocity) { move(position, velocity); });
    });
}
void iterate_2_range_for(benchmark::State& state) {
    World world;
    fill(world, state.range(0));
    repeat(state, state.range(0), [&] {
        for (auto [entity, position, velocity] : Query<Position, const Velocity>(world))
            move(position, velocity);
    });
}

void iterate_3_array(benchmark::State& state) {
    Arrays arrays(state.range(0));
    repeat(state, state.range(0), [&] {
        for (std::size_t i = 0; i < arrays.positions.size(); ++i) {
            push(arrays.positions[i], arrays.velocities[i], arrays.masses[i]);
        }
    });
}
void iterate_3(benchmark::State& state) {
    World world;
    fill(world, state.range(0));
    repeat(state, state.range(0), [&] {
        Query<Position, const Velocity, const Mass>(world).each(
            [](Position& position, const Velocity& velocity, const Mass& mass) {
                push(position, velocity, mass);
            });
    });
}

/// What no sparse set can beat here: the position's place is known beforehand, but memory is met in the same
/// disorder.
void iterate_2_scattered_array(benchmark::State& state) {
    Arrays arrays(state.range(0));
    std::vector<std::uint32_t> places(arrays.positions.size());
    std::iota(places.begin(), places.end(), 0u);
    std::shuffle(places.begin(), places.end(), std::mt19937(1));
    repeat(state, state.range(0) / 2, [&] {
        for (std::size_t i = 0; i < places.size() / 2; ++i)
            move(arrays.positions[places[i]], arrays.velocities[i]);
    });
}
void walk_half(benchmark::State& state, World& world) {
    repeat(state, state.range(0) / 2, [&] {
        Query<Position, const Velocity>(world).each(
            [](Position& position, const Velocity& velocity) { move(position, velocity); });
    });
}
void iterate_2_scattered(benchmark::State& state) {
    World world;
    fill_scattered(world, state.range(0));
    walk_half(state, world);
}
void iterate_2_scattered_then_aligned(benchmark::State& state) {
    World world;
    fill_scattered(world, state.range(0));
    world.align<Position, Velocity>();
    walk_half(state, world);
}
/// What the first walk after a change of everything costs: all blocks are compared again.
void iterate_2_after_change(benchmark::State& state) {
    World world;
    const std::vector<Entity> entities = fill(world, state.range(0));
    for (auto _ : state) {
        state.PauseTiming();
        for (std::size_t i = 0; i < entities.size(); i += PoolIndex::block_size) {
            world.remove<Velocity>(entities[i]);
            world.add(entities[i], Velocity{});
        }
        state.ResumeTiming();
        Query<Position, const Velocity>(world).each(
            [](Position& position, const Velocity& velocity) { move(position, velocity); });
        benchmark::ClobberMemory();
    }
    count_each(state, state.range(0));
}
BENCHMARK(iterate_1_array)->Apply(sizes);
BENCHMARK(iterate_1)->Apply(sizes);
BENCHMARK(iterate_2_array)->Apply(sizes);
BENCHMARK(iterate_2)->Apply(sizes);
BENCHMARK(iterate_2_range_for)->Apply(sizes);
BENCHMARK(iterate_3_array)->Apply(sizes);
BENCHMARK(iterate_3)->Apply(sizes);
BENCHMARK(iterate_2_scattered_array)->Apply(sizes);
BENCHMARK(iterate_2_scattered)->Apply(sizes);
BENCHMARK(iterate_2_scattered_then_aligned)->Apply(sizes);
BENCHMARK(iterate_2_after_change)->Apply(sizes);

}  // namespace
}  // namespace sl::ecs_bench
