// SPDX-License-Identifier: MIT
#include "editor/frame_report.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "engine/render/pass_times.h"

namespace sl {

namespace {

PassReport pass_report(const FrameGraph& graph, const PassRecord& pass, std::span<const gl::SpanTime> spans) {
    const FrameGraph::PassImages images = graph.images_of(pass);
    PassReport report{.name = pass.name,
                      .indirect = pass.group == gi_group,
                      .reads = fmt::format("{}", fmt::join(images.reads, ", ")),
                      .writes = fmt::format("{}", fmt::join(images.writes, ", "))};
    if (pass.draws != nullptr) {
        report.draws = pass.draws->size();
        for (const DrawCall& call : *pass.draws) report.triangles += call.index_count / 3;
    }
    if (const auto span = std::ranges::find(spans, pass.name, &gl::SpanTime::name); span != spans.end()) {
        report.milliseconds = span->milliseconds;
    }
    return report;
}

}  // namespace

FrameReport frame_report(Renderer& renderer, const Renderer::Result& frame) {
    FrameReport report{.drawn = frame.drawn};
    if (!frame.drawn) return report;
    const FrameGraph& graph = renderer.graph();
    const std::vector<gl::SpanTime>& spans = renderer.executor().timers().newest();
    const TextureDesc& final = graph.resources()[frame.images.final.index].image;
    report.size = {final.width, final.height};
    for (const Step& step : renderer.steps()) {
        const PassRecord& pass = graph.passes()[static_cast<std::size_t>(step.pass)];
        report.passes.push_back(pass_report(graph, pass, spans));
    }
    report.times = pass_times(spans);
    report.traced_milliseconds = 1e3 * frame.images.gi_traced_seconds;
    report.triangles_drawn = frame.triangles_drawn;
    report.triangles_culled = frame.triangles_culled;
    report.lights_without_maps = frame.lights_without_maps;
    report.texture_bytes = renderer.executor().texture_bytes();
    report.mesh_bytes = renderer.gpu_bytes() - report.texture_bytes;
    report.noise = frame.images.gi_error;
    report.progress = frame.images.gi_progress;
    return report;
}

}  // namespace sl
