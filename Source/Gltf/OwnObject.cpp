// SPDX-License-Identifier: Apache-2.0
#include "Gltf/OwnObject.h"

#include "Gltf/GltfAccessor.h"
#include "Gltf/TinyGltf.h"
#include "Object/ModalObjectBytes.h"

#include <algorithm>
#include <span>

namespace idiophone {
namespace {

std::span<const std::byte> bytesOf(const tinygltf::Model& model, std::size_t viewNumber) {
    const auto& view = model.bufferViews[viewNumber];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
        return {};
    const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        return {};
    return std::as_bytes(std::span(data)).subspan(view.byteOffset, view.byteLength);
}

/// Returns an accessor of `count` different indices below `end`.
std::optional<std::vector<std::size_t>> indicesOf(const GltfDocument& document,
                                                  std::optional<int> accessor,
                                                  std::size_t count,
                                                  std::size_t end) {
    if (!accessor)
        return {};
    const auto numbers = numbersOf(document, *accessor, 1);
    if (!numbers || static_cast<std::size_t>(numbers->size()) != count)
        return {};
    std::vector<bool> isUsed(end);
    std::vector<std::size_t> indices;
    for (const double number : numbers->reshaped()) {
        const auto index = number >= 0 && number < static_cast<double>(end)
                               ? static_cast<std::size_t>(number)
                               : end;
        if (index == end || isUsed[index])
            return {};
        isUsed[index] = true;
        indices.push_back(index);
    }
    return indices;
}

/// Returns whether the model has the object's frequencies, decays and places, in single precision.
bool agree(const GltfModalModel& model,
           const ModalObject& object,
           const std::vector<std::size_t>& modes,
           const std::vector<std::size_t>& vertices) {
    const auto isSame = [](double stored, double exact) {
        return static_cast<float>(stored) == static_cast<float>(exact);
    };
    for (std::size_t i = 0; i < modes.size(); ++i)
        if (!isSame(model.frequenciesHz[i], object.dampedFrequencyHz(modes[i])) ||
            !isSame(model.decaysPerSecond[i], object.decayPerSecond(modes[i])))
            return false;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (static_cast<float>(model.positions(static_cast<Eigen::Index>(i),
                                                   static_cast<Eigen::Index>(axis))) !=
                object.vertices[3 * vertices[i] + axis])
                return false;
    return true;
}

} // namespace

std::optional<ModalObject> ownObject(const GltfDocument& document, const GltfModalModel& model) {
    if (!model.objectView)
        return {};
    auto object = readModalObject(bytesOf(document.model(), *model.objectView), model.name);
    const auto modeCount = model.frequenciesHz.size();
    const auto pointCount = static_cast<std::size_t>(model.pointCount());
    if (!object)
        return {};
    const auto modes = indicesOf(document, model.modesAccessor, modeCount, object->modeCount());
    const auto vertices =
        indicesOf(document, model.verticesAccessor, pointCount, object->vertexCount());
    if (!modes || !vertices || !agree(model, *object, *modes, *vertices))
        return {};
    if (object->shapeVertexCount() == pointCount)
        return *std::move(object); // it is whole
    if (modeCount != object->modeCount())
        return {};
    object->shapeVertices.assign(vertices->begin(), vertices->end());
    object->shapes.resize(pointCount * modeCount * 3);
    for (std::size_t i = 0; i < modeCount; ++i)
        for (std::size_t point = 0; point < pointCount; ++point)
            for (std::size_t axis = 0; axis < 3; ++axis)
                object->shapes[(point * modeCount + (*modes)[i]) * 3 + axis] = static_cast<float>(
                    model.shapes(static_cast<Eigen::Index>(i * pointCount + point),
                                 static_cast<Eigen::Index>(axis)));
    auto whole = validated(*std::move(object));
    if (!whole)
        return {};
    return *std::move(whole);
}

} // namespace idiophone
