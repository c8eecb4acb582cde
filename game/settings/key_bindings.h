// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/core/fields.h"
#include "game/settings/actions.h"

namespace sl {

/// The key of each action.
struct KeyBindings {
    std::array<Key, action_count> keys;

    KeyBindings() {
        for (std::size_t i = 0; i < action_count; ++i) keys[i] = actions[i].usual;
    }
    Key& operator[](Action action) { return keys[static_cast<std::size_t>(action)]; }
    Key operator[](Action action) const { return keys[static_cast<std::size_t>(action)]; }
    bool operator==(const KeyBindings&) const = default;
};

void visit_fields(FieldVisitor& visit, KeyBindings& bindings);

/// The other actions on the same key.
std::vector<Action> conflicts(const KeyBindings& bindings, Action action);

/// The input as systems read it: an action's key under the action's usual name. A key that an action was put on means that
/// and nothing else; keys of no action mean themselves.
Input with_usual_keys(const Input& input, const KeyBindings& bindings);

}  // namespace sl
