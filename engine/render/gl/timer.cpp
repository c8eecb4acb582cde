// SPDX-License-Identifier: MIT
#include "engine/render/gl/timer.h"

#include <string_view>

#include "engine/core/check.h"

namespace sl::gl {

SpanTimers::~SpanTimers() {
    in_flight_.push_back(std::move(current_));
    for (const Frame& frame : in_flight_) {
        for (const Span& span : frame) free_queries_.insert(free_queries_.end(), {span.begin, span.end});
    }
    if (!free_queries_.empty())
        glDeleteQueries(static_cast<GLsizei>(free_queries_.size()), free_queries_.data());
}

GLuint SpanTimers::stamp() {
    if (free_queries_.empty()) {
        free_queries_.resize(16);
        glCreateQueries(GL_TIMESTAMP, 16, free_queries_.data());
        const std::string_view renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        software_ = renderer.starts_with("llvmpipe") || renderer.starts_with("softpipe");
    }
    const GLuint query = free_queries_.back();
    free_queries_.pop_back();
    // llvmpipe takes the time once per tile and keeps the last, and runs compute at once but draws later:
    // without waiting, a span's time lands in its neighbours.
    if (software_) glFinish();
    glQueryCounter(query, GL_TIMESTAMP);
    if (software_) glFlush();
    return query;
}

void SpanTimers::begin_frame() {
    CHECK(!in_frame_, "begin_frame twice");
    in_frame_ = true;
    while (!in_flight_.empty() && collect(in_flight_.front(), false)) in_flight_.pop_front();
}

void SpanTimers::begin_span(const std::string& name, const std::string& group) {
    CHECK(in_frame_ && !in_span_, "span \"{}\" begins outside a frame or inside another span", name);
    in_span_ = true;
    current_.push_back({name, group, stamp(), 0});
}

void SpanTimers::end_span() {
    CHECK(in_span_, "end_span without begin_span");
    in_span_ = false;
    current_.back().end = stamp();
}

void SpanTimers::end_frame() {
    CHECK(in_frame_ && !in_span_, "end_frame inside a span or without begin_frame");
    in_frame_ = false;
    in_flight_.push_back(std::exchange(current_, {}));
}

void SpanTimers::abandon_frame() {
    in_frame_ = in_span_ = false;
    for (const Span& span : std::exchange(current_, {})) {
        free_queries_.push_back(span.begin);
        if (span.end != 0) free_queries_.push_back(span.end);
    }
}

void SpanTimers::finish() {
    for (; !in_flight_.empty(); in_flight_.pop_front()) collect(in_flight_.front(), true);
}

bool SpanTimers::collect(Frame& frame, bool wait) {
    for (const Span& span : frame) {
        GLint ready = GL_FALSE;
        glGetQueryObjectiv(span.end, GL_QUERY_RESULT_AVAILABLE, &ready);
        if (ready == GL_FALSE && !wait) return false;
    }
    newest_.clear();
    for (const Span& span : frame) {
        GLuint64 begin = 0, end = 0;
        glGetQueryObjectui64v(span.begin, GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(span.end, GL_QUERY_RESULT, &end);
        newest_.push_back({span.name, span.group, end > begin ? static_cast<double>(end - begin) * 1e-6 : 0.0});
        free_queries_.insert(free_queries_.end(), {span.begin, span.end});
    }
    return true;
}

}  // namespace sl::gl
