// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "game/streaming/column_build.h"

namespace sl {

/// Builds columns on job threads, behind all else that they do. So few are on their way at a time that neither memory nor
/// what a turn of the camera makes useless can grow.
class ColumnJobs {
  public:
    using Build = std::function<BuiltColumn()>;

    ColumnJobs();
    /// Waits for what has begun.
    ~ColumnJobs();
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
    struct Shared;  ///< with the job threads

    std::shared_ptr<Shared> shared_;
    std::vector<BuiltColumn> finished_;
    ColumnSet started_, outdated_;
};

}  // namespace sl
