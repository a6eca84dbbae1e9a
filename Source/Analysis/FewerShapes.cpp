#include "Analysis/FewerShapes.h"

#include "Object/HalfFloat.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace idiophone {
namespace {

/// Ascending.
std::vector<std::size_t> spreadRows(const ModalObject& object, std::size_t count) {
    std::vector<std::size_t> chosen{0};
    std::vector<float> distance2(object.shapeVertexCount(), std::numeric_limits<float>::max());
    const auto place = [&](std::size_t row) {
        return &object.vertices[static_cast<std::size_t>(object.shapeVertices[row]) * 3];
    };
    while (chosen.size() < count) {
        const float* last = place(chosen.back());
        for (std::size_t row = 0; row < distance2.size(); ++row) {
            const float* p = place(row);
            const float x = p[0] - last[0], y = p[1] - last[1], z = p[2] - last[2];
            distance2[row] = std::min(distance2[row], x * x + y * y + z * z);
        }
        const auto farthest = std::ranges::max_element(distance2);
        if (*farthest <= 0)
            break;
        chosen.push_back(static_cast<std::size_t>(farthest - distance2.begin()));
    }
    std::ranges::sort(chosen);
    return chosen;
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
