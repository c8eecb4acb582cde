// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/gbuffer.h"
#include "engine/render/passes/rsm.h"

namespace sl {

/// What a GI method gives back: diffuse irradiance (lux, before albedo) in the units of direct light.
struct GiResult {
    ImageId irradiance;  ///< rgba32f at the G-buffer's size, or a black pixel
    /// Share of work done where it is spread over frames (1 = finished).
    float progress = 1.0f;
    /// Spent on the CPU's own light transport, s.
    double traced_seconds = 0.0;
    /// Standard error that sampling leaves, over the irradiance; unknown where a method does not say.
    std::optional<float> error;
};

/// The contract: the frame and its settings in, irradiance out. One overload per method, each in gi/NAME.cpp.
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const GiOff& settings);
/// Sums all texels of the lights' maps, over frames where that takes long.
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmExact& settings);
/// Sums a grid of texels with the paper's thresholds.
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmGrid& settings);
/// Samples texels round each receiver, at low resolution where neighbours agree.
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmDisc& settings);
/// Looks up what is kept on the surfaces, and works on that for as long as the settings allow.
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const Facets& settings);
/// Calls the overload of the method that is held; it must be the engine's or have been added.
GiResult run_gi_method(const FrameInput& frame, const GBuffer& gbuffer, const GiMethod& method);

/// What stands behind a method's name; see add_gi_method.
using GiBody = GiResult (*)(const FrameInput&, const GBuffer&, const GiMethod&);
/// Calls the overload of T, which must be the method that is held.
template <GiMethodSettings T>
GiResult call_indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const GiMethod& method) {
    return indirect_light(frame, gbuffer, method.get<T>());
}
/// The half of add_gi_method that frames need.
void add_gi_body(const GiMethodType& type, GiBody body);

/// Adds a GI method: a settings struct T with visit_fields(FieldVisitor&, T&) and
/// GiResult indirect_light(const FrameInput&, const GBuffer&, const T&) beside it. Frames, scene files, --set and the editor
/// know it from then on, like the engine's own. Call it once, before a scene is read and before any frame is drawn.
template <GiMethodSettings T>
void add_gi_method() {
    add_gi_method_type(GiMethod::type_of<T>());
    add_gi_body(GiMethod::type_of<T>(), &call_indirect_light<T>);
}

}  // namespace sl
