// SPDX-License-Identifier: MIT
#pragma once

// The only door to OpenGL: names and function pointers of 4.5 core, loaded by whichever context is made.
#include <glad/gl.h>
