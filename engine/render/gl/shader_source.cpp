// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>

#include "engine/core/error.h"
#include "engine/render/gl/program.h"

namespace sl::gl {
namespace {

namespace fs = std::filesystem;
constexpr int deepest_include = 32;

// Mesa forgets the source string number for most of what its parser reports, but never the line: so the line
// carries the file too.
constexpr std::size_t lines_per_file = 100000;

std::string line_directive(std::size_t file, std::size_t line) {
    return fmt::format("#line {} {}\n", file * lines_per_file + line, file);
}

/// "  #  include x" -> {"include", "x"}; nothing for other lines.
struct Directive {
    std::string_view word;
    std::string_view rest;
};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const auto begin = text.find_first_not_of(blank);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

std::optional<Directive> parse_directive(std::string_view line) {
    line = trimmed(line);
    if (!line.starts_with('#')) return std::nullopt;
    line = trimmed(line.substr(1));
    const auto end = std::find_if_not(line.begin(), line.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    const auto length = static_cast<std::size_t>(end - line.begin());
    return Directive{line.substr(0, length), trimmed(line.substr(length))};
}

/// Whether a block comment is open after this line.
bool in_comment_after(std::string_view line, bool in_comment) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const std::string_view two = line.substr(i, 2);
        if (!in_comment && two == "//") return false;
        if (two == (in_comment ? "*/" : "/*")) {
            in_comment = !in_comment;
            ++i;
        }
    }
    return in_comment;
}

/// Follows #if … #endif only as far as they ask for __cplusplus: what C++ alone includes, GLSL must not.
class CppSections {
  public:
    void see(const Directive& directive) {
        const bool names_it = directive.rest.find("__cplusplus") != std::string_view::npos;
        if (directive.word == "ifdef" || directive.word == "if") {
            const bool negated = directive.rest.starts_with('!');
            open_.push_back(!names_it ? Kind::other : negated ? Kind::glsl : Kind::cpp);
        } else if (directive.word == "ifndef") {
            open_.push_back(names_it ? Kind::glsl : Kind::other);
        } else if (directive.word == "else" && !open_.empty() && open_.back() != Kind::other) {
            open_.back() = open_.back() == Kind::cpp ? Kind::glsl : Kind::cpp;
        } else if (directive.word == "endif" && !open_.empty()) {
            open_.pop_back();
        }
    }
    bool in_cpp() const { return std::find(open_.begin(), open_.end(), Kind::cpp) != open_.end(); }

  private:
    enum class Kind { cpp, glsl, other };
    std::vector<Kind> open_;
};

class Expander {
  public:
    Expander(const ShaderFolders& folders, ShaderSource& out) : folders_(folders), out_(out) {
        for (const fs::path& folder : folders) {
            std::error_code failed;
            roots_.push_back(fs::canonical(folder, failed));
            if (failed) fail("the shader folder {} is not there", folder.string());
        }
    }

    /// The file's path inside its folder. `at` opens the message: where the file was asked for.
    fs::path locate(const std::string& asked, const std::string& at) const {
        const fs::path inside = fs::path(asked).lexically_normal();
        bool leaves = inside.is_absolute() || climbs(inside);
        for (const fs::path& root : roots_) {
            std::error_code missing, ignored;
            const fs::path real = fs::canonical(root / inside, missing);
            if (leaves || missing) continue;
            fs::path relative = real.lexically_relative(root);
            leaves = climbs(relative);
            if (!leaves && fs::is_regular_file(real, ignored)) return relative;
        }
        if (leaves) fail("{}\"{}\" leaves the shader folder", at, asked);
        std::vector<std::string> looked;
        for (const fs::path& folder : folders_) looked.push_back(folder.string());
        fail("{}there is no \"{}\" in the shader folder {}", at, asked, fmt::join(looked, " or "));
    }

    void expand(const fs::path& file, int depth) {
        const std::size_t index = out_.files.size();
        out_.files.push_back(file);
        std::ifstream stream(find_shader(roots_, file), std::ios::binary);
        if (!stream) fail("{}: cannot be read", file.generic_string());
        out_.text += line_directive(index, 1);
        CppSections sections;
        bool in_comment = false;
        std::string line;
        for (std::size_t number = 1; std::getline(stream, line); ++number) {
            const auto directive = in_comment ? std::nullopt : parse_directive(line);
            in_comment = in_comment_after(line, in_comment);
            if (directive) sections.see(*directive);
            const std::string at = fmt::format("{}:{}: ", file.generic_string(), number);
            if (directive && directive->word == "version")
                fail("{}remove #version: the loader writes it", at);
            if (directive && directive->word == "include" && !sections.in_cpp()) {
                include(directive->rest, at, depth);
                out_.text += line_directive(index, number + 1);
            } else if (directive && (directive->word == "include" || is_once(*directive))) {
                out_.text += '\n';
            } else {
                out_.text += line;
                out_.text += '\n';
            }
        }
    }

  private:
    static bool climbs(const fs::path& path) { return !path.empty() && *path.begin() == ".."; }
    static bool is_once(const Directive& directive) {
        return directive.word == "pragma" && directive.rest.starts_with("once");
    }

    void include(std::string_view rest, const std::string& at, int depth) {
        const auto close = rest.find('"', 1);
        if (!rest.starts_with('"') || close == std::string_view::npos) fail("{}write #include \"path\"", at);
        const fs::path file = locate(std::string(rest.substr(1, close - 1)), at);
        if (std::find(out_.files.begin(), out_.files.end(), file) != out_.files.end()) return;
        if (depth >= deepest_include) fail("{}includes nest deeper than {}", at, deepest_include);
        expand(file, depth + 1);
    }

    const ShaderFolders& folders_;
    ShaderSource& out_;
    ShaderFolders roots_;
};

/// A driver's message: "2:14(3): rest" from Mesa, "2(14) : rest" from NVIDIA.
struct Message {
    std::size_t file = 0;
    std::size_t line = 0;
    std::string_view rest;
};

std::optional<Message> parse_message(std::string_view text) {
    const auto number = [&](std::size_t& value) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc()) return false;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        return true;
    };
    const auto skip = [&](char c) {
        if (!text.starts_with(c)) return false;
        text.remove_prefix(1);
        return true;
    };
    Message message;
    std::size_t column = 0;
    if (!number(message.file)) return std::nullopt;
    const bool mesa = skip(':') && number(message.line) && skip('(') && number(column) && skip(')');
    const bool nvidia = !mesa && skip('(') && number(message.line) && skip(')');
    while (skip(' ')) continue;
    if ((!mesa && !nvidia) || !skip(':')) return std::nullopt;
    message.rest = text;
    return message;
}

}  // namespace

fs::path find_shader(const ShaderFolders& folders, const fs::path& file) {
    for (const fs::path& folder : folders) {
        std::error_code ignored;
        if (fs::exists(folder / file, ignored)) return folder / file;
    }
    return {};
}

ShaderSource load_shader_source(const ShaderFolders& folders, const std::string& file,
                                const std::vector<std::pair<std::string, std::string>>& defines) {
    ShaderSource source;
    source.text = "#version 450 core\n";
    for (const auto& [name, value] : defines) source.text += fmt::format("#define {} {}\n", name, value);
    Expander expander(folders, source);
    expander.expand(expander.locate(file, ""), 0);
    return source;
}

std::string name_files_in_log(const std::string& log, const ShaderSource& source) {
    std::istringstream lines(log);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        if (const auto message = parse_message(line)) {
            const std::size_t carried = message->line / lines_per_file;
            const std::size_t file = carried != 0 ? carried : message->file;
            if (file < source.files.size()) {
                line = fmt::format("{}:{}:{}", source.files[file].generic_string(),
                                   message->line % lines_per_file, message->rest);
            }
        }
        result += line + '\n';
    }
    return result;
}

}  // namespace sl::gl
