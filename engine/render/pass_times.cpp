// SPDX-License-Identifier: MIT
#include "engine/render/pass_times.h"

#include <algorithm>

#include "engine/render/frame.h"

namespace sl {

namespace {

std::string without_number(const std::string& pass) {
    const std::size_t end = pass.find_last_not_of("0123456789");
    const bool numbered = end != std::string::npos && end + 1 < pass.size() && pass[end] == '_';
    return numbered ? pass.substr(0, end) : pass;
}

}  // namespace

std::vector<gl::SpanTime> pass_times(std::span<const gl::SpanTime> spans) {
    std::vector<gl::SpanTime> rows;
    for (const gl::SpanTime& span : spans) {
        const std::string name = without_number(span.name);
        const auto row = std::ranges::find(rows, name, &gl::SpanTime::name);
        if (row == rows.end()) {
            rows.push_back({name, span.group, span.milliseconds});
        } else {
            row->milliseconds += span.milliseconds;
        }
    }
    return rows;
}

double gi_milliseconds(std::span<const gl::SpanTime> spans) {
    double sum = 0.0;
    for (const gl::SpanTime& span : spans) {
        if (span.group == gi_group) sum += span.milliseconds;
    }
    return sum;
}

}  // namespace sl
