// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/render/reference/film.h"

namespace sl {

/// What a reference is a picture of. Files of one ReferenceInfo may be continued and merged.
struct ReferenceInfo {
    std::string scene;
    std::uint64_t content = 0;  ///< PathTracer::content_hash()
    uvec2 size{0};
    TransportSettings transport;

    /// Throws Error naming the two files and what differs first.
    static void check_same(const ReferenceInfo& a, const std::string& a_name, const ReferenceInfo& b, const std::string& b_name);
};

/// A path-traced picture and how it was made.
struct ReferenceFile {
    ReferenceInfo info;
    Film film;
};

/// An EXR with the film's layers for people and programs, and its sums (layers "sum_..."), from which it continues. Each
/// sum is two floats that add up to 48 bits of it. Throws Error naming the file; an old file stays whole until then.
void write_reference(const std::filesystem::path& path, const ReferenceInfo& info, const Film& film);

/// Throws Error naming the file and what is wrong with it.
ReferenceFile read_reference(const std::filesystem::path& path);

}  // namespace sl
