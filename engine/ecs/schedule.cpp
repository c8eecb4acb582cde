// SPDX-License-Identifier: MIT
#include "engine/ecs/schedule.h"

#include <fmt/format.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <chrono>
#include <numeric>

namespace sl {

namespace {

/// Below this much work in a stage, waking other threads costs more than they save. Seconds.
constexpr double worthwhile_seconds = 100e-6;

// Both walk back over the systems before `access`; an edge to a system from which the rest follows ends the
// walk.
void wait_for_writer(const std::vector<System>& before, std::type_index type,
                     std::vector<std::size_t>& waits) {
    for (std::size_t i = before.size(); i-- > 0;) {
        if (!before[i].access.writes_type(type)) continue;
        waits.push_back(i);
        return;
    }
}

void wait_for_users(const std::vector<System>& before, std::type_index type,
                    std::vector<std::size_t>& waits) {
    for (std::size_t i = before.size(); i-- > 0;) {
        const bool writes = before[i].access.writes_type(type);
        if (writes || before[i].access.reads_type(type)) waits.push_back(i);
        if (writes) return;
    }
}

// A query that only filters touches no value, yet the pools must not change under it. Whoever waits for
// anything waits for something at or after the last exclusive system, so only the others need this edge.
void wait_for_exclusive(const std::vector<System>& before, std::vector<std::size_t>& waits) {
    for (std::size_t i = before.size(); i-- > 0;) {
        if (!before[i].access.writes_world) continue;
        waits.push_back(i);
        return;
    }
}

std::vector<std::size_t> waits_of(const std::vector<System>& before, const Access& access) {
    std::vector<std::size_t> waits;
    if (access.reads_world || access.writes_world) {
        for (std::size_t i = before.size(); i-- > 0;) {
            const Access& other = before[i].access;
            if (access.writes_world || other.writes_something()) waits.push_back(i);
            if (other.writes_world) break;
        }
    }
    for (const std::type_index type : access.reads) wait_for_writer(before, type, waits);
    for (const std::type_index type : access.writes) wait_for_users(before, type, waits);
    if (waits.empty()) wait_for_exclusive(before, waits);
    std::sort(waits.begin(), waits.end());
    waits.erase(std::unique(waits.begin(), waits.end()), waits.end());
    return waits;
}

std::string pad(std::string_view text, std::size_t width) {
    return fmt::format("{:<{}}", text, width);
}

}  // namespace

void Schedule::insert(Stage stage, std::string name, Access access,
                      std::function<void(World&, Commands&)> run) {
    for (const std::vector<System>& systems : stages_) {
        for (const System& system : systems) CHECK(system.name != name, "two systems are called {}", name);
    }
    std::vector<System>& systems = stages_[static_cast<std::size_t>(stage)];
    std::vector<std::size_t> waits = waits_of(systems, access);
    systems.push_back({std::move(name), std::move(access), std::move(run), std::move(waits)});
    seconds_[static_cast<std::size_t>(stage)].push_back(0.0);
}

void Schedule::run(World& world) {
    for (std::size_t stage = 0; stage < stage_count; ++stage) run_stage(static_cast<Stage>(stage), world);
}

void Schedule::run_stage(Stage stage, World& world) {
    const auto number = static_cast<std::size_t>(stage);
    Commands commands(world);
    if (parallel_ && worth_parallel(number)) {
        run_in_parallel(number, world, commands);
    } else {
        for (std::size_t i = 0; i < stages_[number].size(); ++i) run_timed(number, i, world, commands);
    }
    commands.apply(world);
}

bool Schedule::worth_parallel(std::size_t stage) const {
    if (static_cast<Stage>(stage) == Stage::input || static_cast<Stage>(stage) == Stage::present)
        return false;
    const std::vector<System>& systems = stages_[stage];
    bool chain = true;
    for (std::size_t i = 1; i < systems.size(); ++i) {
        chain = chain && !systems[i].waits.empty() && systems[i].waits.back() == i - 1;
    }
    if (chain) return false;
    const std::vector<double>& seconds = seconds_[stage];
    const bool measured = std::all_of(seconds.begin(), seconds.end(), [](double s) { return s > 0.0; });
    return !measured || std::accumulate(seconds.begin(), seconds.end(), 0.0) > worthwhile_seconds;
}

void Schedule::run_timed(std::size_t stage, std::size_t system, World& world, Commands& commands) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    stages_[stage][system].run(world, commands);
    seconds_[stage][system] = std::chrono::duration<double>(Clock::now() - start).count();
}

void Schedule::run_in_parallel(std::size_t stage, World& world, Commands& commands) {
    const std::vector<System>& systems = stages_[stage];
    std::vector<std::vector<std::size_t>> followers(systems.size());
    std::vector<std::atomic<std::size_t>> pending(systems.size());
    for (std::size_t i = 0; i < systems.size(); ++i) {
        pending[i] = systems[i].waits.size();
        for (const std::size_t waited_for : systems[i].waits) followers[waited_for].push_back(i);
    }
    tbb::task_group group;
    std::function<void(std::size_t)> run_system = [&](std::size_t i) {
        run_timed(stage, i, world, commands);
        for (const std::size_t follower : followers[i]) {
            if (--pending[follower] == 0) group.run([&run_system, follower] { run_system(follower); });
        }
    };
    for (std::size_t i = 0; i < systems.size(); ++i) {
        if (systems[i].waits.empty()) group.run([&run_system, i] { run_system(i); });
    }
    group.wait();
}

std::vector<SystemTiming> Schedule::timings() const {
    std::vector<SystemTiming> timings;
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        for (std::size_t i = 0; i < stages_[stage].size(); ++i) {
            timings.push_back({stages_[stage][i].name, static_cast<Stage>(stage), seconds_[stage][i]});
        }
    }
    return timings;
}

std::vector<std::string> Schedule::writers_of(std::type_index type) const {
    std::vector<std::string> names;
    for (const std::vector<System>& systems : stages_) {
        for (const System& system : systems) {
            const std::vector<std::type_index>& writes = system.access.writes;
            if (std::find(writes.begin(), writes.end(), type) != writes.end()) names.push_back(system.name);
        }
    }
    return names;
}

std::string Schedule::describe() const {
    using Row = std::array<std::string, 5>;
    std::vector<Row> rows{{"stage", "system", "reads", "writes", "waits for"}};
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        for (const System& system : stages_[stage]) {
            std::string waits;
            for (const std::size_t i : system.waits)
                waits += (waits.empty() ? "" : ", ") + stages_[stage][i].name;
            rows.push_back({std::string(stage_names[stage]), system.name, describe_reads(system.access),
                            describe_writes(system.access), waits.empty() ? "-" : waits});
        }
    }
    std::array<std::size_t, 5> widths{};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i) text += pad(row[i], widths[i] + 2);
        text += row.back() + "\n";
    }
    return text;
}

}  // namespace sl
