// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_file.h"

#include <gtest/gtest.h>
