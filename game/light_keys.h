// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "engine/ecs/app.h"
#include "engine/ecs/components/gi_settings.h"

namespace sl {

/// Settings of the GI methods that are not in use, so that they are found again; a resource.
struct LightKeys {
    std::map<std::string_view, GiMethod> kept;  ///< by name
    std::string_view before_off;                ///< method that O brings back; empty before the first
};

/// G goes to the next GI method of the active camera, O turns GI off and on; [ ] and left/right turn every
/// sun, up/down raise and lower it, and so does the mouse while M is held, which then turns nothing else; N stops a day
/// and lets it go on; + and - brighten and darken the picture.
void light_keys(World& world);

void add_light_keys(App& app);

}  // namespace sl
