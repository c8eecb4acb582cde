// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/render/format.h"

namespace sl {

/// Names one version of an image or buffer in a frame. Writing gives a new version and retires the old one.
struct ResourceId {
    static constexpr std::uint32_t none = ~0u;
    std::uint32_t index = none;
    std::uint32_t version = 0;

    explicit operator bool() const { return index != none; }
    bool operator==(const ResourceId&) const = default;
};
struct ImageId : ResourceId {};
struct BufferId : ResourceId {};

/// How long an image or buffer is there.
enum class Lifetime {
    transient,   ///< lives from its first write to its last read of this frame
    persistent,  ///< survives frames under its name, as long as its description stays
    external     ///< a GL object of somebody else
};

/// An image or buffer as one frame's graph knows it.
struct ResourceRecord {
    std::string name;
    Lifetime lifetime = Lifetime::transient;
    bool is_buffer = false;
    TextureDesc image;
    std::uint64_t buffer_bytes = 0;
    std::uint32_t native = 0;        ///< GL name, for external ones
    std::uint32_t version = 0;       ///< newest
    std::vector<int> writers;        ///< pass that made each version; -1 for version 0
};

/// What is known, across frames, about the contents of persistent images and buffers: for each layer, the key that it
/// was last made from. Holds no GL.
class PersistentStates {
  public:
    /// What is known of one persistent image or buffer.
    struct State {
        TextureDesc image;
        std::uint64_t buffer_bytes = 0;
        std::vector<std::uint64_t> keys;  ///< per layer; 0 = nothing drawn
        std::uint64_t last_frame = 0;
    };

    /// Made anew where it is not known, or was of another size or format.
    State& find(const ResourceRecord& resource);
    /// Forgets all contents (after a lost or replaced executor).
    void clear() { states_.clear(); }
    std::uint64_t frame = 0;

    /// Progress of work that is spread over frames (gi/sliced.h): steps done for a key.
    struct Progress {
        std::uint64_t key = 0;
        std::uint32_t done = 0;
    };
    Progress& progress(const std::string& name) { return progress_[name]; }

  private:
    std::map<std::string, State> states_;
    std::map<std::string, Progress> progress_;
};

}  // namespace sl
