// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <iterator>
#include <optional>
#include <span>

#include "engine/ecs/query_term.h"
#include "engine/ecs/world.h"

namespace sl {

/// The entities that have all components in `Terms`. A const component is read, another may be written: as a
/// parameter of a system the type is also the declaration of its access. Query<const A, B, With<C>,
/// Without<D>, Maybe<const E>>.
///     query.each([](Entity entity, const A& a, B& b, const E* e) { … });   // the entity may be left out
///     for (auto [entity, a, b, e] : query) …                               // the same
/// The order is that of the smallest pool: repeatable, but nothing to rely on. Adding or removing these
/// components while walking is a mistake and stops; record it in Commands. Cheap to make: make one where it
/// is needed, since it does not see component types that were first used after it was made.
template <class... Terms>
class Query {
    static constexpr std::size_t term_count = sizeof...(Terms);
    static constexpr std::size_t required_count =
        (std::size_t{0} + ... + (QueryTerm<Terms>::required ? 1 : 0));
    static constexpr bool only_required = required_count == term_count;
    static constexpr bool read_only = !(false || ... || QueryTerm<Terms>::writes);
    static_assert(required_count > 0, "a query needs a component that its entities have");
    using Every = std::index_sequence_for<Terms...>;
    using Positions = std::array<std::uint32_t, term_count>;

  public:
    using Item = decltype(std::tuple_cat(std::tuple<Entity>(), QueryTerm<Terms>::item(nullptr, 0)...));

    explicit Query(World& world)
        : pools_(world.find_pool<typename QueryTerm<Terms>::Component>()...),
          alignments_(&world.alignments()) {}
    explicit Query(const World& world) requires read_only : Query(const_cast<World&>(world)) {}

    template <class F>
    void each(F&& visit) const {
        if (!complete()) return;
        const auto pins = pin(Every{});
        const auto required = required_pools();
        if constexpr (required_count == 1) {
            walk_aligned(visit, {0, required[0]->size(), true}, *required[0], Every{});
        } else {
            const Alignment& alignment = alignments_->find(key(), required);
            const PoolIndex& leader = *required[alignment.leader];
            for (const Stretch& stretch : alignment.stretches) {
                if (stretch.aligned) {
                    walk_aligned(visit, stretch, leader, Every{});
                } else {
                    walk_scattered(visit, stretch, leader, Every{});
                }
            }
        }
    }

    class Iterator;
    Iterator begin() const { return Iterator(*this, required_count > 1); }
    std::default_sentinel_t end() const { return {}; }

    /// At most so many entities match.
    std::size_t size_hint() const { return complete() ? leader().size() : 0; }
    /// Some matching entity with its components, or nothing.
    std::optional<Item> first() const {
        const Iterator found(*this, false);
        return found == end() ? std::nullopt : std::optional<Item>(*found);
    }
    bool contains(Entity entity) const { return complete() && positions(entity, Every{}).has_value(); }
    /// One entity's components, or nothing where it does not match.
    std::optional<Item> find(Entity entity) const {
        if (!complete()) return std::nullopt;
        const std::optional<Positions> at = positions(entity, Every{});
        return at ? std::optional<Item>(item(entity, *at, Every{})) : std::nullopt;
    }

  private:
    template <std::size_t I>
    using Term = QueryTerm<std::tuple_element_t<I, std::tuple<Terms...>>>;

    // Queries that differ only in const and in filters without pools walk the same tuple of pools.
    static std::uint32_t key() {
        return type_number<
            AlignmentCache,
            decltype(std::tuple_cat(
                std::conditional_t<QueryTerm<Terms>::required,
                                   std::tuple<typename QueryTerm<Terms>::Component*>, std::tuple<>>()...))>();
    }

    // A pool that nobody used yet does not exist, and for a required one that means no entity.
    bool complete() const { return complete(Every{}); }
    template <std::size_t... I>
    bool complete(std::index_sequence<I...>) const {
        return ((!Term<I>::required || std::get<I>(pools_) != nullptr) && ...);
    }
    template <std::size_t... I>
    std::array<PoolIndex::Pin, term_count> pin(std::index_sequence<I...>) const {
        return {PoolIndex::Pin(std::get<I>(pools_))...};
    }
    std::array<const PoolIndex*, required_count> required_pools() const {
        std::array<const PoolIndex*, required_count> required{};
        std::size_t count = 0;
        const auto collect = [&](bool is_required, const PoolIndex* pool) {
            if (is_required) required[count++] = pool;
        };
        std::apply([&](const auto*... pool) { (collect(QueryTerm<Terms>::required, pool), ...); }, pools_);
        return required;
    }
    const PoolIndex& leader() const {
        const auto required = required_pools();
        return **std::min_element(
            required.begin(), required.end(),
            [](const PoolIndex* a, const PoolIndex* b) { return a->size() < b->size(); });
    }

    std::uint64_t version() const {
        const auto of = [](const PoolIndex* pool) { return pool == nullptr ? 0 : pool->version(); };
        return std::apply([&](const auto*... pool) { return (of(pool) + ...); }, pools_);
    }

    template <std::size_t I>
    auto values() const {
        using Value = typename decltype(std::get<I>(pools_)->values())::element_type;
        return std::get<I>(pools_) == nullptr ? static_cast<Value*>(nullptr)
                                              : std::get<I>(pools_)->values().data();
    }
    template <std::size_t I>
    std::uint32_t look_up(Entity entity) const {
        return std::get<I>(pools_) == nullptr ? PoolIndex::none : std::get<I>(pools_)->position(entity);
    }
    // As above, for the entity at a position of the leading pool, which needs no look-up in that pool itself.
    template <std::size_t I>
    std::uint32_t look_up(const PoolIndex& leader, std::uint32_t position) const {
        if (std::get<I>(pools_) == &leader) return position;
        return look_up<I>(leader.entities()[position]);
    }
    template <std::size_t I>
    static bool admits(std::uint32_t position) {
        if constexpr (Term<I>::required) return position != PoolIndex::none;
        return Term<I>::kind != TermKind::without || position == PoolIndex::none;
    }

    template <std::size_t... I>
    std::optional<Positions> positions(Entity entity, std::index_sequence<I...>) const {
        Positions at{};
        const bool matches = ((at[I] = look_up<I>(entity), admits<I>(at[I])) && ...);
        return matches ? std::optional<Positions>(at) : std::nullopt;
    }
    template <std::size_t... I>
    Item item(Entity entity, const Positions& at, std::index_sequence<I...>) const {
        return std::tuple_cat(std::tuple<Entity>(entity), Term<I>::item(values<I>(), at[I])...);
    }

    template <class F, class... Items>
    static void call(F& visit, Entity entity, Items&&... items) {
        std::apply(
            [&](auto&&... values) {
                if constexpr (std::is_invocable_v<F&, Entity, decltype(values)...>) {
                    visit(entity, std::forward<decltype(values)>(values)...);
                } else {
                    visit(std::forward<decltype(values)>(values)...);
                }
            },
            std::tuple_cat(std::forward<Items>(items)...));
    }

    template <class F, std::size_t... I>
    void walk_aligned(F& visit, Stretch stretch, const PoolIndex& leader, std::index_sequence<I...>) const {
        const std::tuple arrays{values<I>()...};
        const Entity* entities = leader.entities().data();
        const std::size_t last = stretch.last;
        for (std::size_t i = stretch.first; i < last; ++i) {
            if constexpr (only_required) {
                call(visit, entities[i], Term<I>::item(std::get<I>(arrays), i)...);
            } else {
                const Positions at{
                    (Term<I>::required ? static_cast<std::uint32_t>(i) : look_up<I>(entities[i]))...};
                if (!(admits<I>(at[I]) && ...)) continue;
                call(visit, entities[i], Term<I>::item(std::get<I>(arrays), at[I])...);
            }
        }
    }
    template <class F, std::size_t... I>
    void walk_scattered(F& visit, Stretch stretch, const PoolIndex& leader, std::index_sequence<I...>) const {
        const std::tuple arrays{values<I>()...};
        const Entity* entities = leader.entities().data();
        for (std::uint32_t i = stretch.first; i < stretch.last; ++i) {
            Positions at{};
            const bool matches = ((at[I] = look_up<I>(leader, i), admits<I>(at[I])) && ...);
            if (matches) call(visit, entities[i], Term<I>::item(std::get<I>(arrays), at[I])...);
        }
    }

    std::tuple<typename QueryTerm<Terms>::Pool*...> pools_;
    AlignmentCache* alignments_;
};

/// Walks the entities that match.
template <class... Terms>
class Query<Terms...>::Iterator {
  public:
    using value_type = Item;
    using difference_type = std::ptrdiff_t;

    /// `by_stretches`: asks where pools lie in one order, which takes a walk of its own after they changed; else each
    /// entity is looked up in each pool.
    Iterator(const Query& query, bool by_stretches) : query_(&query) {
        if (!query.complete()) return;
        leader_ = &query.leader();
        if (by_stretches) {
            const auto required = query.required_pools();
            const Alignment& alignment = query.alignments_->find(key(), required);
            leader_ = required[alignment.leader];
            stretches_ = alignment.stretches;
        }
        version_ = query.version();
        settle();
    }
    Item operator*() const { return query_->item(leader_->entities()[at_], positions_, Every{}); }
    Iterator& operator++() {
        CHECK(query_->version() == version_,
              "a component is added or removed while a query walks over its pool: use Commands");
        ++at_;
        settle();
        return *this;
    }
    void operator++(int) { ++*this; }
    bool operator==(std::default_sentinel_t) const { return leader_ == nullptr || at_ == leader_->size(); }

  private:
    // Moves on to the next entity that matches.
    void settle() {
        for (; *this != std::default_sentinel; ++at_) {
            while (!stretches_.empty() && at_ >= stretches_.front().last) stretches_ = stretches_.subspan(1);
            if constexpr (only_required) {
                if (!stretches_.empty() && stretches_.front().aligned) return positions_.fill(at_);
            }
            const std::optional<Positions> found = query_->positions(leader_->entities()[at_], Every{});
            if (!found) continue;
            positions_ = *found;
            return;
        }
    }

    const Query* query_;
    const PoolIndex* leader_ = nullptr;
    std::span<const Stretch> stretches_;  ///< from the one that holds `at_` on; empty: not asked for
    std::uint64_t version_ = 0;
    std::uint32_t at_ = 0;
    Positions positions_{};
};

}  // namespace sl
