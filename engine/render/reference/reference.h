// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

#include "engine/render/reference/film.h"

namespace sl {

/// When a reference is done, and which part of it is traced.
struct ReferencePlan {
    FilmBlock block;            ///< pixels, and the most samples
    double noise = 0.0;         ///< also stop when Film::noise() is at most this; 0: never
    double seconds_between = 5.0;  ///< calls of `save` at least; the first one comes with the first samples. More where saving takes long
};

/// What a reference tells while it grows.
struct ReferenceProgress {
    std::uint32_t samples = 0;    ///< per pixel, done
    double share = 0.0;           ///< of the expected work, 0 to 1
    double noise = 0.0;
    std::uint64_t rays = 0;       ///< traced in this run
    double seconds = 0.0;         ///< of this run
};

/// Traces what the plan still lacks of a film, in passes over the block on all processors. The result does not depend on
/// threads or passes. `tell` is called after each pass and answers whether to go on; `save` from time to time and at the
/// end. Returns the last progress.
ReferenceProgress trace_reference(const PathTracer& tracer, Film& film, const ReferencePlan& plan,
                                  const std::function<bool(const ReferenceProgress&)>& tell, const std::function<void()>& save = {});

/// A film with as many samples per pixel; for tests and tables.
Film trace_film(const RenderScene& scene, uvec2 size, const TransportSettings& settings, std::uint32_t samples);

}  // namespace sl
