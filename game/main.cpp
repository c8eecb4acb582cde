// SPDX-License-Identifier: MIT
#include <cstdio>

#include "engine/core/error.h"
#include "game/app/commands.h"

int main(int argc, char** argv) {
    try {
        sl::GlobalFlags flags;
        return sl::whole_program(flags).run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "secondlight: error: {}\n", error.what());
        return 1;
    }
}
