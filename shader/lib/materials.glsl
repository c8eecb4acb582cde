// SPDX-License-Identifier: MIT
#include "shared/scene.h"

layout(std430) readonly buffer Materials { MaterialParams materials[]; };
