// SPDX-License-Identifier: MIT
#include <charconv>
#include <cstdlib>

#include "engine/core/error.h"
#include "game/app/commands.h"

namespace sl {

void add_scene_flags(const Flags& command, SceneChoice& choice) {
    command.add("--scene,PATH", choice.scene, scene_flag_help);
    command.add("--camera", choice.camera, "Which of its cameras, by name or by number from 0; default: the scene's own, of a model the first");
    add_setting_flags(command, choice);
}

void add_setting_flags(const Flags& command, SceneChoice& choice) {
    command.add("--gi", choice.gi, "GI method (see `secondlight list methods`), e.g. rsm_disc or rsm_grid:paper-artefact");
    command.add("--set", choice.sets,
                       "component.field=value, or entity.component.field=value; repeatable (see `secondlight list settings`)");
}

void check_output(const std::string& file, const char* extension) {
    if (file.empty()) return;
    const std::filesystem::path path(file);
    if (path.extension() != extension) fail("{}: it is written as {}, so let its name end in that", file, extension + 1);
    std::error_code ignored;
    if (path.has_parent_path() && !std::filesystem::is_directory(path.parent_path(), ignored)) {
        fail("{}: cannot be written: there is no folder {}", file, path.parent_path().string());
    }
}

uvec2 parse_size(const std::string& text) {
    constexpr unsigned limit = 16384;
    uvec2 size(0);
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.y);
        if (height.ec == std::errc() && height.ptr == end && size.x >= 1 && size.y >= 1 && size.x <= limit && size.y <= limit) {
            return size;
        }
    }
    fail("--size '{}' is not a size; write WIDTHxHEIGHT, each from 1 to {}, for example 640x360", text, limit);
}

bool has_display() {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

template <class Number>
std::vector<Number> whole_numbers(const std::string& text, char separator, std::size_t count, const char* flag, const char* form) {
    std::vector<Number> values(count);
    const char* at = text.data();
    const char* end = at + text.size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto parsed = std::from_chars(at, end, values[i]);
        const bool last = i + 1 == count;
        if (parsed.ec != std::errc() || (last ? parsed.ptr != end : parsed.ptr == end || *parsed.ptr != separator)) fail("{} '{}': write {}", flag, text, form);
        at = parsed.ptr + 1;
    }
    return values;
}
template std::vector<std::uint32_t> whole_numbers(const std::string&, char, std::size_t, const char*, const char*);
template std::vector<std::int32_t> whole_numbers(const std::string&, char, std::size_t, const char*, const char*);

}  // namespace sl
