// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_accessor.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>

#include "engine/core/error.h"

namespace sl {

namespace {

/// Numbers of one accessor; and of one without data, which are zeros.
constexpr std::size_t most_numbers = std::size_t{1} << 26, most_zeros = std::size_t{1} << 22;

using Bytes = std::span<const unsigned char>;

template <class Integer>
double number(const unsigned char* at) {
    Integer value;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

/// One component, not normalized.
double component(int type, const unsigned char* at) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: return number<std::int8_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return number<std::uint8_t>(at);
        case TINYGLTF_COMPONENT_TYPE_SHORT: return number<std::int16_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return number<std::uint16_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return number<std::uint32_t>(at);
        default: return number<float>(at);
    }
}

/// What a normalized integer is divided by.
double largest(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: return 127.0;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 255.0;
        case TINYGLTF_COMPONENT_TYPE_SHORT: return 32767.0;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 65535.0;
        default: return 1.0;
    }
}

/// How an element lies in its bytes. Columns of matrices of small numbers begin at multiples of four bytes.
struct Layout {
    std::size_t rows = 1, columns = 1, component_bytes = 4;

    std::size_t column_bytes() const { return columns == 1 ? rows * component_bytes : (rows * component_bytes + 3) / 4 * 4; }
    std::size_t bytes() const { return (columns - 1) * column_bytes() + (columns == 1 ? column_bytes() : rows * component_bytes); }
    std::size_t width() const { return rows * columns; }
    std::size_t offset(std::size_t number) const { return number / rows * column_bytes() + number % rows * component_bytes; }
};

Layout layout_of(int type, int component_type, const std::string& name) {
    Layout layout;
    const int bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type));
    const bool known = component_type >= TINYGLTF_COMPONENT_TYPE_BYTE && component_type <= TINYGLTF_COMPONENT_TYPE_FLOAT && component_type != TINYGLTF_COMPONENT_TYPE_INT;
    if (!known || bytes <= 0) fail("{}: there is no component type {}", name, component_type);
    layout.component_bytes = static_cast<std::size_t>(bytes);
    switch (type) {
        case TINYGLTF_TYPE_SCALAR: layout.rows = 1; break;
        case TINYGLTF_TYPE_VEC2: layout.rows = 2; break;
        case TINYGLTF_TYPE_VEC3: layout.rows = 3; break;
        case TINYGLTF_TYPE_VEC4: layout.rows = 4; break;
        case TINYGLTF_TYPE_MAT2: layout.rows = layout.columns = 2; break;
        case TINYGLTF_TYPE_MAT3: layout.rows = layout.columns = 3; break;
        case TINYGLTF_TYPE_MAT4: layout.rows = layout.columns = 4; break;
        default: fail("{}: there is no such type of accessor", name);
    }
    return layout;
}

/// The bytes of a view from an offset on, and how far apart its elements are (0: as far as they are long).
struct View {
    Bytes bytes;
    std::size_t stride = 0;
};

View view_of(const tinygltf::Model& model, int number, std::size_t offset, const std::string& name) {
    if (number < 0 || static_cast<std::size_t>(number) >= model.bufferViews.size()) fail("{}: there is no buffer view {}", name, number);
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(number)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) fail("{}: buffer view {} has no buffer {}", name, number, view.buffer);
    const Bytes buffer(model.buffers[static_cast<std::size_t>(view.buffer)].data);
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
        fail("{}: buffer view {} reaches beyond the {} bytes of its buffer", name, number, buffer.size());
    }
    const Bytes bytes = buffer.subspan(view.byteOffset, view.byteLength);
    if (offset > bytes.size()) fail("{}: byte {} lies beyond the {} bytes of buffer view {}", name, offset, bytes.size(), number);
    return {bytes.subspan(offset), view.byteStride};
}

/// Throws unless so many elements fit.
void check_fit(const View& view, std::size_t count, const Layout& layout, const std::string& name) {
    const std::size_t stride = view.stride > 0 ? view.stride : layout.bytes();
    if (count > 0 && (view.bytes.size() < layout.bytes() || (count - 1) > (view.bytes.size() - layout.bytes()) / stride)) {
        fail("{}: {} elements of {} bytes do not fit into the {} bytes that are left of its buffer view", name, count, layout.bytes(), view.bytes.size());
    }
}

/// Calls `put(element, number in it, value)` for all components.
template <class Put>
void read(const View& view, std::size_t count, const Layout& layout, int type, Put&& put) {
    const std::size_t stride = view.stride > 0 ? view.stride : layout.bytes();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < layout.width(); ++k) put(i, k, component(type, &view.bytes[i * stride + layout.offset(k)]));
    }
}

template <class Number, class Convert>
std::vector<Number> read_accessor(const tinygltf::Model& model, int number, const std::string& where, AccessorValues& shape, Convert&& convert) {
    if (number < 0 || static_cast<std::size_t>(number) >= model.accessors.size()) fail("{}: there is no accessor {}", where, number);
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(number)];
    const std::string name = fmt::format("{}: /accessors/{}", where, number);
    const Layout layout = layout_of(accessor.type, accessor.componentType, name);
    const std::size_t most = (accessor.bufferView >= 0 ? most_numbers : most_zeros) / layout.width();
    if (accessor.count > most) fail("{}: {} elements are more than the {} that are read", name, accessor.count, most);
    shape.count = accessor.count;
    shape.width = layout.width();
    const double divisor = accessor.normalized ? largest(accessor.componentType) : 1.0;
    View view;
    if (accessor.bufferView >= 0) {
        view = view_of(model, accessor.bufferView, accessor.byteOffset, name);
        check_fit(view, accessor.count, layout, name);
    }
    std::vector<Number> numbers(accessor.count * layout.width());
    const auto put = [&](std::size_t element, std::size_t k, double value) { numbers[element * layout.width() + k] = convert(value, divisor); };
    if (accessor.bufferView >= 0) read(view, accessor.count, layout, accessor.componentType, put);
    if (!accessor.sparse.isSparse) return numbers;
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count) fail("{}: {} sparse elements of {}", name, sparse.count, accessor.count);
    const auto count = static_cast<std::size_t>(sparse.count);
    if (sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) fail("{}: an offset is negative", name);
    const Layout index_layout = layout_of(TINYGLTF_TYPE_SCALAR, sparse.indices.componentType, name);
    View places = view_of(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), name);
    View values = view_of(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), name);
    places.stride = values.stride = 0;
    check_fit(places, count, index_layout, name);
    check_fit(values, count, layout, name);
    std::vector<std::size_t> elements(count);
    read(places, count, index_layout, sparse.indices.componentType, [&](std::size_t i, std::size_t, double value) {
        if (!(value >= 0.0 && value < static_cast<double>(accessor.count))) fail("{}: the sparse index {} is none of {} elements", name, value, accessor.count);
        elements[i] = static_cast<std::size_t>(value);
    });
    read(values, count, layout, accessor.componentType, [&](std::size_t i, std::size_t k, double value) { put(elements[i], k, value); });
    return numbers;
}

}  // namespace

AccessorValues accessor_values(const tinygltf::Model& model, int accessor, const std::string& where) {
    AccessorValues result;
    result.numbers = read_accessor<float>(model, accessor, where, result, [](double value, double divisor) { return static_cast<float>(std::max(value / divisor, divisor == 1.0 ? value : -1.0)); });
    return result;
}

std::vector<std::uint32_t> accessor_indices(const tinygltf::Model& model, int accessor, const std::string& where) {
    AccessorValues shape;
    return read_accessor<std::uint32_t>(model, accessor, where, shape, [&](double value, double) {
        if (!(value >= 0.0 && value <= 4294967295.0)) fail("{}: accessor {} holds {}, which is no index", where, accessor, value);
        return static_cast<std::uint32_t>(value);
    });
}

}  // namespace sl
