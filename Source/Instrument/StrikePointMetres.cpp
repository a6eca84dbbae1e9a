#include "Instrument/StrikePointMetres.h"

namespace idiophone {

std::array<double, 3> strikePointMetres(const ModalObject& object,
                                        const StrikePoint& point) noexcept {
    std::array<double, 3> place{};
    for (std::size_t k = 0; k < point.weights.size(); ++k) {
        if (point.weights[k] == 0)
            continue;
        const auto row = static_cast<std::size_t>(point.shapeRows[k]);
        const auto vertex = static_cast<std::size_t>(object.shapeVertices[row]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] += static_cast<double>(point.weights[k]) *
                           static_cast<double>(object.vertices[3 * vertex + axis]);
    }
    return place;
}

} // namespace idiophone
