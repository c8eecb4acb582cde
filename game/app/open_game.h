// SPDX-License-Identifier: MIT
#pragma once

#include "game/app/play.h"

namespace sl {

/// The scene that is to be played with all that a player can do in it, and the world file attached where there is one already.
/// Throws Error.
App open_game(PlaySettings settings);

/// Adds all that a player can do to a scene that is there.
void make_playable(App& app);

/// Makes the world file of a game just opened, and attaches it. Throws Error, or says so where the game may go on without.
void make_world(App& app, const PlaySettings& settings);

}  // namespace sl
