// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <type_traits>

#include "engine/ecs/component_pool.h"

namespace sl {

/// Filters of a query: only entities that have, or do not have, the component. Its value is neither read nor
/// passed.
template <class T>
struct With {};
template <class T>
struct Without {};
/// Passes a pointer that is null where the entity lacks the component.
template <class T>
struct Maybe {};

/// What a query does with a component.
enum class TermKind { value, with, without, maybe };

/// What all terms tell of themselves.
template <class T, TermKind Kind>
struct QueryTermBase {
    using Component = std::remove_const_t<T>;
    using Pool =
        std::conditional_t<std::is_const_v<T>, const ComponentPool<Component>, ComponentPool<Component>>;
    static constexpr TermKind kind = Kind;
    /// Whether a visited entity has the component.
    static constexpr bool required = Kind == TermKind::value || Kind == TermKind::with;
    static constexpr bool accessed = Kind == TermKind::value || Kind == TermKind::maybe;
    static constexpr bool writes = accessed && !std::is_const_v<T>;
};

/// What one template argument of a query stands for. `item` is what the visitor receives for it, none or one
/// value.
template <class T>
struct QueryTerm : QueryTermBase<T, TermKind::value> {
    static std::tuple<T&> item(T* values, std::size_t position) { return {values[position]}; }
};
/// Passes nothing.
template <class T>
struct QueryTerm<With<T>> : QueryTermBase<const T, TermKind::with> {
    static std::tuple<> item(const T*, std::size_t) { return {}; }
};
/// Passes nothing.
template <class T>
struct QueryTerm<Without<T>> : QueryTermBase<const T, TermKind::without> {
    static std::tuple<> item(const T*, std::size_t) { return {}; }
};
/// Passes a pointer, null where the entity lacks the component.
template <class T>
struct QueryTerm<Maybe<T>> : QueryTermBase<T, TermKind::maybe> {
    static std::tuple<T*> item(T* values, std::size_t position) {
        return {position == PoolIndex::none ? nullptr : values + position};
    }
};

}  // namespace sl
