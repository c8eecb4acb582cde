// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/gl/gl.h"

namespace sl::gl {

/// What one span of a frame took.
struct SpanTime {
    std::string name, group;
    double milliseconds = 0.0;
};

/// GPU time per named span, from timestamp queries, without stalling: results arrive some frames later. Spans
/// of a frame follow each other, they do not nest. A software renderer is waited for at each end of a span.
/// Must be destroyed while its context is current.
class SpanTimers {
  public:
    SpanTimers() = default;
    ~SpanTimers();
    SpanTimers(const SpanTimers&) = delete;
    SpanTimers& operator=(const SpanTimers&) = delete;

    void begin_frame();
    void begin_span(const std::string& name, const std::string& group = {});
    void end_span();
    void end_frame();
    /// Drops the frame that is being timed, wherever it stopped.
    void abandon_frame();

    /// Spans of the newest frame whose queries are all ready, in execution order.
    const std::vector<SpanTime>& newest() const { return newest_; }
    /// Waits for every frame in flight, so that newest() is the last frame.
    void finish();

  private:
    struct Span {
        std::string name, group;
        GLuint begin, end;
    };
    using Frame = std::vector<Span>;
    GLuint stamp();
    bool collect(Frame& frame, bool wait);

    std::deque<Frame> in_flight_;
    Frame current_;
    bool software_ = false;  ///< the renderer is Mesa's, on the processor
    bool in_frame_ = false;
    bool in_span_ = false;
    std::vector<GLuint> free_queries_;
    std::vector<SpanTime> newest_;
};

}  // namespace sl::gl
