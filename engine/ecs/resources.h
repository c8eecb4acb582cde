// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/core/check.h"
#include "engine/ecs/type_name.h"
#include "engine/ecs/type_number.h"

namespace sl {

/// At most one value of each type: what a world has once (clock, mesh pool, input). References hold until the
/// same type is emplaced again or removed.
class Resources {
  public:
    /// Replaces the one that is there. Any type, also one that cannot be moved.
    template <class R, class... Args>
    R& emplace(Args&&... args) {
        const std::size_t number = type_number<Resources, R>();
        if (number >= boxes_.size()) boxes_.resize(number + 1);
        auto box = std::make_unique<Box<R>>(std::forward<Args>(args)...);
        R& value = box->value;
        boxes_[number] = std::move(box);
        return value;
    }
    template <class R>
    R& add(R value) {
        return emplace<R>(std::move(value));
    }

    template <class R>
    void remove() {
        const std::size_t number = type_number<Resources, R>();
        if (number < boxes_.size()) boxes_[number].reset();
    }

    /// Null where there is none.
    template <class R>
    R* find() {
        const std::size_t number = type_number<Resources, R>();
        if (number >= boxes_.size() || boxes_[number] == nullptr) return nullptr;
        return &static_cast<Box<R>&>(*boxes_[number]).value;
    }
    template <class R>
    const R* find() const {
        return const_cast<Resources*>(this)->find<R>();
    }

    /// It must be there; stops with its name where it is not.
    template <class R>
    R& get() {
        R* value = find<R>();
        CHECK(value != nullptr, "the world has no resource {}", type_name<R>());
        return *value;
    }
    template <class R>
    const R& get() const {
        return const_cast<Resources*>(this)->get<R>();
    }

  private:
    struct AnyBox {
        virtual ~AnyBox() = default;
    };
    template <class R>
    struct Box final : AnyBox {
        template <class... Args>
        explicit Box(Args&&... args) : value(make(std::forward<Args>(args)...)) {}
        // Aggregates take braces, which would mean a list of elements to a container.
        template <class... Args>
        static R make(Args&&... args) {
            if constexpr (std::is_constructible_v<R, Args...>) {
                return R(std::forward<Args>(args)...);
            } else {
                return R{std::forward<Args>(args)...};
            }
        }
        R value;
    };

    std::vector<std::unique_ptr<AnyBox>> boxes_;
};

}  // namespace sl
