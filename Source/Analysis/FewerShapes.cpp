#include "Analysis/FewerShapes.h"

#include "Geometry/SpreadVertices.h"
#include "Object/HalfFloat.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace idiophone {
namespace {

std::vector<std::size_t> spreadRows(const ModalObject& object, std::size_t count) {
    const auto place = [&](std::size_t row) {
        return &object.vertices[object.shapeVertices[row] * 3];
    };
    return spreadPlaces<float>(object.shapeVertexCount(), count, [&](std::size_t i, std::size_t j) {
        const float *p = place(i), *q = place(j);
        const float x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
        return x * x + y * y + z * z;
    });
}

} // namespace

ModalObject withFewerShapes(ModalObject object, std::size_t rows) {
    if (object.shapeVertexCount() > rows) {
        std::vector<float> shapes;
        std::vector<std::int32_t> vertices;
        for (const auto row : spreadRows(object, rows)) {
            const auto kept = object.shapesAt(row);
            shapes.insert(shapes.end(), kept.begin(), kept.end());
            vertices.push_back(object.shapeVertices[row]);
        }
        object.shapes = std::move(shapes);
        object.shapeVertices = std::move(vertices);
    }
    constexpr float largestHalf = 65504;
    for (float& shape : object.shapes)
        shape = halfToFloat(floatToHalf(std::clamp(shape, -largestHalf, largestHalf)));
    return object;
}

} // namespace idiophone
