// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/gl/gl.h"

namespace sl::gl {

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
    void begin_span(const std::string& name);
    void end_span();
    void end_frame();

    /// Milliseconds per span of the newest frame whose queries are all ready, in execution order.
    const std::vector<std::pair<std::string, double>>& newest() const { return newest_; }
    /// Waits for every frame in flight, so that newest() is the last frame.
    void finish();

  private:
    struct Span {
        std::string name;
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
    std::vector<std::pair<std::string, double>> newest_;
};

}  // namespace sl::gl
