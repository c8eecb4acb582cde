// SPDX-License-Identifier: MIT
#pragma once

#include <future>
#include <memory>
#include <optional>

#include "engine/measure/metrics.h"
#include "engine/render/reference/live_reference.h"

namespace sl {

/// How far the live picture is from the reference.
struct CompareFigures {
    ErrorMetrics irradiance;   ///< of indirect light
    double flip = 0.0;         ///< mean of the tonemapped picture's
    double truth_noise = 0.0;  ///< of the reference's irradiance
    std::uint32_t samples = 0; ///< of the reference
    Image error;               ///< relative_error_map of the irradiance
};

/// What figures are made from; of one size.
struct CompareInput {
    std::shared_ptr<const LiveReference::Picture> reference;
    Image irradiance;       ///< live, lux
    Image picture;          ///< live, as shown
    float exposure = 1.0f;  ///< of both
};

/// A linear picture as the screen shows it.
Image shown(const Image& radiance, float exposure);

/// Throws Error where a picture holds what is no number.
CompareFigures compare_figures(const CompareInput& input);

/// Makes figures in the background, one set after the other.
class CompareWorker {
  public:
    bool busy() const { return future_.valid(); }
    /// Not while busy.
    void begin(CompareInput input);
    /// The newest that is done; none while there is none. Takes over what has come since the last call.
    const std::optional<CompareFigures>& figures();
    void forget() { forgotten_ = true, figures_.reset(), problem_.clear(); }
    const std::string& problem() const { return problem_; }

  private:
    std::future<CompareFigures> future_;
    std::optional<CompareFigures> figures_;
    std::string problem_;
    bool forgotten_ = false;  ///< what is being made is of something that is no more
};

}  // namespace sl
