// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/world.h"

namespace sl {

/// Changes of structure recorded while queries walk, applied later in the order recorded. What is recorded
/// for an entity that has died by then is dropped in silence. To the schedule this is a resource that each
/// system with a Commands& writes, so such systems run one after another and entities are numbered alike in
/// every run.
class Commands {
  public:
    /// The world must outlive it.
    explicit Commands(World& world) : world_(&world) {}

    /// The entity lives at once, so that its name can be stored; its components come with apply.
    Entity create() { return world_->create(); }
    template <class... T>
    requires(sizeof...(T) > 0) Entity create(T... components) {
        const Entity entity = world_->create();
        (add(entity, std::move(components)), ...);
        return entity;
    }
    /// Dies with apply.
    void destroy(Entity entity) { record(entity, &run_destroy, nullptr, 0); }

    /// Comes with apply, and replaces what is there by then.
    template <class T>
    void add(Entity entity, T value = {}) {
        Values<T>& values = values_of<T>();
        values.items.push_back(std::move(value));
        record(entity, &run_add<T>, &values, values.items.size() - 1);
    }
    /// Goes with apply.
    template <class T>
    void remove(Entity entity) {
        record(entity, &run_remove<T>, nullptr, 0);
    }

    /// Carries everything out and forgets it. `world` is the one given at construction.
    void apply(World& world);
    bool empty() const { return recorded_.empty(); }

  private:
    struct AnyValues {
        virtual ~AnyValues() = default;
        virtual void clear() = 0;
    };
    template <class T>
    struct Values final : AnyValues {
        std::vector<T> items;
        void clear() override { items.clear(); }
    };
    using Run = void (*)(World&, Entity, AnyValues*, std::size_t);
    struct Command {
        Entity entity;
        Run run;
        AnyValues* values;
        std::size_t item;
    };

    static void run_destroy(World& world, Entity entity, AnyValues*, std::size_t) { world.destroy(entity); }
    template <class T>
    static void run_add(World& world, Entity entity, AnyValues* values, std::size_t item) {
        world.add(entity, std::move(static_cast<Values<T>*>(values)->items[item]));
    }
    template <class T>
    static void run_remove(World& world, Entity entity, AnyValues*, std::size_t) {
        world.remove<T>(entity);
    }

    void record(Entity entity, Run run, AnyValues* values, std::size_t item) {
        recorded_.push_back({entity, run, values, item});
    }
    template <class T>
    Values<T>& values_of() {
        const std::size_t number = type_number<Commands, T>();
        if (number >= values_.size()) values_.resize(number + 1);
        if (values_[number] == nullptr) values_[number] = std::make_unique<Values<T>>();
        return static_cast<Values<T>&>(*values_[number]);
    }

    World* world_;
    std::vector<Command> recorded_;
    std::vector<std::unique_ptr<AnyValues>> values_;
};

}  // namespace sl
