// SPDX-License-Identifier: MIT
#include "game/streaming/column_jobs.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace sl {

namespace {

constexpr std::size_t most_started = 12;

/// One thread is left to what the frame needs at once.
int threads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

}  // namespace

struct ColumnJobs::Shared {
    tbb::task_arena arena{threads(), 0, tbb::task_arena::priority::low};
    std::mutex mutex;
    std::condition_variable idle;
    std::size_t unfinished = 0;
    bool cancelled = false;
    std::vector<BuiltColumn> finished;

    void run(const Build& build) {
        BuiltColumn built;
        const bool wanted = [this] { return std::lock_guard(mutex), !cancelled; }();
        if (wanted) built = build();
        const std::lock_guard lock(mutex);
        if (wanted) finished.push_back(std::move(built));
        if (--unfinished == 0) idle.notify_all();
    }
};

ColumnJobs::ColumnJobs() : shared_(std::make_shared<Shared>()) {}

ColumnJobs::~ColumnJobs() {
    std::unique_lock lock(shared_->mutex);
    shared_->cancelled = true;
    shared_->idle.wait(lock, [this] { return shared_->unfinished == 0; });
}

bool ColumnJobs::full() const {
    return started_.size() >= most_started;
}

void ColumnJobs::start(ivec2 column, Build build) {
    started_.insert(column);
    {
        const std::lock_guard lock(shared_->mutex);
        ++shared_->unfinished;
    }
    // The job keeps what it shares alive until it has let go of the lock.
    shared_->arena.enqueue([shared = shared_, build = std::move(build)] { shared->run(build); });
}

void ColumnJobs::outdate(ivec2 column) {
    if (has(column)) outdated_.insert(column);
}

std::vector<BuiltColumn> ColumnJobs::take(ivec2 centre, std::size_t most) {
    {
        const std::lock_guard lock(shared_->mutex);
        std::ranges::move(shared_->finished, std::back_inserter(finished_));
        shared_->finished.clear();
    }
    std::erase_if(finished_, [this](const BuiltColumn& built) { return outdated_.erase(built.column) > 0 && started_.erase(built.column) > 0; });
    std::ranges::sort(finished_, std::ranges::greater(), [&](const BuiltColumn& built) { return distance_squared(built.column, centre); });
    std::vector<BuiltColumn> taken;
    for (; !finished_.empty() && taken.size() < most; finished_.pop_back()) {
        started_.erase(finished_.back().column);
        taken.push_back(std::move(finished_.back()));
    }
    return taken;
}

}  // namespace sl
