// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/core/check.h"

namespace sl {

/// Names a value in a SlotMap: slot and generation. A stale handle finds nothing. Tag keeps kinds of handle apart.
template <class Tag>
struct Handle {
    static constexpr std::uint32_t no_slot = ~0u;
    std::uint32_t slot = no_slot;
    std::uint32_t generation = 0;

    explicit operator bool() const { return slot != no_slot; }
    auto operator<=>(const Handle&) const = default;
};

/// Owns big things (meshes, voxel cells, textures) that components name by handle. Handle kind: Handle<T>.
template <class T>
class SlotMap {
  public:
    using Id = Handle<T>;

    /// Slots of erased values are used again, under another generation.
    Id insert(T value) {
        std::uint32_t slot = 0;
        if (free_.empty()) {
            slot = static_cast<std::uint32_t>(slots_.size());
            slots_.emplace_back();
        } else {
            slot = free_.back();
            free_.pop_back();
        }
        slots_[slot].value.emplace(std::move(value));
        ++count_;
        return {slot, slots_[slot].generation};
    }

    /// Nothing happens for a stale handle.
    void erase(Id id) {
        if (find(id) == nullptr) return;
        slots_[id.slot].value.reset();
        ++slots_[id.slot].generation;
        free_.push_back(id.slot);
        --count_;
    }

    /// Null for a stale handle and for none.
    T* find(Id id) {
        if (id.slot >= slots_.size() || slots_[id.slot].generation != id.generation) return nullptr;
        return slots_[id.slot].value ? &*slots_[id.slot].value : nullptr;
    }
    const T* find(Id id) const { return const_cast<SlotMap*>(this)->find(id); }

    /// Stops on a stale handle.
    T& at(Id id) {
        T* value = find(id);
        CHECK(value != nullptr, "stale handle: slot {}, generation {}", id.slot, id.generation);
        return *value;
    }
    const T& at(Id id) const { return const_cast<SlotMap*>(this)->at(id); }

    std::size_t size() const { return count_; }

    /// Calls visit(id, value) for each living value, in slot order.
    template <class Visit>
    void each(Visit&& visit) const {
        for (std::uint32_t slot = 0; slot < slots_.size(); ++slot) {
            if (slots_[slot].value) visit(Id{slot, slots_[slot].generation}, *slots_[slot].value);
        }
    }

  private:
    struct Slot {
        std::optional<T> value;
        std::uint32_t generation = 1;
    };
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
    std::size_t count_ = 0;
};

}  // namespace sl
