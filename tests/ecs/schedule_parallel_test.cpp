// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <thread>

#include "engine/core/error.h"
#include "engine/ecs/schedule.h"

namespace sl {
namespace {

struct A {
    std::uint32_t value = 0;
};
struct B {
    std::uint32_t value = 0;
};
struct C {
    std::uint32_t value = 0;
};
struct Frame {
    std::uint32_t number = 0;
};

std::uint32_t scramble(std::uint32_t value) {
    for (int i = 0; i < 20; ++i) value = value * 1664525u + 1013904223u;
    return value;
}

void grow_a(Query<A> query, const Frame& frame) {
    query.each([&](A& a) { a.value = scramble(a.value + frame.number); });
}
void grow_b(Query<B> query) {
    query.each([](B& b) { b.value = scramble(b.value); });
}
void b_from_a(Query<const A, B> query) {
    query.each([](const A& a, B& b) { b.value ^= a.value; });
}
void c_from_a(Query<const A, C> query) {
    query.each([](const A& a, C& c) { c.value += scramble(a.value); });
}
void a_from_c(Query<A, const C> query) {
    query.each([](A& a, const C& c) { a.value -= c.value; });
}
void spawn(Query<const B> query, Commands& commands) {
    for (auto [entity, b] : query) {
        if (b.value % 97 == 0) commands.create(A{b.value}, B{b.value}, C{1});
        if (b.value % 101 == 0) commands.destroy(entity);
    }
}
void mutate(Query<const C> query, Commands& commands) {
    query.each([&](Entity entity, const C& c) {
        if (c.value % 89 == 0) commands.remove<B>(entity);
        if (c.value % 83 == 0) commands.add(commands.create(A{2}), C{c.value});
    });
}
void count_up(Frame& frame, World& world) {
    ++frame.number;
    if (frame.number % 3 == 0) world.create(A{frame.number});
}

std::vector<std::uint32_t> result_of(bool parallel) {
    World world;
    world.add_resource(Frame{});
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const Entity entity = world.create(A{i}, B{i});
        if (i % 2 == 0) world.add(entity, C{i});
    }
    Schedule schedule;
    schedule.set_parallel(parallel);
    schedule.add(Stage::simulate, "grow a", &grow_a);
    schedule.add(Stage::simulate, "grow b", &grow_b);
    schedule.add(Stage::simulate, "spawn", &spawn);
    schedule.add(Stage::simulate, "c from a", &c_from_a);
    schedule.add(Stage::simulate, "b from a", &b_from_a);
    schedule.add(Stage::simulate, "mutate", &mutate);
    schedule.add(Stage::simulate, "a from c", &a_from_c);
    schedule.add(Stage::simulate, "count up", &count_up);
    schedule.add(Stage::derive, "b again", &b_from_a);
    schedule.add(Stage::derive, "c again", &c_from_a);
    for (int frame = 0; frame < 20; ++frame) schedule.run(world);

    std::vector<std::uint32_t> numbers;
    for (auto [entity, a, b, c] : Query<const A, Maybe<const B>, Maybe<const C>>(world)) {
        numbers.insert(numbers.end(), {entity.index, entity.generation, a.value, b == nullptr ? 0 : b->value,
                                       c == nullptr ? 0 : c->value});
    }
    return numbers;
}

TEST(ScheduleParallel, computes_what_the_serial_one_computes) {
    const std::vector<std::uint32_t> serial = result_of(false);
    ASSERT_GT(serial.size(), 1000u);
    for (int attempt = 0; attempt < 5; ++attempt) EXPECT_EQ(result_of(true), serial);
}

struct Meeting {
    std::atomic<int> arrived{0};
};

// Both systems wait for the other one to have begun: only a schedule that runs them side by side gets both
// through.
void meet(const Meeting& shared) {
    auto& meeting = const_cast<Meeting&>(shared);
    ++meeting.arrived;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (meeting.arrived < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
}

TEST(ScheduleParallel, runs_systems_without_conflict_side_by_side) {
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one processor";
    World world;
    world.emplace_resource<Meeting>();
    Schedule schedule;
    schedule.set_parallel(true);
    schedule.add(Stage::simulate, "one", &meet);
    schedule.add(Stage::simulate, "other", &meet);
    const auto start = std::chrono::steady_clock::now();
    schedule.run(world);
    EXPECT_EQ(world.resource<Meeting>().arrived, 2);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(9));
}

struct Threads {
    std::mutex mutex;
    std::set<std::thread::id> seen;
};
void note_thread(const Threads& shared) {
    auto& threads = const_cast<Threads&>(shared);
    const std::lock_guard lock(threads.mutex);
    threads.seen.insert(std::this_thread::get_id());
}

TEST(ScheduleParallel, input_and_present_stay_on_the_calling_thread) {
    World world;
    world.emplace_resource<Threads>();
    Schedule schedule;
    schedule.set_parallel(true);
    for (int i = 0; i < 8; ++i) {
        schedule.add(Stage::input, "input " + std::to_string(i), &note_thread);
        schedule.add(Stage::present, "present " + std::to_string(i), &note_thread);
    }
    for (int i = 0; i < 10; ++i) schedule.run(world);
    EXPECT_EQ(world.resource<Threads>().seen, std::set{std::this_thread::get_id()});
}

void fails(Query<const A>) {
    fail("the scene is broken");
}

TEST(ScheduleParallel, an_error_passes_through) {
    World world;
    Schedule schedule;
    schedule.add(Stage::simulate, "fails", &fails);
    schedule.add(Stage::simulate, "other", &grow_b);
    EXPECT_THROW(schedule.run(world), Error);
    schedule.set_parallel(true);
    EXPECT_THROW(schedule.run(world), Error);
}

}  // namespace
}  // namespace sl
