// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_elements.h"

#include <algorithm>

namespace sl {

namespace {

template <class Number>
double number_at(const std::byte* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<double>(number);
}

/// The bytes from where a view and an offset lead; empty where its buffer is.
std::span<const std::byte> bytes_from(const GltfView& view, std::size_t offset, GltfElements::Buffers buffers) {
    const auto buffer = buffers[view.buffer];
    if (buffer.size() < view.offset + view.length) return {};
    return buffer.subspan(view.offset, view.length).subspan(std::min(offset, view.length));
}

}  // namespace

double read_gltf_number(const std::byte* bytes, GltfComponent component) {
    switch (component) {
        case GltfComponent::int8: return number_at<std::int8_t>(bytes);
        case GltfComponent::uint8: return number_at<std::uint8_t>(bytes);
        case GltfComponent::int16: return number_at<std::int16_t>(bytes);
        case GltfComponent::uint16: return number_at<std::uint16_t>(bytes);
        case GltfComponent::uint32: return number_at<std::uint32_t>(bytes);
        case GltfComponent::float32: return static_cast<double>(number_at<float>(bytes));
    }
    return 0.0;
}

std::optional<GltfElements> GltfElements::read(const GltfLayout& layout, Buffers buffers, std::size_t index) {
    const GltfAccessor& accessor = layout.accessors[index];
    if (!accessor.format.is_known() || (!accessor.view && !accessor.sparse)) return std::nullopt;
    GltfElements elements;
    elements.format_ = accessor.format;
    elements.count_ = accessor.count;
    elements.stride_ = accessor.stride;
    for (std::size_t k = 0; k < elements.components(); ++k) {
        const std::size_t column = k / accessor.format.rows, row = k % accessor.format.rows;
        elements.component_at_[k] = static_cast<std::uint8_t>(column * accessor.format.column_bytes() + row * gltf_component_bytes(accessor.format.component));
    }
    if (accessor.view) {
        elements.bytes_ = bytes_from(layout.views[*accessor.view], accessor.offset, buffers);
        if (elements.bytes_.empty()) return std::nullopt;
    }
    if (accessor.sparse) elements.replace(layout, buffers, accessor);
    if (elements.bytes_.empty()) return std::nullopt;
    return elements;
}

void GltfElements::replace(const GltfLayout& layout, Buffers buffers, const GltfAccessor& accessor) {
    const GltfSparse& sparse = *accessor.sparse;
    const auto indices = bytes_from(layout.views[sparse.index_view], sparse.index_offset, buffers);
    const auto values = bytes_from(layout.views[sparse.value_view], sparse.value_offset, buffers);
    if (indices.empty() || values.empty()) {
        bytes_ = {};
        return;
    }
    const std::size_t step = format_.packed_bytes(), size = format_.element_bytes();
    copy_.resize(count_ * step);
    for (std::size_t i = 0; i < count_ && !bytes_.empty(); ++i) std::memcpy(&copy_[i * step], &bytes_[i * stride_], size);
    const std::size_t index_bytes = gltf_component_bytes(sparse.index_component);
    for (std::size_t i = 0; i < sparse.count; ++i) {
        const auto index = static_cast<std::size_t>(read_gltf_number(&indices[i * index_bytes], sparse.index_component));
        if (index < count_) std::memcpy(&copy_[index * step], &values[i * step], size);
    }
    bytes_ = copy_;
    stride_ = step;
}

double GltfElements::stored(std::size_t element, std::size_t component) const {
    return read_gltf_number(&bytes_[element * stride_ + component_at_[component]], format_.component);
}

double GltfElements::value(std::size_t element, std::size_t component) const {
    const double number = stored(element, component);
    return format_.is_normalized ? std::max(number / one(), -1.0) : number;
}

double GltfElements::one() const {
    if (!format_.is_normalized) return 1.0;
    switch (format_.component) {
        case GltfComponent::int8: return INT8_MAX;
        case GltfComponent::uint8: return UINT8_MAX;
        case GltfComponent::int16: return INT16_MAX;
        case GltfComponent::uint16: return UINT16_MAX;
        default: return 1.0;
    }
}

}  // namespace sl
