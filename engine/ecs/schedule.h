// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/ecs/access.h"
#include "engine/ecs/stage.h"

namespace sl {

/// A registered system: a free function, what its signature says it touches, and whom it waits for.
struct System {
    std::string name;
    Access access;
    std::function<void(World&, Commands&)> run;
    std::vector<std::size_t> waits;  ///< indices of earlier systems of the same stage
};

/// How long a system took.
struct SystemTiming {
    std::string_view name;
    Stage stage = Stage::input;
    double seconds = 0.0;  ///< wall time of the last run, 0 before the first
};

/// The systems of a program by stage. Inside a stage, per component and resource and in order of
/// registration, a writer waits for the readers and the writer before it, a reader for the last writer.
/// Nothing else orders systems.
class Schedule {
  public:
    /// The access list is the function's signature; see SystemParam for what it may take. Names are unique.
    template <class... Params>
    void add(Stage stage, std::string name, void (*function)(Params...)) {
        insert(stage, std::move(name), access_of(function), [function](World& world, Commands& commands) {
            function(SystemParam<Params>::fetch(world, commands)...);
        });
    }

    /// All stages in order. An exception from a system passes through; what its stage recorded is then lost.
    void run(World& world);
    /// One of them, its commands applied at the end.
    void run_stage(Stage stage, World& world);

    /// Off by default. When on, systems of a stage that do not wait for each other run side by side where
    /// that pays; what they compute is the same. Input and present stay on the calling thread, as windows and
    /// GL demand.
    void set_parallel(bool parallel) { parallel_ = parallel; }

    const std::vector<System>& systems(Stage stage) const { return stages_[static_cast<std::size_t>(stage)]; }
    /// By stage and registration. The names point into the schedule.
    std::vector<SystemTiming> timings() const;
    /// Systems that declare to write the component or resource; those that take the whole World& are not
    /// counted.
    template <class T>
    std::vector<std::string> writers_of() const {
        return writers_of(std::type_index(typeid(T)));
    }
    std::vector<std::string> writers_of(std::type_index type) const;
    /// A table for people: stage, system, reads, writes, waits for.
    std::string describe() const;

  private:
    void insert(Stage stage, std::string name, Access access, std::function<void(World&, Commands&)> run);
    bool worth_parallel(std::size_t stage) const;
    void run_timed(std::size_t stage, std::size_t system, World& world, Commands& commands);
    void run_in_parallel(std::size_t stage, World& world, Commands& commands);

    std::array<std::vector<System>, stage_count> stages_;
    std::array<std::vector<double>, stage_count> seconds_;
    bool parallel_ = false;
};

}  // namespace sl
