// SPDX-License-Identifier: MIT
#include "engine/render/gl/label.h"
#include "engine/render/gl/texture.h"

namespace sl::gl {
namespace {

void set(GLuint id, GLint minified, GLint magnified, GLint wrap) {
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, minified);
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, magnified);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, wrap);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, wrap);
}

}  // namespace

Samplers::Samplers() {
    glCreateSamplers(5, ids_);
    set(id(Sampling::nearest), GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
    set(id(Sampling::linear), GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
    set(id(Sampling::pixel_art), GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST, GL_REPEAT);
    set(id(Sampling::picture), GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT);

    // Reversed depth: outside the map is infinitely far (0), and everything is at least that near: lit.
    const GLuint shadow = id(Sampling::shadow_compare);
    const float far_away[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    set(shadow, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(shadow, GL_TEXTURE_BORDER_COLOR, far_away);
    glSamplerParameteri(shadow, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(shadow, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);

    set_label(GL_SAMPLER, id(Sampling::nearest), "nearest");
    set_label(GL_SAMPLER, id(Sampling::linear), "linear");
    set_label(GL_SAMPLER, id(Sampling::pixel_art), "pixel_art");
    set_label(GL_SAMPLER, id(Sampling::picture), "picture");
    set_label(GL_SAMPLER, shadow, "shadow_compare");
}

Samplers::~Samplers() {
    glDeleteSamplers(5, ids_);
}

}  // namespace sl::gl
