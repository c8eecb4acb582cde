// SPDX-License-Identifier: MIT
#include "game/settings/settings_file.h"

#include <cstdlib>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/fields_json.h"
#include "engine/core/json_text.h"
#include "engine/core/text_file.h"

namespace sl {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* version_key = "secondlight_settings";
constexpr int version = 1;
constexpr std::uint64_t most_bytes = 1 << 20;

void check_version(const json& document, const std::string& file) {
    if (!document.is_object()) fail("{}: must be an object {{…}}, not {}", file, document.type_name());
    const auto found = document.find(version_key);
    if (found == document.end() || *found != version) {
        fail("{}: /{}: must be {}: these are no settings of this program, or those of a newer version", file, version_key, version);
    }
}

/// Keys of the old document that the new one does not have stay as they are.
void keep_unknown(ordered_json& document, const ordered_json& old) {
    for (const auto& [key, value] : old.items()) {
        if (!document.contains(key)) {
            document[key] = value;
        } else if (value.is_object() && document[key].is_object()) {
            keep_unknown(document[key], value);
        }
    }
}

/// "settings.json.broken", or with a number where that is taken.
std::filesystem::path free_name_beside(const std::filesystem::path& path) {
    for (int number = 1;; ++number) {
        std::filesystem::path beside = path;
        beside += number == 1 ? ".broken" : fmt::format(".broken.{}", number);
        if (!std::filesystem::exists(beside)) return beside;
    }
}

ordered_json document_of(UserSettings settings) {
    ordered_json document{{version_key, version}};
    each_section(settings, [&](const char* name, auto& section) {
        JsonWriter writer(document[name]);
        visit_fields(writer, section);
    });
    return document;
}

}  // namespace

std::filesystem::path settings_path() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    constexpr const char* file = "secondlight/settings.json";
    if (config != nullptr && *config == '/') return std::filesystem::path(config) / file;
    if (home != nullptr && *home == '/') return std::filesystem::path(home) / ".config" / file;
    return std::filesystem::temp_directory_path() / file;
}

SettingsFile::SettingsFile(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code ignored;
    if (!std::filesystem::exists(path_, ignored)) return;
    try {
        read();
    } catch (const std::exception& error) {
        settings = {};
        warnings_.clear();
        document_.clear();
        fault_ = error.what();
    }
}

void SettingsFile::read() {
    const std::string file = path_.string(), text = read_text_file(path_, most_bytes);
    const json document = parse_json(text, file);
    check_version(document, file);
    const auto warn = [&](const auto& check) {
        try {
            check();
        } catch (const Error& error) {
            warnings_.emplace_back(error.what());
        }
    };
    std::vector<std::string> known{version_key};
    each_section(settings, [&](const char* name, auto& section) {
        known.emplace_back(name);
        const auto found = document.find(name);
        if (found == document.end()) return;
        JsonReader reader(*found, fmt::format("{}: /{}", file, name));
        visit_fields(reader, section);
        warn([&] { reader.check_all_used(); });
    });
    for (const auto& item : document.items()) {
        if (std::ranges::find(known, item.key()) == known.end()) warnings_.push_back(fmt::format("{}: {}", file, no_such_name("section", item.key(), known)));
    }
    document_ = ordered_json::parse(text);
}

std::filesystem::path SettingsFile::save() {
    ordered_json document = document_of(settings);
    keep_unknown(document, document_);
    std::filesystem::path kept;
    try {
        std::filesystem::create_directories(path_.parent_path());
        if (!fault_.empty() && std::filesystem::exists(path_)) {
            kept = free_name_beside(path_);
            std::filesystem::copy_file(path_, kept);
        }
    } catch (const std::filesystem::filesystem_error& error) {
        fail("{}: cannot be written: {}", path_.string(), error.code().message());
    }
    write_text_file(path_, json_text(document));
    document_ = std::move(document);
    fault_.clear();
    return kept;
}

}  // namespace sl
