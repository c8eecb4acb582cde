// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace sl {

/// Something that is wrong in a file.
struct GltfFault {
    std::string where;    ///< JSON pointer ("/meshes/0/primitives/1/indices"), or "byte 12" of a container
    std::string message;  ///< what is wrong, in one line, in plain words with the values that disagree
    bool fatal;           ///< the file cannot be loaded sensibly; otherwise it loads, and this is told
};

inline constexpr std::size_t most_gltf_faults = 50;

/// The faults of one file. Keeps the first `most_gltf_faults`; a fatal one always finds room, so that a file with
/// many small faults does not pass for one that can be loaded.
class GltfFaults {
  public:
    /// For what a viewer can ignore.
    template <class... Args>
    void note(std::string where, fmt::format_string<Args...> text, Args&&... args) {
        if (!is_full()) add(std::move(where), fmt::format(text, std::forward<Args>(args)...), false);
    }
    template <class... Args>
    void fatal(std::string where, fmt::format_string<Args...> text, Args&&... args) {
        if (!is_done()) add(std::move(where), fmt::format(text, std::forward<Args>(args)...), true);
    }

    /// Whether a note would still be kept.
    bool takes_notes() const { return !is_full(); }
    bool has_fatal() const { return has_fatal_; }
    /// Nothing that is found from here on would change what is told.
    bool is_done() const { return is_full() && has_fatal_; }
    const std::vector<GltfFault>& list() const { return list_; }

  private:
    bool is_full() const { return list_.size() >= most_gltf_faults; }
    void add(std::string where, std::string message, bool fatal);

    std::vector<GltfFault> list_;
    bool has_fatal_ = false;
};

/// Where a value stands in a document. A chain on the stack: the text is made only for a fault.
class GltfPlace {
  public:
    GltfPlace() = default;
    GltfPlace(const GltfPlace& owner, std::string_view key) : owner_(&owner), key_(key) {}
    GltfPlace(const GltfPlace& owner, std::size_t index) : owner_(&owner), index_(index), is_element_(true) {}
    GltfPlace(const GltfPlace&) = delete;
    GltfPlace& operator=(const GltfPlace&) = delete;

    /// A JSON pointer; "" for the document itself.
    std::string text() const;

  private:
    const GltfPlace* owner_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
    bool is_element_ = false;
};

}  // namespace sl
