// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <typeindex>
#include <vector>

#include "engine/ecs/commands.h"
#include "engine/ecs/query.h"

namespace sl {

/// What a system may touch. A component type and a resource type are told apart by nothing but their type.
struct Access {
    std::vector<std::type_index> reads;
    std::vector<std::type_index> writes;
    bool reads_world = false;   ///< takes const World&: reads everything
    bool writes_world = false;  ///< takes World&: alone among all

    void add_read(std::type_index type);
    /// A type that is written is not listed as read.
    void add_write(std::type_index type);

    bool reads_type(std::type_index type) const;
    bool writes_type(std::type_index type) const;
    bool writes_something() const { return writes_world || !writes.empty(); }
};

/// "Transform, MeshPool", "everything", or "-" for nothing.
std::string describe_reads(const Access& access);
/// The same of what is written.
std::string describe_writes(const Access& access);

/// How a parameter of a system is declared and filled. Write `const Res&` or `Res&` for a resource; also
/// allowed are `Query<…>`, Commands&, const World& and World&.
template <class Param>
struct SystemParam {
    static_assert(std::is_lvalue_reference_v<Param>,
                  "a system takes Query<...>, const Resource&, Resource&, Commands&, const World& or World&");
    using Resource = std::remove_cvref_t<Param>;
    static void declare(Access& access) {
        if constexpr (std::is_const_v<std::remove_reference_t<Param>>) {
            access.add_read(typeid(Resource));
        } else {
            access.add_write(typeid(Resource));
        }
    }
    static Param fetch(World& world, Commands&) { return world.resource<Resource>(); }
};

/// Its terms tell what it reads and writes.
template <class... Terms>
struct SystemParam<Query<Terms...>> {
    static void declare(Access& access) { (declare_term<QueryTerm<Terms>>(access), ...); }
    static Query<Terms...> fetch(World& world, Commands&) { return Query<Terms...>(world); }

  private:
    template <class Term>
    static void declare_term(Access& access) {
        if constexpr (Term::writes) {
            access.add_write(typeid(typename Term::Component));
        } else if constexpr (Term::accessed) {
            access.add_read(typeid(typename Term::Component));
        }
    }
};
template <class... Terms>
struct SystemParam<const Query<Terms...>&> : SystemParam<Query<Terms...>> {};

/// Those who record changes run one after another, so that entities are numbered alike in every run.
template <>
struct SystemParam<Commands&> {
    static void declare(Access& access) { access.add_write(typeid(Commands)); }
    static Commands& fetch(World&, Commands& commands) { return commands; }
};
/// Runs alone.
template <>
struct SystemParam<World&> {
    static void declare(Access& access) { access.writes_world = true; }
    static World& fetch(World& world, Commands&) { return world; }
};
/// Waits for every writer.
template <>
struct SystemParam<const World&> {
    static void declare(Access& access) { access.reads_world = true; }
    static const World& fetch(World& world, Commands&) { return world; }
};

/// What a system touches, as its parameters say.
template <class... Params>
Access access_of(void (*)(Params...)) {
    Access access;
    (SystemParam<Params>::declare(access), ...);
    return access;
}

}  // namespace sl
