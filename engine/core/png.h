// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/image.h"

namespace sl {

/// What write_png puts into a file. Throws Error with the library's words.
std::string png_bytes(const Image& image);

}  // namespace sl
