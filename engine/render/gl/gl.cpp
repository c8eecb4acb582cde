// SPDX-License-Identifier: MIT
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#define GLAD_GL_IMPLEMENTATION
#include "engine/render/gl/gl.h"
#pragma GCC diagnostic pop
