// SPDX-License-Identifier: Apache-2.0
#include "Synth/StrikePoints.h"

#include <algorithm>

namespace idiophone {

StrikePoints::StrikePoints(std::shared_ptr<const ModalObject> modalObject)
    : object(std::move(modalObject)) {
    const auto ofMesh = vertexNormals(*object);
    for (const auto vertex : object->shapeVertices) {
        const auto first = ofMesh.begin() + 3 * static_cast<std::ptrdiff_t>(vertex);
        normals.insert(normals.end(), first, first + 3);
    }
}

StrikePoint StrikePoints::nearest(const std::array<double, 3>& pointMetres) const noexcept {
    const auto row = nearestShapeRow(*object, pointMetres);
    StrikePoint point{.shapeRows = {static_cast<std::int32_t>(row)}};
    std::copy_n(normals.begin() + 3 * static_cast<std::ptrdiff_t>(row), 3, point.normal.begin());
    return point;
}

} // namespace idiophone
