#include "Editor/BodyPlacement.h"

namespace idiophone {
namespace {

/// The columns of the turn.
std::array<ScenePlace, 3> axesOf(const BodyNow& body) {
    const auto [x, y, z, w] = body.turn;
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
             {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
             {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}};
}

} // namespace

std::array<float, 16> matrixOf(const BodyNow& body) {
    const auto axes = axesOf(body);
    std::array<float, 16> matrix{};
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row)
            matrix[4 * column + row] = axes[column][row];
    for (std::size_t row = 0; row < 3; ++row)
        matrix[12 + row] = body.originMetres[row];
    matrix[15] = 1;
    return matrix;
}

ScenePlace turned(const BodyNow& body, const ScenePlace& direction) {
    const auto axes = axesOf(body);
    ScenePlace result{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            result[row] += axes[column][row] * direction[column];
    return result;
}

ScenePlace turnedBack(const BodyNow& body, const ScenePlace& direction) {
    const auto axes = axesOf(body);
    ScenePlace result{};
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row)
            result[column] += axes[column][row] * direction[row];
    return result;
}

ScenePlace onStage(const BodyNow& body, const ScenePlace& own) {
    auto place = turned(body, own);
    for (std::size_t axis = 0; axis < 3; ++axis)
        place[axis] += body.originMetres[axis];
    return place;
}

ScenePlace onBody(const BodyNow& body, const ScenePlace& place) {
    ScenePlace off = place;
    for (std::size_t axis = 0; axis < 3; ++axis)
        off[axis] -= body.originMetres[axis];
    return turnedBack(body, off);
}

} // namespace idiophone
