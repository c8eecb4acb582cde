// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/render/gl/label.h"
#include "engine/render/gl/program.h"

namespace sl::gl {
namespace {

namespace fs = std::filesystem;

/// One shader of a program with all that it includes.
struct Stage {
    GLenum kind;
    std::string file;
    ShaderSource source;
};

std::vector<Stage> load_stages(const ShaderFolders& folders, const ProgramDesc& desc) {
    std::vector<Stage> stages;
    const auto add = [&](GLenum kind, const std::string& file) {
        if (!file.empty()) stages.push_back({kind, file, load_shader_source(folders, file, desc.defines)});
    };
    add(GL_VERTEX_SHADER, desc.vertex);
    add(GL_FRAGMENT_SHADER, desc.fragment);
    add(GL_COMPUTE_SHADER, desc.compute);
    return stages;
}

std::string title(const ProgramDesc& desc) {
    if (!desc.compute.empty()) return desc.compute;
    return desc.fragment.empty() ? desc.vertex : desc.fragment;
}

/// The first messages, errors before warnings: what follows them is mostly their consequence.
std::string first_messages(const std::string& log) {
    constexpr std::size_t most = 4;
    std::vector<std::string> messages;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        if (line.find_first_not_of(" \t\r") != std::string::npos) messages.push_back(line);
    }
    std::stable_partition(messages.begin(), messages.end(),
                          [](const std::string& line) { return line.find("error") != std::string::npos; });
    messages.resize(std::min(messages.size(), most));
    return fmt::format("{}", fmt::join(messages, "\n"));
}

template <class GetLength, class GetLog>
std::string read_log(GLuint id, GetLength get_length, GetLog get_log) {
    GLint length = 0;
    get_length(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    get_log(id, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

GLuint compile(const Stage& stage) {
    const GLuint shader = glCreateShader(stage.kind);
    const char* text = stage.source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    const std::string log =
        name_files_in_log(read_log(shader, glGetShaderiv, glGetShaderInfoLog), stage.source);
    if (compiled == GL_FALSE) {
        glDeleteShader(shader);
        const std::string messages = first_messages(log);
        throw Error(messages.empty() ? fmt::format("{}: the driver refuses it without a word", stage.file)
                                     : messages);
    }
    if (!log.empty()) log::debug("{}", first_messages(log));
    return shader;
}

std::unique_ptr<Program> link(const std::vector<Stage>& stages, const std::string& name) {
    const GLuint id = glCreateProgram();
    try {
        for (const Stage& stage : stages) {
            const GLuint shader = compile(stage);
            glAttachShader(id, shader);
            glDeleteShader(shader);  // lives as long as it is attached
        }
    } catch (...) {
        glDeleteProgram(id);
        throw;
    }
    set_label(GL_PROGRAM, id, name);
    glLinkProgram(id);
    GLint linked = GL_FALSE;
    glGetProgramiv(id, GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        const std::string log = first_messages(read_log(id, glGetProgramiv, glGetProgramInfoLog));
        glDeleteProgram(id);
        throw Error(fmt::format("{}: does not link: {}", name, log));
    }
    return std::make_unique<Program>(id);
}

fs::file_time_type time_of(const fs::path& path) {
    std::error_code failed;
    const auto time = fs::last_write_time(path, failed);
    return failed ? fs::file_time_type::min() : time;
}

}  // namespace

struct ProgramCache::Entry {
    std::unique_ptr<Program> program;
    std::string text;  ///< of all stages as last tried: a changed time alone builds nothing
    Times times;
    std::string error;
    bool incomplete = false;  ///< a file could not be loaded, so `times` may lack the one that will mend it

    void remember(const std::vector<Stage>& stages, const ShaderFolders& folders, fs::file_time_type loaded) {
        text.clear();
        times.clear();
        // File systems count time in ticks: a file written just before it was read may change under the same
        // time.
        const auto trusted = loaded - std::chrono::milliseconds(100);
        for (const Stage& stage : stages) {
            text += stage.source.text;
            for (const fs::path& file : stage.source.files) {
                const auto time = time_of(find_shader(folders, file));
                times[file] = time < trusted ? time : fs::file_time_type::max();
            }
        }
    }
};

ProgramCache::ProgramCache(fs::path folder) : folders_{std::move(folder)} {}

const Program& ProgramCache::get(const ProgramDesc& desc) {
    const auto found = entries_.find(desc);
    if (found != entries_.end()) return *found->second->program;
    CHECK(desc.compute.empty() ? !desc.vertex.empty() : desc.vertex.empty() && desc.fragment.empty(),
          "a program is compute alone, or vertex and maybe fragment ({})", title(desc));
    const auto now = fs::file_time_type::clock::now();
    const std::vector<Stage> stages = load_stages(folders_, desc);
    auto entry = std::make_shared<Entry>();
    entry->remember(stages, folders_, now);
    entry->program = link(stages, title(desc));
    return *entries_.emplace(desc, std::move(entry)).first->second->program;
}

bool ProgramCache::reload(const ProgramDesc& desc, Entry& entry, Times& times) const {
    const auto changed = [&](const auto& stamp) {
        const auto [now, fresh] = times.try_emplace(stamp.first);
        if (fresh) now->second = time_of(find_shader(folders_, stamp.first));
        return now->second != stamp.second;
    };
    if (!entry.incomplete && std::none_of(entry.times.begin(), entry.times.end(), changed)) return false;
    try {
        entry.incomplete = true;
        const std::string text = std::exchange(entry.text, {});
        const auto now = fs::file_time_type::clock::now();
        const std::vector<Stage> stages = load_stages(folders_, desc);
        entry.incomplete = false;
        entry.remember(stages, folders_, now);
        if (text == entry.text) return false;
        entry.program = link(stages, title(desc));
        entry.error.clear();
        return true;
    } catch (const Error& error) {
        const bool news = entry.error != error.what();
        entry.error = error.what();
        return news;
    }
}

bool ProgramCache::reload_changed() {
    Times times;
    bool any = false;
    for (auto& [desc, entry] : entries_) any = reload(desc, *entry, times) || any;
    if (!any) return false;
    errors_.clear();
    for (const auto& [desc, entry] : entries_) {
        if (!entry->error.empty() &&
            std::find(errors_.begin(), errors_.end(), entry->error) == errors_.end()) {
            errors_.push_back(entry->error);
        }
    }
    return true;
}

}  // namespace sl::gl
