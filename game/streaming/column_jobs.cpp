// SPDX-License-Identifier: MIT
#include "game/streaming/column_jobs.h"

#include <algorithm>

namespace sl {

namespace {

constexpr std::size_t most_started = 12;

/// One processor is left to what the frame needs at once.
unsigned threads() {
    return std::max(2u, std::thread::hardware_concurrency()) - 1;
}

}  // namespace

ColumnJobs::ColumnJobs() {
    for (unsigned i = 0; i < threads(); ++i) threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
}

void ColumnJobs::work(const std::stop_token& stop) {
    for (std::unique_lock lock(mutex_); wake_.wait(lock, stop, [this] { return !waiting_.empty(); }) && !stop.stop_requested();) {
        const Build build = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        BuiltColumn built = build();
        lock.lock();
        built_.push_back(std::move(built));
    }
}

bool ColumnJobs::full() const {
    return started_.size() >= most_started;
}

void ColumnJobs::start(ivec2 column, Build build) {
    started_.insert(column);
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(build));
    wake_.notify_one();
}

void ColumnJobs::outdate(ivec2 column) {
    if (has(column)) outdated_.insert(column);
}

std::vector<BuiltColumn> ColumnJobs::take(ivec2 centre, std::size_t most) {
    {
        const std::lock_guard lock(mutex_);
        std::ranges::move(built_, std::back_inserter(finished_));
        built_.clear();
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
