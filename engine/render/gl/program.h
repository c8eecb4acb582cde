// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/gl/gl.h"
#include "engine/render/program_desc.h"

namespace sl::gl {

/// A linked program and what the linker says it needs, by the shader's own names. Bindings are assigned at
/// link, in name order, so no number is ever written by hand. Arrays go by their name without [0]; an array
/// of samplers takes one unit per element, from the unit given here.
class Program {
  public:
    explicit Program(GLuint id);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    GLuint id() const { return id_; }
    /// Name -> first texture unit.
    const std::map<std::string, GLuint>& samplers() const { return samplers_; }
    /// Name -> first image unit.
    const std::map<std::string, GLuint>& images() const { return images_; }
    /// The block's own name (not its instance's) -> binding.
    const std::map<std::string, GLuint>& uniform_blocks() const { return uniform_blocks_; }
    const std::map<std::string, GLuint>& storage_blocks() const { return storage_blocks_; }
    /// Plain uniforms -> location.
    const std::map<std::string, GLint>& uniforms() const { return uniforms_; }
    /// Fragment outputs -> location.
    const std::map<std::string, GLint>& outputs() const { return outputs_; }

  private:
    GLuint id_;
    std::map<std::string, GLuint> samplers_, images_, uniform_blocks_, storage_blocks_;
    std::map<std::string, GLint> uniforms_, outputs_;
};

/// Where shaders are looked for, first to last. A program that brings its own adds their folder behind the engine's.
using ShaderFolders = std::vector<std::filesystem::path>;
/// The first folder's file of that name; empty where none has it.
std::filesystem::path find_shader(const ShaderFolders& folders, const std::filesystem::path& file);

/// Expands `#include "path"` (relative to a shader folder), each file at most once, keeping track of lines so
/// that errors name the real file and line. What stands under `#ifdef __cplusplus` is not expanded; other
/// conditions are not looked at. Pure text; no GL. Throws Error for a missing file, an include that leaves
/// its folder or nests deeper than 32.
struct ShaderSource {
    std::string text;                          ///< with `#version`, defines and `#line` directives
    std::vector<std::filesystem::path> files;  ///< index = source string number in `#line`
};
/// The text of a shader with all that it includes; `defines` are names and values.
ShaderSource load_shader_source(const ShaderFolders& folders, const std::string& file,
                                const std::vector<std::pair<std::string, std::string>>& defines);
/// Rewrites driver messages like "2(14): error" or "2:14(3): error" to "passes/rsm.frag:14: error".
std::string name_files_in_log(const std::string& log, const ShaderSource& source);

/// Compiles programs from shader folders, once per description, and again when a file changes.
class ProgramCache {
  public:
    /// The folder in which shaders are looked for first.
    explicit ProgramCache(std::filesystem::path folder);
    /// Looked through after those that are there.
    void add_folder(std::filesystem::path folder) { folders_.push_back(std::move(folder)); }

    /// Throws Error with file:line when the first build fails.
    const Program& get(const ProgramDesc& desc);
    /// Rebuilds programs whose files changed on disk. A broken shader keeps the last good program. Returns
    /// true when a program was replaced or errors() changed; errors() tells what is broken now.
    bool reload_changed();
    const std::vector<std::string>& errors() const { return errors_; }

  private:
    struct Entry;
    using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    bool reload(const ProgramDesc& desc, Entry& entry, Times& times) const;

    ShaderFolders folders_;
    std::map<ProgramDesc, std::shared_ptr<Entry>> entries_;
    std::vector<std::string> errors_;
};

}  // namespace sl::gl
