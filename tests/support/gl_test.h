// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "engine/render/gl/context.h"
#include "engine/render/renderer.h"

namespace sl {

/// One headless context and renderer per test program; each test requires that the driver reported no error.
class GlTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        if (!context_) context_ = gl::create_context(gl::ContextKind::egl);
    }
    void SetUp() override {
        context_->clear_errors();
        renderer = std::make_unique<Renderer>(shader_folder());
    }
    void TearDown() override {
        renderer.reset();
        for (const std::string& error : context_->errors()) ADD_FAILURE() << "OpenGL: " << error;
    }

    std::unique_ptr<Renderer> renderer;

  private:
    static inline std::unique_ptr<gl::Context> context_;
};

}  // namespace sl
