#include "Synth/Listening.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace idiophone {
namespace {

constexpr double slowestDecay = 1e-3; // [1/s] for objects without damping

} // namespace

double radiationScale(const ModalObject& object) {
    const std::size_t modes = object.modeCount();
    if (object.radiation.empty() || object.shapeVertexCount() == 0)
        return 0;
    std::vector<double> meanSquares(modes);
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
        const auto shapes = object.shapesAt(row);
        for (std::size_t k = 0; k < shapes.size(); ++k)
            meanSquares[k / 3] += static_cast<double>(shapes[k]) * static_cast<double>(shapes[k]) /
                                  static_cast<double>(object.shapeVertexCount());
    }
    // Those of the channels, whatever others there are for listeners elsewhere.
    const std::size_t directions = std::min<std::size_t>(object.radiation.directions.size(), 2);
    std::vector<float> weights(modes);
    double near = 0;
    double far = 0;
    for (std::size_t direction = 0; direction < directions; ++direction) {
        object.radiation.weightsAt(direction, 1, weights);
        for (std::size_t i = 0; i < modes; ++i) {
            const auto weight = static_cast<double>(weights[i]);
            const double ringing =
                meanSquares[i] / std::max(object.decayPerSecond(i), slowestDecay);
            near += ringing * meanSquares[i];
            far += ringing * weight * weight;
        }
    }
    if (!(far > 0))
        return 0;
    // No weight becomes larger than a shape may be, however faint these two directions are.
    float largest = 0;
    for (const float weight : object.radiation.weights)
        largest = std::max(largest, std::abs(weight));
    return std::min(std::sqrt(near / far), static_cast<double>(largestShape) / largest);
}

} // namespace idiophone
