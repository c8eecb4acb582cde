// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "engine/render/reference/reference.h"

namespace sl {

/// The path-traced truth of what a camera sees, growing in the background while nothing moves, for those who tune a
/// picture against it. A thread of its own traces a copy of the scene.
class LiveReference {
  public:
    /// What there is so far. Linear layers as Film::layers() names them.
    struct Picture {
        std::vector<ImageLayer> layers;
        std::uint32_t samples = 0;  ///< per pixel
        double noise = 0.0;         ///< Film::noise()
        double seconds = 0.0;       ///< since it began
        double share = 0.0;         ///< of the way to the noise that was asked for, 0 to 1

        const Image& layer(std::string_view name) const;
    };

    /// `wanted_noise`: tracing ends there; `most_samples`: or there.
    explicit LiveReference(const TransportSettings& transport = {}, double wanted_noise = 0.01, std::uint32_t most_samples = 65536);
    ~LiveReference();
    LiveReference(const LiveReference&) = delete;
    LiveReference& operator=(const LiveReference&) = delete;

    /// Once a frame: begins anew when the scene, its light, the view or the size are others than in the last call, once all
    /// have rested for a moment; what was traced is gone at once.
    void follow(const RenderScene& scene, uvec2 size, double seconds);
    /// Stops, and forgets what was traced.
    void stop();

    /// The newest; null while there is none.
    std::shared_ptr<const Picture> picture() const;
    /// What went wrong in the background; empty while nothing did.
    std::string problem() const;

  private:
    struct Job;

    void work(const std::stop_token& stop);
    void trace(const std::shared_ptr<const Job>& job, const std::stop_token& stop);

    TransportSettings transport_;
    double wanted_noise_;
    std::uint32_t most_samples_;
    std::uint64_t seen_ = 0;     ///< hash of what the last call saw
    double rested_ = 0.0;        ///< s without a change
    bool begun_ = false;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::shared_ptr<const Job> wanted_;  ///< null: nothing is to be traced
    std::shared_ptr<const Picture> picture_;
    std::string problem_;
    std::jthread thread_;  ///< last: it ends before what it uses
};

}  // namespace sl
