// SPDX-License-Identifier: MIT
#include "engine/render/gl/program.h"

#include <array>
#include <numeric>

#include "engine/core/check.h"

namespace sl::gl {
namespace {

/// Calls visit(index, name) for each active resource of a kind, without what GL itself declares.
template <class Visit>
void each_resource(GLuint program, GLenum kind, Visit&& visit) {
    GLint count = 0, longest = 0;
    glGetProgramInterfaceiv(program, kind, GL_ACTIVE_RESOURCES, &count);
    glGetProgramInterfaceiv(program, kind, GL_MAX_NAME_LENGTH, &longest);
    std::string name;
    for (GLuint index = 0; index < static_cast<GLuint>(count); ++index) {
        name.assign(static_cast<std::size_t>(longest), '\0');
        GLsizei length = 0;
        glGetProgramResourceName(program, kind, index, longest, &length, name.data());
        name.resize(static_cast<std::size_t>(length));
        if (!name.starts_with("gl_")) visit(index, name);
    }
}

template <std::size_t N>
std::array<GLint, N> ask(GLuint program, GLenum kind, GLuint index, const GLenum (&properties)[N]) {
    std::array<GLint, N> values{};
    glGetProgramResourceiv(program, kind, index, N, properties, N, nullptr, values.data());
    return values;
}

bool within(GLenum type, GLenum first, GLenum last) {
    return type >= first && type <= last;
}

bool is_sampler(GLenum type) {
    return within(type, GL_SAMPLER_1D, GL_SAMPLER_2D_RECT_SHADOW) ||
           within(type, GL_SAMPLER_1D_ARRAY, GL_SAMPLER_CUBE_SHADOW) ||
           within(type, GL_INT_SAMPLER_1D, GL_UNSIGNED_INT_SAMPLER_BUFFER) ||
           within(type, GL_SAMPLER_CUBE_MAP_ARRAY, GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY) ||
           within(type, GL_SAMPLER_2D_MULTISAMPLE, GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY);
}

bool is_image(GLenum type) {
    return within(type, GL_IMAGE_1D, GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY);
}

std::string without_first_index(const std::string& name) {
    return name.ends_with("[0]") ? name.substr(0, name.size() - 3) : name;
}

/// A sampler or image uniform: `count` units from the first one given.
struct Unit {
    GLint location;
    GLuint count;
};

/// Hands out units in name order and tells the program.
std::map<std::string, GLuint> assign_units(GLuint program, const std::map<std::string, Unit>& found) {
    std::map<std::string, GLuint> assigned;
    GLuint next = 0;
    for (const auto& [name, unit] : found) {
        std::vector<GLint> units(unit.count);
        std::iota(units.begin(), units.end(), static_cast<GLint>(next));
        glProgramUniform1iv(program, unit.location, static_cast<GLsizei>(unit.count), units.data());
        assigned.emplace(name, next);
        next += unit.count;
    }
    return assigned;
}

/// Hands out bindings in name order; `bind` is the GL call for this kind of block.
template <class Bind>
std::map<std::string, GLuint> assign_bindings(GLuint program, GLenum kind, Bind bind) {
    std::map<std::string, GLuint> found;
    each_resource(program, kind, [&](GLuint index, const std::string& name) { found.emplace(name, index); });
    GLuint next = 0;
    for (auto& [name, binding] : found) {
        bind(program, binding, next);
        binding = next++;
    }
    return found;
}

}  // namespace

Program::Program(GLuint id) : id_(id) {
    CHECK(id != 0, "a program needs an id");
    std::map<std::string, Unit> found_samplers, found_images;
    each_resource(id, GL_UNIFORM, [&](GLuint index, const std::string& raw_name) {
        const auto [type, block, location, count] =
            ask(id, GL_UNIFORM, index, {GL_TYPE, GL_BLOCK_INDEX, GL_LOCATION, GL_ARRAY_SIZE});
        if (block != -1 || location == -1) return;
        const std::string name = without_first_index(raw_name);
        const Unit unit{location, static_cast<GLuint>(count)};
        if (is_sampler(static_cast<GLenum>(type))) {
            found_samplers.emplace(name, unit);
        } else if (is_image(static_cast<GLenum>(type))) {
            found_images.emplace(name, unit);
        } else {
            uniforms_.emplace(name, location);
        }
    });
    samplers_ = assign_units(id, found_samplers);
    images_ = assign_units(id, found_images);
    uniform_blocks_ = assign_bindings(id, GL_UNIFORM_BLOCK, glUniformBlockBinding);
    storage_blocks_ = assign_bindings(id, GL_SHADER_STORAGE_BLOCK, glShaderStorageBlockBinding);
    // Without a fragment shader the outputs are those of the vertex shader.
    each_resource(id, GL_PROGRAM_OUTPUT, [&](GLuint index, const std::string& name) {
        const auto [location, of_fragment] =
            ask(id, GL_PROGRAM_OUTPUT, index, {GL_LOCATION, GL_REFERENCED_BY_FRAGMENT_SHADER});
        if (of_fragment != 0 && location >= 0) outputs_.emplace(without_first_index(name), location);
    });
}

Program::~Program() {
    glDeleteProgram(id_);
}

}  // namespace sl::gl
