#include "Instrument/ObjectBox.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace idiophone {

ObjectBox::ObjectBox(const ModalObject& object) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double lowest = std::numeric_limits<double>::infinity();
        double highest = -lowest;
        for (std::size_t i = axis; i < object.vertices.size(); i += 3) {
            lowest = std::min(lowest, static_cast<double>(object.vertices[i]));
            highest = std::max(highest, static_cast<double>(object.vertices[i]));
        }
        centreMetres[axis] = (lowest + highest) / 2;
        halfExtentMetres[axis] = (highest - lowest) / 2;
    }
}

std::array<double, 3> ObjectBox::at(const std::array<double, 3>& relative) const {
    std::array<double, 3> point{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        point[axis] = centreMetres[axis] + relative[axis] * halfExtentMetres[axis];
    return point;
}

std::array<double, 3> ObjectBox::relative(const std::array<double, 3>& pointMetres) const {
    std::array<double, 3> result{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (halfExtentMetres[axis] > 0)
            result[axis] = std::clamp(
                (pointMetres[axis] - centreMetres[axis]) / halfExtentMetres[axis], -1.0, 1.0);
    return result;
}

double ObjectBox::reachMetres(const std::array<double, 3>& direction) const {
    double reach = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        reach += std::abs(direction[axis]) * halfExtentMetres[axis];
    return reach;
}

std::size_t ObjectBox::longestAxis() const {
    return static_cast<std::size_t>(std::ranges::max_element(halfExtentMetres) -
                                    halfExtentMetres.begin());
}

} // namespace idiophone
