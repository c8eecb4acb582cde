// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/renderer.h"
#include "game/app/commands.h"

namespace sl {

/// A context without a window and a renderer on it, for the commands that make pictures and figures.
struct Headless {
    std::unique_ptr<gl::Context> context;
    Renderer renderer;

    /// Throws Error for `--context window` and for drivers that cannot give OpenGL 4.5.
    explicit Headless(const GlobalFlags& flags);
    /// Throws Error when the driver reported errors: a picture made with them is not to be trusted.
    void check_errors() const;
};

}  // namespace sl
