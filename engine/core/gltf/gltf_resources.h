// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// Bytes of a file beside the document. The path is relative, its escapes are resolved, and it may be anything: who
/// loads decides which folders it may lead to. Throws Error that names the file where it is not read.
using GltfLoad = std::function<std::vector<std::byte>(const std::string& path)>;

/// What accessors may hold together of so many stored bytes: they may overlap, and elements that are all zeros are not stored. A
/// short file must not take long.
constexpr std::size_t most_gltf_bytes(std::size_t stored) { return 4 * stored + (std::size_t{1} << 27); }

/// What a document's buffers and images hold. Moving keeps the spans valid.
class GltfResources {
  public:
    using Bytes = std::span<const std::byte>;

    GltfResources() = default;
    GltfResources(const GltfResources&) = delete;
    GltfResources& operator=(const GltfResources&) = delete;
    GltfResources(GltfResources&&) = default;
    GltfResources& operator=(GltfResources&&) = default;

    /// What a document comes in.
    struct Container {
        bool is_container = false;
        std::optional<Bytes> binary;  ///< its BIN chunk
    };

    /// Of a document whose structure has no fatal fault. Without `load`, files beside are as if they were not mentioned.
    void load(const nlohmann::json& document, const Container& container, const GltfLoad& load, GltfFaults& faults);

    /// As long as the document states, or empty: it does not say where its bytes are, or that is no file beside.
    const std::vector<Bytes>& buffers() const { return buffers_; }
    /// Undecoded; empty where the bytes are not there. Two are the same bytes or share none: what is made of them is in proportion to
    /// what is stored.
    const std::vector<Bytes>& images() const { return images_; }
    /// Where the document refers to what is no file beside it, such as "http://x/a.png": "/images/0/uri". It may, and nobody
    /// looks for that.
    const std::vector<std::string>& elsewhere() const { return elsewhere_; }
    /// Of everything, where what serves twice counts once.
    std::size_t stored_bytes() const { return stored_bytes_; }

  private:
    struct Found {
        std::string fault;  ///< why there are no bytes; empty where there are, and where nobody looks for them
        Bytes bytes;        ///< with an address, even if there are none, where they were found
        std::string media_type;
    };

    Found find(const std::string& uri, const GltfLoad& load, const GltfPlace& place);
    Bytes read_buffer(const nlohmann::json& buffer, std::optional<Bytes> binary, const GltfLoad& load,
                      const GltfPlace& place, GltfFaults& faults);
    Bytes read_image(const nlohmann::json& image, const nlohmann::json& views, const GltfLoad& load,
                     const GltfPlace& place, GltfFaults& faults);
    void leave_out_overlapping_images(GltfFaults& faults);

    std::vector<Bytes> buffers_, images_;
    std::vector<std::string> elsewhere_;
    struct File {
        std::string fault;
        std::vector<std::byte> bytes;
    };
    std::map<std::string, File> files_;  ///< each is loaded once
    std::deque<std::vector<std::byte>> decoded_;
    std::size_t stored_bytes_ = 0;
};

}  // namespace sl
