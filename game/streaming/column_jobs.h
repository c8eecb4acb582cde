// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "game/streaming/column_build.h"

namespace sl {

/// Builds columns on threads of its own: those that light is gathered on are never idle for long, and land would come too
/// late. So few are on their way at a time that neither memory nor what a turn of the camera makes useless can grow.
class ColumnJobs {
  public:
    using Build = std::function<BuiltColumn()>;

    ColumnJobs();
    /// Waits for what has begun.
    ~ColumnJobs() = default;
    ColumnJobs(const ColumnJobs&) = delete;
    ColumnJobs& operator=(const ColumnJobs&) = delete;

    bool full() const;
    /// Whether a column was started and not taken yet.
    bool has(ivec2 column) const { return started_.contains(column); }
    void start(ivec2 column, Build build);
    /// What is built of this column so far is wrong; it will not be handed out.
    void outdate(ivec2 column);
    /// The nearest of those that are finished, at most `most`.
    std::vector<BuiltColumn> take(ivec2 centre, std::size_t most);

  private:
    void work(const std::stop_token& stop);

    std::vector<BuiltColumn> finished_;
    ColumnSet started_, outdated_;
    std::mutex mutex_;  ///< of what follows
    std::condition_variable_any wake_;
    std::deque<Build> waiting_;
    std::vector<BuiltColumn> built_;
    std::vector<std::jthread> threads_;  ///< last: they end before what they use
};

}  // namespace sl
