// SPDX-License-Identifier: MIT
#include "game/settings/key_bindings.h"

#include "engine/core/key_names.h"

namespace sl {

namespace {

using Keys = std::bitset<key_count>;

Keys moved(const Keys& keys, const KeyBindings& bindings) {
    Keys result = keys;
    for (const Key key : bindings.keys) result.reset(static_cast<std::size_t>(key));
    for (const ActionInfo& action : actions) result.reset(static_cast<std::size_t>(action.usual));
    for (std::size_t i = 0; i < action_count; ++i) {
        if (keys[static_cast<std::size_t>(bindings.keys[i])]) result.set(static_cast<std::size_t>(actions[i].usual));
    }
    return result;
}

}  // namespace

void visit_fields(FieldVisitor& visit, KeyBindings& bindings) {
    for (std::size_t i = 0; i < action_count; ++i) {
        visit.enumeration(actions[i].name, bindings.keys[i], key_names(), {.help = actions[i].help});
    }
}

std::vector<Action> conflicts(const KeyBindings& bindings, Action action) {
    std::vector<Action> others;
    for (std::size_t i = 0; i < action_count; ++i) {
        const auto other = static_cast<Action>(i);
        if (other != action && bindings[other] == bindings[action]) others.push_back(other);
    }
    return others;
}

Input with_usual_keys(const Input& input, const KeyBindings& bindings) {
    Input result = input;
    result.keys_down = moved(input.keys_down, bindings);
    result.keys_pressed = moved(input.keys_pressed, bindings);
    result.keys_before = moved(input.keys_before, bindings);
    return result;
}

}  // namespace sl
