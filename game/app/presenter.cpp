// SPDX-License-Identifier: MIT
#include "game/app/presenter.h"

#include <cmath>

namespace sl {

Presenter::Presenter() {
    glCreateFramebuffers(1, &framebuffer_);
}
Presenter::~Presenter() {
    glDeleteFramebuffers(1, &framebuffer_);
}

void Presenter::begin(uvec2 size) {
    // A frame that failed may leave a pass's debug group open, and a program that no longer is in use.
    for (GLint depth = 0; glGetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &depth), depth > 1;) glPopDebugGroup();
    glUseProgram(0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, static_cast<GLsizei>(size.x), static_cast<GLsizei>(size.y));
    constexpr GLfloat black[4] = {0, 0, 0, 1};
    glClearNamedFramebufferfv(0, GL_COLOR, 0, black);
}

void Presenter::show(GLuint texture, uvec2 texture_size, uvec2 size) {
    const auto from = ivec2(texture_size), to = ivec2(size);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture, 0);
    glBlitNamedFramebuffer(framebuffer_, 0, 0, 0, from.x, from.y, 0, 0, to.x, to.y, GL_COLOR_BUFFER_BIT,
                           from == to ? GL_NEAREST : GL_LINEAR);
}

void Presenter::show_part(GLuint texture, uvec2 texture_size, uvec2 size, float from, float to) {
    const auto left = static_cast<GLint>(std::lround(from * static_cast<float>(size.x))), right = static_cast<GLint>(std::lround(to * static_cast<float>(size.x)));
    glEnable(GL_SCISSOR_TEST);
    glScissor(left, 0, right - left, static_cast<GLsizei>(size.y));
    show(texture, texture_size, size);
    glDisable(GL_SCISSOR_TEST);
}

void Presenter::end() {
    glEnable(GL_FRAMEBUFFER_SRGB);
}

}  // namespace sl
