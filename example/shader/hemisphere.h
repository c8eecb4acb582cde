// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

struct HemisphereParams {
    vec4 sky;     ///< rgb: nit
    vec4 ground;  ///< rgb: nit
};

SHARED_END
