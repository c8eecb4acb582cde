// SPDX-License-Identifier: MIT
#include "engine/ecs/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "engine/core/error.h"

namespace sl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct A {
    int value = 0;
};
struct B {
    int value = 0;
};
struct C {
    int value = 0;
};
struct Trace {
    std::string text;
};

void read_a(Query<const A>) {}
void read_a_again(Query<const A>) {}
void write_a(Query<A>) {}
void write_a_from_b(Query<A, const B>) {}
void write_b(Query<B>) {}
void read_b(Query<const B>) {}
void only_filter(Query<With<A>>) {}
void nothing() {}
void record(Commands&) {}
void record_more(Commands&, Query<const B>) {}
void alone(World&) {}
void look_at_all(const World&) {}

struct Waits : testing::Test {
    Schedule schedule;

    template <class... Params>
    void add(std::string name, void (*function)(Params...), Stage stage = Stage::simulate) {
        schedule.add(stage, std::move(name), function);
    }
    std::vector<std::string> of(std::string_view name, Stage stage = Stage::simulate) const {
        const std::vector<System>& systems = schedule.systems(stage);
        std::vector<std::string> names;
        for (const System& system : systems) {
            if (system.name != name) continue;
            for (const std::size_t i : system.waits) names.push_back(systems[i].name);
        }
        return names;
    }
};

TEST_F(Waits, a_reader_waits_for_the_last_writer_only) {
    add("write 1", &write_a);
    add("write 2", &write_a);
    add("read", &read_a);
    EXPECT_THAT(of("write 1"), IsEmpty());
    EXPECT_THAT(of("write 2"), ElementsAre("write 1"));
    EXPECT_THAT(of("read"), ElementsAre("write 2"));
}

TEST_F(Waits, a_writer_waits_for_the_readers_and_the_writer_before) {
    add("read 0", &read_a);
    add("write 1", &write_a);
    add("read 1", &read_a);
    add("read 2", &read_a_again);
    add("write 2", &write_a);
    EXPECT_THAT(of("write 1"), ElementsAre("read 0"));
    EXPECT_THAT(of("write 2"), ElementsAre("write 1", "read 1", "read 2"));
}

TEST_F(Waits, readers_and_strangers_do_not_wait) {
    add("read 1", &read_a);
    add("read 2", &read_a_again);
    add("write b", &write_b);
    add("nothing", &nothing);
    add("filter", &only_filter);
    EXPECT_THAT(of("read 2"), IsEmpty());
    EXPECT_THAT(of("write b"), IsEmpty());
    EXPECT_THAT(of("nothing"), IsEmpty());
    EXPECT_THAT(of("filter"), IsEmpty());
}

TEST_F(Waits, each_type_counts_for_itself) {
    add("write b", &write_b);
    add("read a", &read_a);
    add("read b", &read_b);
    add("a from b", &write_a_from_b);
    EXPECT_THAT(of("a from b"), ElementsAre("write b", "read a"));
}

TEST_F(Waits, the_whole_world_waits_for_all_and_all_wait_for_it) {
    add("read a", &read_a);
    add("write b", &write_b);
    add("nothing", &nothing);
    add("alone", &alone);
    add("filter", &only_filter);
    add("read b", &read_b);
    add("alone again", &alone);
    add("write a", &write_a);
    EXPECT_THAT(of("alone"), ElementsAre("read a", "write b", "nothing"));
    EXPECT_THAT(of("filter"), ElementsAre("alone"));
    EXPECT_THAT(of("read b"), ElementsAre("alone"));
    EXPECT_THAT(of("alone again"), ElementsAre("alone", "filter", "read b"));
    EXPECT_THAT(of("write a"), ElementsAre("alone again"));
}

TEST_F(Waits, reading_the_whole_world_waits_for_writers) {
    add("read a", &read_a);
    add("write b", &write_b);
    add("record", &record);
    add("look", &look_at_all);
    add("look again", &look_at_all);
    add("read b", &read_b);
    add("write a", &write_a);
    EXPECT_THAT(of("look"), ElementsAre("write b", "record"));
    EXPECT_THAT(of("look again"), ElementsAre("write b", "record"));
    EXPECT_THAT(of("read b"), ElementsAre("write b"));
    EXPECT_THAT(of("write a"), ElementsAre("read a", "look", "look again"));
}

TEST_F(Waits, commands_are_recorded_one_system_after_another) {
    add("record", &record);
    add("read a", &read_a);
    add("record more", &record_more);
    EXPECT_THAT(of("record more"), ElementsAre("record"));
}

TEST_F(Waits, stages_are_apart) {
    add("write", &write_a, Stage::input);
    add("read", &read_a, Stage::derive);
    EXPECT_THAT(of("read", Stage::derive), IsEmpty());
}

void trace_input(Trace& trace) {
    trace.text += "i";
}
void trace_simulate(Trace& trace) {
    trace.text += "s";
}
void trace_derive(Trace& trace) {
    trace.text += "d";
}
void trace_present(Trace& trace) {
    trace.text += "p";
}

TEST(Schedule, runs_stages_in_order_whatever_the_registration) {
    Schedule schedule;
    schedule.add(Stage::present, "present", &trace_present);
    schedule.add(Stage::derive, "derive", &trace_derive);
    schedule.add(Stage::input, "input", &trace_input);
    schedule.add(Stage::simulate, "simulate", &trace_simulate);
    World world;
    world.add_resource(Trace{});
    schedule.run(world);
    EXPECT_EQ(world.resource<Trace>().text, "isdp");
    schedule.run_stage(Stage::derive, world);
    EXPECT_EQ(world.resource<Trace>().text, "isdpd");
}

void spawn(Commands& commands, Trace& trace) {
    commands.create(A{1});
    trace.text += "spawn ";
}
void count_now(Query<const A> query, Trace& trace) {
    trace.text += std::to_string(query.size_hint()) + " ";
}
void count_later(Query<const A> query, Trace& trace) {
    trace.text += std::to_string(query.size_hint());
}

TEST(Schedule, applies_commands_at_the_end_of_the_stage) {
    Schedule schedule;
    schedule.add(Stage::simulate, "spawn", &spawn);
    schedule.add(Stage::simulate, "count now", &count_now);
    schedule.add(Stage::derive, "count later", &count_later);
    World world;
    world.add_resource(Trace{});
    schedule.run(world);
    EXPECT_EQ(world.resource<Trace>().text, "spawn 0 1");
}

TEST(Schedule, describes_itself_as_a_table) {
    Schedule schedule;
    schedule.add(Stage::simulate, "b", &write_b);
    schedule.add(Stage::simulate, "a from b", &write_a_from_b);
    schedule.add(Stage::derive, "record", &record_more);
    schedule.add(Stage::present, "alone", &alone);
    EXPECT_EQ(schedule.describe(),
              "stage     system    reads  writes      waits for\n"
              "simulate  b         -      B           -\n"
              "simulate  a from b  B      A           b\n"
              "derive    record    B      Commands    -\n"
              "present   alone     -      everything  -\n");
}

TEST(Schedule, names_the_writers_of_a_type) {
    Schedule schedule;
    schedule.add(Stage::simulate, "a", &write_a);
    schedule.add(Stage::derive, "a from b", &write_a_from_b);
    schedule.add(Stage::derive, "read", &read_a);
    schedule.add(Stage::derive, "alone", &alone);
    EXPECT_THAT(schedule.writers_of<A>(), ElementsAre("a", "a from b"));
    EXPECT_THAT(schedule.writers_of<B>(), IsEmpty());
}

void burn(Trace&) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(3);
    while (std::chrono::steady_clock::now() < end) {
    }
}

TEST(Schedule, times_each_system) {
    Schedule schedule;
    schedule.add(Stage::simulate, "nothing", &nothing);
    schedule.add(Stage::derive, "burn", &burn);
    EXPECT_EQ(schedule.timings()[1].seconds, 0.0);
    World world;
    world.add_resource(Trace{});
    schedule.run(world);
    const std::vector<SystemTiming> timings = schedule.timings();
    ASSERT_EQ(timings.size(), 2u);
    EXPECT_EQ(timings[1].name, "burn");
    EXPECT_EQ(timings[1].stage, Stage::derive);
    EXPECT_GE(timings[1].seconds, 3e-3);
    EXPECT_LT(timings[0].seconds, timings[1].seconds);
}

TEST(ScheduleDeathTest, mistakes_stop) {
    Schedule schedule;
    schedule.add(Stage::input, "trace", &trace_input);
    EXPECT_DEATH(schedule.add(Stage::derive, "trace", &trace_derive), "two systems are called trace");
    World world;
    EXPECT_DEATH(schedule.run(world), "no resource Trace");
}

}  // namespace
}  // namespace sl
