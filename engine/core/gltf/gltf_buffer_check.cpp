// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_buffer_check.h"

#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

constexpr std::size_t matrix_alignment = 4;

/// Whole numbers of a document stay below 2^53 and strides below 256: no sum here overflows.
class Buffers {
  public:
    Buffers(const json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults)
        : document_(document), layout_(layout), uses_(uses), faults_(faults) {}

    void check_views() {
        for (std::size_t i = 0; i < layout_.views.size() && !faults_.is_done(); ++i) {
            const GltfView& view = layout_.views[i];
            const std::size_t length = layout_.buffer_lengths[view.buffer];
            const auto where = [&] { return fmt::format("/bufferViews/{}", i); };
            if (view.offset + view.length > length) {
                faults_.fatal(where(), "bytes {} to {} lie outside buffer {}, which has {}", view.offset,
                              view.offset + view.length, view.buffer, length);
            }
            if (view.stride > view.length) {
                faults_.note(where() + "/byteStride", "is {}, more than the whole view's {} bytes", view.stride, view.length);
            }
            if (view.stride > 0 && view.target == gltf_index_target) {
                faults_.note(where() + "/byteStride", "only views of vertices may have one; this one holds indices");
            }
        }
    }

    void check_accessors() {
        for (std::size_t i = 0; i < layout_.accessors.size() && !faults_.is_done(); ++i) {
            const GltfAccessor& accessor = layout_.accessors[i];
            if (!accessor.format.is_known()) continue;
            const std::string where = fmt::format("/accessors/{}", i);
            check_format(accessor.format, gltf_list(document_, "accessors")[i], where);
            if (accessor.view) check_range(accessor, where);
            if (accessor.sparse) check_sparse(accessor, i, where);
        }
    }

  private:
    void check_format(const GltfFormat& format, const json& accessor, const std::string& where) {
        const bool is_fraction = format.component == GltfComponent::float32;
        if (format.is_normalized && (is_fraction || format.component == GltfComponent::uint32)) {
            faults_.note(where + "/normalized", "components of the type {} cannot be normalized",
                         is_fraction ? "float32" : "uint32");
        }
        for (const std::string_view bound : {"min", "max"}) {
            const auto found = accessor.find(bound);
            if (found == accessor.end() || found->size() == format.components()) continue;
            faults_.note(fmt::format("{}/{}", where, bound), "has {} numbers; an element has {}", found->size(),
                         format.components());
        }
    }

    void check_range(const GltfAccessor& accessor, const std::string& where) {
        const GltfView& view = layout_.views[*accessor.view];
        const GltfFormat& format = accessor.format;
        const std::size_t alignment = gltf_component_bytes(format.component);
        if (accessor.stride < format.element_bytes()) {
            faults_.note(where, "elements of {} bytes lie {} bytes apart: they overlap", format.element_bytes(),
                         accessor.stride);
        }
        if (accessor.offset % alignment != 0) {
            faults_.note(where + "/byteOffset", "is {}, no multiple of the component's {} bytes", accessor.offset, alignment);
        } else if ((view.offset + accessor.offset) % alignment != 0) {
            faults_.note(where + "/byteOffset", "is {} in the buffer, no multiple of the component's {} bytes",
                         view.offset + accessor.offset, alignment);
        }
        if (format.is_matrix() && (accessor.offset % matrix_alignment != 0 || accessor.stride % matrix_alignment != 0)) {
            faults_.note(where, "the matrices do not begin at multiples of {} bytes", matrix_alignment);
        }
        const std::size_t end = accessor.offset + accessor.stride * (accessor.count - 1) + format.element_bytes();
        if (end > view.length) {
            faults_.fatal(where, "ends at byte {} of buffer view {}, which has {}", end, *accessor.view, view.length);
        }
    }

    void check_sparse(const GltfAccessor& accessor, std::size_t index, const std::string& where) {
        const GltfSparse& sparse = *accessor.sparse;
        if (sparse.count > accessor.count) {
            faults_.fatal(where + "/sparse/count", "replaces {} elements of {}", sparse.count, accessor.count);
        }
        const std::size_t index_bytes = gltf_component_bytes(sparse.index_component);
        check_packed(sparse.index_view, sparse.index_offset, sparse.count * index_bytes, index_bytes,
                     where + "/sparse/indices");
        const GltfFormat& format = accessor.format;
        check_packed(sparse.value_view, sparse.value_offset,
                     (sparse.count - 1) * format.packed_bytes() + format.element_bytes(),
                     gltf_component_bytes(format.component), where + "/sparse/values");
        const GltfPlace root, list(root, "accessors"), at(list, index), part(at, "sparse");
        uses_.use_view(sparse.index_view, GltfViewUse::other, GltfPlace(part, "indices"));
        uses_.use_view(sparse.value_view, GltfViewUse::other, GltfPlace(part, "values"));
    }

    void check_packed(std::size_t view_index, std::size_t offset, std::size_t bytes, std::size_t alignment,
                      const std::string& where) {
        const GltfView& view = layout_.views[view_index];
        if ((view.offset + offset) % alignment != 0) {
            faults_.note(where + "/byteOffset", "is {} in the buffer, no multiple of the component's {} bytes",
                         view.offset + offset, alignment);
        }
        if (offset + bytes > view.length) {
            faults_.fatal(where, "ends at byte {} of buffer view {}, which has {}", offset + bytes, view_index, view.length);
        }
    }

    const json& document_;
    const GltfLayout& layout_;
    GltfViewUses& uses_;
    GltfFaults& faults_;
};

}  // namespace

void check_gltf_buffers(const json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults) {
    Buffers buffers(document, layout, uses, faults);
    buffers.check_views();
    buffers.check_accessors();
}

}  // namespace sl
