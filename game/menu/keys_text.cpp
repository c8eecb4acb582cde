// SPDX-License-Identifier: MIT
#include "game/menu/keys_text.h"

#include <fmt/ranges.h>

#include <vector>

#include "engine/core/key_names.h"

namespace sl {

namespace {

/// Keys on one line.
struct KeyGroup {
    std::vector<Action> actions;
    std::string_view help;
};

std::vector<KeyGroup> key_groups() {
    return {{{Action::forward, Action::left, Action::back, Action::right}, "Walk or fly."},
            {{Action::rise, Action::sink}, "Fly up, down; Ctrl and the wheel: speed."},
            {{Action::sun_left, Action::sun_right}, "Turn the sun; so do Left, Right. Up, Down: its height."},
            {{Action::brighter, Action::darker}, "Brighten and darken the picture."}};
}

std::string line(const std::vector<Action>& group, std::string_view help, const KeyBindings& keys) {
    std::vector<std::string> labels;
    for (const Action action : group) labels.push_back(key_label(keys[action]));
    return fmt::format("{:<14} {}\n", fmt::format("{}", fmt::join(labels, " ")), help);
}

}  // namespace

std::string keys_text(const KeyBindings& keys) {
    std::string text =
        "Click          Capture the mouse, then:\n"
        "  left         Break a block.\n"
        "  right        Place a block.\n"
        "  middle       Take the kind of block.\n"
        "1 ... 9        Choose a block; so does the wheel.\n";
    const std::vector<KeyGroup> groups = key_groups();
    for (std::size_t i = 0; i < action_count; ++i) {
        const auto action = static_cast<Action>(i);
        const auto group = std::ranges::find_if(groups, [&](const KeyGroup& one) { return std::ranges::find(one.actions, action) != one.actions.end(); });
        if (group == groups.end()) {
            text += line({action}, actions[i].help, keys);
        } else if (group->actions.front() == action) {
            text += line(group->actions, group->help, keys);
        }
    }
    return text +
           "Escape         Menu.\n"
           "Ctrl+Q         Quit.";
}

}  // namespace sl
