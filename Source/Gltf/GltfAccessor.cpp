// SPDX-License-Identifier: Apache-2.0
#include "Gltf/GltfAccessor.h"

#include "Gltf/TinyGltf.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace idiophone {
namespace {

/// An accessor without a buffer is all zeros, however few bytes the file has.
constexpr std::size_t largestEmptyAccessor = std::size_t{1} << 24;

template <class Number>
double numberAt(const unsigned char* bytes, bool isNormalised) {
    Number number{};
    std::memcpy(&number, bytes, sizeof(number));
    const auto value = static_cast<double>(number);
    if (!isNormalised || std::is_floating_point_v<Number>)
        return value;
    return std::max(value / static_cast<double>(std::numeric_limits<Number>::max()), -1.0);
}

using NumberReader = double (*)(const unsigned char*, bool);

NumberReader readerOf(int componentType) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return numberAt<std::int8_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return numberAt<std::uint8_t>;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return numberAt<std::int16_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return numberAt<std::uint16_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return numberAt<std::uint32_t>;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return numberAt<float>;
    default:
        return nullptr;
    }
}

/// Elements of equal size in a buffer, each `stride` bytes after the former.
struct BufferPart {
    const unsigned char* begin = nullptr;
    std::size_t stride = 0;
};

/// Returns where `count` elements of `elementBytes` lie. `stride` is 0 for elements without gaps.
Result<BufferPart> partOf(const tinygltf::Model& model,
                          int viewNumber,
                          std::size_t offset,
                          std::size_t count,
                          std::size_t elementBytes,
                          bool mayBeStrided) {
    const auto outside = [] { return failure("one of its accessors lies outside its buffer"); };
    if (viewNumber < 0 || static_cast<std::size_t>(viewNumber) >= model.bufferViews.size())
        return outside();
    const auto& view = model.bufferViews[static_cast<std::size_t>(viewNumber)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
        return outside();
    const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    const std::size_t stride =
        mayBeStrided && view.byteStride != 0 ? view.byteStride : elementBytes;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset ||
        offset > view.byteLength)
        return outside();
    const std::size_t bytes = view.byteLength - offset;
    if (count > 0 && (bytes < elementBytes || (count - 1) > (bytes - elementBytes) / stride))
        return outside();
    return BufferPart{.begin = data.data() + view.byteOffset + offset, .stride = stride};
}

/// Replaces the rows that a sparse accessor names.
Result<void> replaceSparse(Eigen::MatrixXd& rows,
                           const tinygltf::Model& model,
                           const tinygltf::Accessor& accessor,
                           NumberReader read,
                           std::size_t componentBytes) {
    const auto& sparse = accessor.sparse;
    const auto readIndex = readerOf(sparse.indices.componentType);
    // Newer versions of tinygltf have unsigned offsets.
    if (readIndex == nullptr || sparse.count < 0 || std::cmp_less(sparse.indices.byteOffset, 0) ||
        std::cmp_less(sparse.values.byteOffset, 0))
        return failure("a sparse accessor is malformed");
    const auto count = static_cast<std::size_t>(sparse.count);
    const auto indices = partOf(model, sparse.indices.bufferView,
                                static_cast<std::size_t>(sparse.indices.byteOffset), count,
                                static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(
                                    static_cast<std::uint32_t>(sparse.indices.componentType))),
                                false);
    const auto columns = static_cast<std::size_t>(rows.cols());
    const auto values =
        partOf(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
               count, columns * componentBytes, false);
    if (!indices)
        return failure(indices.error().message);
    if (!values)
        return failure(values.error().message);
    for (std::size_t i = 0; i < count; ++i) {
        const double row = readIndex(indices->begin + i * indices->stride, false);
        if (!(row >= 0 && row < static_cast<double>(rows.rows())))
            return failure("a sparse accessor names an element that does not exist");
        for (std::size_t column = 0; column < columns; ++column)
            rows(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = read(
                values->begin + i * values->stride + column * componentBytes, accessor.normalized);
    }
    return {};
}

} // namespace

Result<Eigen::MatrixXd> numbersOf(const GltfDocument& document, int number, int columns) {
    const auto& model = document.model();
    if (number < 0 || static_cast<std::size_t>(number) >= model.accessors.size())
        return failure("accessor " + std::to_string(number) + " does not exist");
    const auto& accessor = model.accessors[static_cast<std::size_t>(number)];
    const auto read = readerOf(accessor.componentType);
    if (read == nullptr ||
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != columns)
        return failure("accessor " + std::to_string(number) + " has another type than its use");
    const auto componentBytes = static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
    const auto width = static_cast<std::size_t>(columns);
    std::optional<BufferPart> part;
    if (accessor.bufferView >= 0) {
        const auto found = partOf(model, accessor.bufferView, accessor.byteOffset, accessor.count,
                                  width * componentBytes, true);
        if (!found)
            return failure(found.error().message);
        part = *found;
    } else if (accessor.count > largestEmptyAccessor) {
        return failure("accessor " + std::to_string(number) + " is too large");
    }
    Eigen::MatrixXd rows =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(accessor.count), columns);
    if (part)
        for (std::size_t row = 0; row < accessor.count; ++row)
            for (std::size_t column = 0; column < width; ++column)
                rows(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
                    read(part->begin + row * part->stride + column * componentBytes,
                         accessor.normalized);
    if (accessor.sparse.isSparse)
        if (const auto done = replaceSparse(rows, model, accessor, read, componentBytes); !done)
            return failure(done.error().message);
    return rows;
}

} // namespace idiophone
