// SPDX-License-Identifier: MIT
#include "engine/render/gi/sliced.h"

#include <algorithm>

namespace sl {

namespace {

/// About a tenth of a second of a two-core software rasterizer: pixels × texels in one draw. A window stays live so.
constexpr double samples_per_slice = 1.5e7;
/// Mesa's software rasterizer ends every shader loop after 65,535 rounds, silently.
constexpr std::uint32_t texels_per_slice = 32768;

std::uint64_t work_key(const FrameInput& frame, const Rsm& rsm, const SlicedSum& sum) {
    FrameParams still = frame.params;
    still.counts.y = 0;  // the frame's number changes nothing
    std::uint64_t key = hash_bytes(frame.scene.geometry_hash(), sum.name.data(), sum.name.size());
    key = hash_bytes(key, &still, sizeof still);
    key = hash_bytes(key, &sum.params, sizeof sum.params);
    return hash_mix(hash_mix(key, rsm.key), sum.texels);
}

void add_inputs(PassBuilder& pass, const FrameInput& frame, const GBuffer& gbuffer, const SlicedSum& sum, const RsmGatherParams& params) {
    pass.params("Frame", frame.params).params("Gather", params).read("depth", gbuffer.depth).read("normal", gbuffer.normal);
    sum.inputs(pass);
}

}  // namespace

GiResult sliced_sum(const FrameInput& frame, const GBuffer& gbuffer, const Rsm& rsm, const SlicedSum& sum) {
    FrameGraph& graph = frame.graph;
    const double samples = double(frame.width) * frame.height * sum.texels;
    const std::uint32_t slices = std::clamp(static_cast<std::uint32_t>(samples / samples_per_slice) + 1,
                                            sum.texels / texels_per_slice + 1, std::max(sum.texels, 1u));

    const std::string partial_name = fmt::format("{}_partial", sum.name);
    ImageId partial = graph.persistent(partial_name, frame.screen(Format::rgba32f));
    PersistentStates::Progress& progress = graph.states().progress(partial_name);
    const std::uint64_t key = work_key(frame, rsm, sum);
    if (graph.needs_redraw(partial, 0, key) || progress.key != key) progress = {.key = key, .done = 0};

    const std::uint32_t stop = progress.done + std::min(frame.slice_budget, slices - progress.done);
    for (; progress.done < stop; ++progress.done) {
        RsmGatherParams params = sum.params;
        params.slice = uvec4(progress.done, slices, sum.texels, 0);
        auto pass = graph.fullscreen(fmt::format("{}_{}", sum.name, progress.done), sum.fragment);
        add_inputs(pass, frame, gbuffer, sum, params);
        partial = pass.blend_add().write("partial", partial, progress.done == 0 ? Load::clear : Load::keep);
    }

    GiResult result{.irradiance = graph.persistent("irradiance", frame.screen(Format::rgba32f)),
                    .progress = static_cast<float>(progress.done) / static_cast<float>(slices)};
    if (!graph.needs_redraw(result.irradiance, 0, hash_mix(key, progress.done))) return result;
    RsmGatherParams params = sum.params;
    params.map.w = 1.0f / std::max(result.progress, 1e-6f);
    const bool finished = progress.done == slices && !sum.finish.empty();
    auto pass = graph.fullscreen(sum.name, finished ? sum.finish : "gi/scale_partial.frag");
    if (finished) {
        add_inputs(pass, frame, gbuffer, sum, params);
        sum.finish_inputs(pass);
    } else {
        pass.params("Gather", params);
    }
    pass.read("partial", partial);
    result.irradiance = pass.write("irradiance", result.irradiance, Load::discard);
    return result;
}

}  // namespace sl
