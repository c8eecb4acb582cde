// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/core/math.h"
#include "game/saving/database.h"
#include "game/voxel/blocks.h"

namespace sl {

/// A block that somebody has set, in one of a scene's voxel entities, counted in the order in which the scene names them.
struct BlockEdit {
    std::uint32_t volume = 0;
    ivec3 cell{0};
    Block block = Block::air;

    bool operator==(const BlockEdit&) const = default;
};

/// A world on disk: the scene with which it began, what was changed in it, and some named texts (where the player is).
/// An SQLite database with a write-ahead log, so that what was written survives the end of the process at any moment. A thread
/// of its own writes, and no caller waits for the disk. Where that fails, edits wait in memory and it is tried again.
class WorldFile {
  public:
    /// Makes a world, whole or not at all; there must be no such file. Throws Error.
    static std::unique_ptr<WorldFile> create(const std::filesystem::path& path, const std::string& scene);
    /// Opens one. What is damaged, no world, from a newer program, or open elsewhere, is refused with an Error and stays as it
    /// is; what can only be read is opened all the same, and its status says so.
    static std::unique_ptr<WorldFile> open(const std::filesystem::path& path);
    /// The scene that a world names, without writing, locking or reading all of it. Throws Error like open.
    static std::string scene_of(const std::filesystem::path& path);
    /// Waits until all is written, or for a few seconds where that fails.
    ~WorldFile();
    WorldFile(const WorldFile&) = delete;
    WorldFile& operator=(const WorldFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    const std::string& scene() const { return scene_; }
    /// Nothing can be saved here, as the status says from the start.
    bool read_only() const { return read_only_; }
    /// As they were when it was opened.
    const std::vector<BlockEdit>& edits() const { return edits_; }
    /// Empty where there is none; as it was when it was opened.
    std::string text(const std::string& key) const;

    void save(const BlockEdit& edit);
    void save_text(const std::string& key, std::string text);

    struct Status {
        std::size_t waiting = 0;  ///< edits and texts that are not on disk yet
        std::string problem;      ///< why; empty while all is well
    };
    Status status() const;
    /// Waits until all that was given is on disk; false where that fails or takes longer.
    bool wait(double seconds);

  private:
    WorldFile(const std::filesystem::path& path, std::unique_ptr<Database> database, std::string problem);

    void load();
    void wake_writer();
    void write_in_the_background(const std::stop_token& stop);
    void write(const std::vector<BlockEdit>& edits, const std::map<std::string, std::string>& texts);

    std::filesystem::path path_;
    std::unique_ptr<Database> database_;
    std::string scene_;
    std::vector<BlockEdit> edits_;
    std::map<std::string, std::string> texts_;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::vector<BlockEdit> waiting_edits_;
    std::map<std::string, std::string> waiting_texts_;
    std::size_t in_work_ = 0;
    std::string problem_;
    bool read_only_ = false;
    std::jthread writer_;  ///< last: it ends before what it uses
};

}  // namespace sl
