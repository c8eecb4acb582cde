// SPDX-License-Identifier: MIT
#include "game/saving/world_file.h"

#include <unistd.h>

#include <chrono>

#include "engine/core/error.h"
#include "engine/core/log.h"

namespace sl {

namespace {

/// "SLwd", and the version of the tables.
constexpr std::int64_t application_id = 0x534c7764, newest_schema = 1;
constexpr auto try_again_after = std::chrono::seconds(1);
constexpr double last_wait = 3.0;  // s
constexpr std::int64_t farthest_block = std::int64_t{1} << 30;

/// Write-ahead log without waiting for the disk: what was committed survives the end of the process, and a power cut costs the
/// last moments but no consistency. Exclusive: another process is refused.
constexpr const char* begin_writing = "PRAGMA locking_mode=EXCLUSIVE; PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; BEGIN EXCLUSIVE; COMMIT;";

constexpr const char* block_table =
    "CREATE TABLE block (volume INTEGER, x INTEGER, y INTEGER, z INTEGER, kind INTEGER NOT NULL, PRIMARY KEY (volume, x, y, z)) WITHOUT ROWID";
constexpr const char* text_table = "CREATE TABLE text (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID";

/// A stranger's tables may be views that never end, or have triggers and columns that compute.
void check_tables(Database& database, const std::filesystem::path& path) {
    Database::Statement table(database, "SELECT sql FROM sqlite_schema ORDER BY name");
    const bool ours = table.next() && table.text(0) == block_table && table.next() && table.text(0) == text_table && !table.next();
    if (!ours) fail("{}: it is damaged: its tables are not those of a world", path.string());
}

void check_kind(Database& database, const std::filesystem::path& path) {
    if (database.integer("PRAGMA application_id") != application_id) fail("{}: it is a database, but no world", path.string());
    const std::int64_t schema = database.integer("PRAGMA user_version");
    if (schema > newest_schema) fail("{}: it was written by a newer version of this program (its tables are of version {}, not {})", path.string(), schema, newest_schema);
    check_tables(database, path);
}

void check_pages(Database& database, const std::filesystem::path& path) {
    Database::Statement check(database, "PRAGMA quick_check(1)");
    if (!check.next() || check.text(0) != "ok") fail("{}: it is damaged: {}", path.string(), check.text(0));
}

void check_world(Database& database, const std::filesystem::path& path) {
    check_kind(database, path);
    check_pages(database, path);
}

std::filesystem::path log_of(std::filesystem::path path) {
    path += "-wal";
    return path;
}

bool can_write(const std::filesystem::path& path) {
    // The log lies beside the file.
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    return ::access(path.c_str(), W_OK) == 0 && ::access(folder.c_str(), W_OK) == 0;
}

}  // namespace

std::unique_ptr<WorldFile> WorldFile::create(const std::filesystem::path& path, const std::string& scene) {
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) fail("{}: there is such a file already", path.string());
    // Under another name until it is whole: one that is cut off here is no world that could be in the way.
    std::filesystem::path unfinished = path;
    unfinished += ".new";
    std::filesystem::remove(unfinished, ignored);
    {
        Database database(unfinished, Database::Access::create);
        database.run(fmt::format("BEGIN; {}; {}; PRAGMA application_id={}; PRAGMA user_version={};", block_table, text_table, application_id, newest_schema));
        Database::Statement(database, "INSERT INTO text VALUES ('scene', ?)").bind(0, scene).next();
        database.run("COMMIT");
    }
    std::filesystem::rename(unfinished, path);
    return open(path);
}

std::unique_ptr<WorldFile> WorldFile::open(const std::filesystem::path& path) {
    std::unique_ptr<Database> database;
    std::string problem;
    if (std::error_code ignored; std::filesystem::exists(path, ignored) && !can_write(path)) {
        if (std::filesystem::exists(log_of(path), ignored)) fail("{}: it was not closed, and its log cannot be read where nothing can be written: copy both to another folder", path.string());
        database = std::make_unique<Database>(path, Database::Access::read);
        problem = fmt::format("{}: changes are not saved, the file or its folder is read-only", path.string());
        check_world(*database, path);
    } else {
        database = std::make_unique<Database>(path, Database::Access::write);
        // Looked at before anything is written: what is no world stays as it is.
        database->run("PRAGMA locking_mode=EXCLUSIVE");
        check_world(*database, path);
        database->run(begin_writing);
    }
    std::unique_ptr<WorldFile> world(new WorldFile(path, std::move(database), problem));
    world->load();
    return world;
}

std::string WorldFile::scene_of(const std::filesystem::path& path) {
    Database database(path, Database::Access::read);
    check_kind(database, path);
    // With a log beside it, it is being played or was not closed, and its pages need not fit together without that.
    if (std::error_code ignored; !std::filesystem::exists(log_of(path), ignored)) check_pages(database, path);
    Database::Statement scene(database, "SELECT value FROM text WHERE key = 'scene'");
    if (!scene.next() || scene.text(0).empty()) fail("{}: it is damaged: it names no scene", path.string());
    return scene.text(0);
}

WorldFile::WorldFile(const std::filesystem::path& path, std::unique_ptr<Database> database, std::string problem)
    : path_(path), database_(std::move(database)), problem_(std::move(problem)), read_only_(!problem_.empty()) {}

WorldFile::~WorldFile() {
    if (!wait(last_wait)) log::error("{}: {} changes were not saved: {}", path_.string(), status().waiting, status().problem);
}

void WorldFile::load() {
    Database::Statement texts(*database_, "SELECT key, value FROM text");
    while (texts.next()) texts_[texts.text(0)] = texts.text(1);
    scene_ = text("scene");
    if (scene_.empty()) fail("{}: it is damaged: it names no scene", path_.string());
    Database::Statement blocks(*database_, "SELECT volume, x, y, z, kind FROM block ORDER BY volume, y, z, x");
    while (blocks.next()) {
        const auto coordinate = [&](int column) {
            const std::int64_t value = blocks.integer(column);
            if (value < -farthest_block || value > farthest_block) fail("{}: it is damaged: a block lies at {}", path_.string(), value);
            return static_cast<int>(value);
        };
        const std::int64_t kind = blocks.integer(4), volume = blocks.integer(0);
        if (kind < 0 || kind >= block_count || volume < 0 || volume > 0xffff) fail("{}: it is damaged: a block of kind {} in volume {}", path_.string(), kind, volume);
        edits_.push_back({static_cast<std::uint32_t>(volume), {coordinate(1), coordinate(2), coordinate(3)}, static_cast<Block>(kind)});
    }
}

std::string WorldFile::text(const std::string& key) const {
    const auto found = texts_.find(key);
    return found != texts_.end() ? found->second : std::string();
}

void WorldFile::save(const BlockEdit& edit) {
    const std::lock_guard lock(mutex_);
    waiting_edits_.push_back(edit);
    wake_writer();
}

void WorldFile::save_text(const std::string& key, std::string text) {
    const std::lock_guard lock(mutex_);
    waiting_texts_[key] = std::move(text);
    wake_writer();
}

void WorldFile::wake_writer() {
    if (!writer_.joinable() && !read_only_) writer_ = std::jthread([this](const std::stop_token& stop) { write_in_the_background(stop); });
    changed_.notify_all();
}

WorldFile::Status WorldFile::status() const {
    const std::lock_guard lock(mutex_);
    return {waiting_edits_.size() + waiting_texts_.size() + in_work_, problem_};
}

bool WorldFile::wait(double seconds) {
    std::unique_lock lock(mutex_);
    const auto all_written = [&] { return waiting_edits_.empty() && waiting_texts_.empty() && in_work_ == 0; };
    if (read_only_) return all_written();
    return changed_.wait_for(lock, std::chrono::duration<double>(seconds), all_written);
}

void WorldFile::write_in_the_background(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        changed_.wait(lock, stop, [&] { return !waiting_edits_.empty() || !waiting_texts_.empty(); });
        if (stop.stop_requested()) return;
        auto edits = std::exchange(waiting_edits_, {});
        auto texts = std::exchange(waiting_texts_, {});
        in_work_ = edits.size() + texts.size();
        lock.unlock();
        std::string problem;
        try {
            write(edits, texts);
        } catch (const Error& error) {
            problem = error.what();
        }
        lock.lock();
        in_work_ = 0;
        if (problem != problem_) problem.empty() ? log::info("{}: saving goes on", path_.string()) : log::error("{}", problem);
        problem_ = problem;
        if (!problem.empty()) {
            // They stay in front of what has come since.
            edits.insert(edits.end(), waiting_edits_.begin(), waiting_edits_.end());
            waiting_edits_ = std::move(edits);
            waiting_texts_.merge(texts);
            changed_.wait_for(lock, stop, try_again_after, [] { return false; });
        }
        changed_.notify_all();
    }
}

void WorldFile::write(const std::vector<BlockEdit>& edits, const std::map<std::string, std::string>& texts) {
    database_->run("BEGIN");
    try {
        Database::Statement block(*database_, "INSERT OR REPLACE INTO block VALUES (?, ?, ?, ?, ?)");
        for (const BlockEdit& edit : edits) {
            block.bind(0, std::int64_t{edit.volume}).bind(1, std::int64_t{edit.cell.x}).bind(2, std::int64_t{edit.cell.y}).bind(3, std::int64_t{edit.cell.z});
            block.bind(4, static_cast<std::int64_t>(edit.block));
            block.next();
            block.reset();
        }
        Database::Statement text(*database_, "INSERT OR REPLACE INTO text VALUES (?, ?)");
        for (const auto& [key, value] : texts) {
            text.bind(0, key).bind(1, value).next();
            text.reset();
        }
        database_->run("COMMIT");
    } catch (const Error&) {
        try {
            database_->run("ROLLBACK");
        } catch (const Error&) {
            // After some failures SQLite has rolled back already.
        }
        throw;
    }
}

}  // namespace sl
