// SPDX-License-Identifier: MIT
#include "game/menu/panel_text.h"

#include <fmt/format.h>

#include "engine/core/key_names.h"

namespace sl {

std::string panel_text(const KeyBindings& keys) {
    return fmt::format(
        "{} opens the editor panel and frees the mouse; the day waits.\n"
        "A click into the picture gives the mouse back to the game.\n"
        "\n"
        "Light    Method of indirect light, and all lamps, sun and sky.\n"
        "Scene    Everything else: entities and what they are made of.\n"
        "Compare  Two pictures side by side, or the path-traced truth.\n"
        "See      Any image of the frame; a click measures its light.\n"
        "Picture  Saves what you see, or the command line for it.\n"
        "Frame    What each pass of the frame costs.\n"
        "\n"
        "Drag a number to change it; Ctrl and a click types one.\n"
        "Ctrl+Z   Undo. Ctrl+Y does it again.\n"
        "Delete   Deletes the chosen entity.",
        key_label(keys[Action::panel]));
}

}  // namespace sl
