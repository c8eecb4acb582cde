// SPDX-License-Identifier: MIT
#include "game/saving/world_list.h"

#include "engine/core/error.h"

namespace sl {

namespace {

constexpr const char* ending = ".world";
constexpr std::size_t longest_name = 64;
/// What some file system or shell takes amiss.
constexpr std::string_view refused = "/\\:*?\"<>|";
/// What SQLite keeps beside a world.
constexpr const char* companions[] = {"-wal", "-shm"};

std::filesystem::path beside(std::filesystem::path path, const char* companion) {
    path += companion;
    return path;
}

WorldEntry entry_of(const std::filesystem::directory_entry& file, const WorldFile* open) {
    std::error_code ignored;
    WorldEntry entry{.path = file.path(), .name = file.path().stem().string(), .scene = {}, .bytes = file.file_size(ignored), .last_played = file.last_write_time(ignored), .fault = {}};
    const std::filesystem::path log = beside(file.path(), companions[0]);
    if (std::filesystem::exists(log, ignored)) {
        entry.bytes += std::filesystem::file_size(log, ignored);
        entry.last_played = std::max(entry.last_played, std::filesystem::last_write_time(log, ignored));
    }
    entry.open = open != nullptr && std::filesystem::equivalent(open->path(), file.path(), ignored);
    if (entry.open) {
        entry.scene = open->scene();
        return entry;
    }
    try {
        entry.scene = WorldFile::scene_of(file.path());
    } catch (const std::exception& error) {
        entry.fault = error.what();
    }
    return entry;
}

}  // namespace

bool is_world_file(const std::filesystem::path& path) { return path.extension() == ending; }

std::vector<WorldEntry> list_worlds(const std::filesystem::path& folder, const WorldFile* open) {
    std::vector<WorldEntry> worlds;
    std::error_code ignored;
    for (const auto& file : std::filesystem::directory_iterator(folder, ignored)) {
        if (file.path().extension() == ending) worlds.push_back(entry_of(file, open));
    }
    std::ranges::sort(worlds, [](const WorldEntry& a, const WorldEntry& b) {
        return std::tuple(!a.open, b.last_played, a.name) < std::tuple(!b.open, a.last_played, b.name);
    });
    return worlds;
}

std::filesystem::path world_path(const std::filesystem::path& folder, const std::string& name) { return folder / (name + ending); }

std::string fault_of_name(const std::filesystem::path& folder, const std::string& name) {
    if (name.empty()) return "a world needs a name";
    if (name.size() > longest_name) return fmt::format("the name is too long: {} bytes, at most {}", name.size(), longest_name);
    if (name.front() == ' ' || name.back() == ' ') return "the name begins or ends with a space";
    if (name.front() == '.') return "the name begins with a dot";
    for (const char c : name) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return "the name has a character that cannot be seen";
        if (refused.find(c) != std::string_view::npos) return fmt::format("the name must do without {}", c);
    }
    std::error_code ignored;
    if (std::filesystem::exists(world_path(folder, name), ignored)) return "there is a world of that name already";
    return {};
}

void delete_world(const std::filesystem::path& path) {
    // Opened and closed first: so it is a sound world that nobody plays, and nothing of it is left in a log.
    if (WorldFile::open(path)->read_only()) fail("{}: it is not deleted, the file or its folder is read-only", path.string());
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error) fail("{}: cannot be deleted: {}", path.string(), error.message());
    for (const char* companion : companions) std::filesystem::remove(beside(path, companion), error);
}

}  // namespace sl
