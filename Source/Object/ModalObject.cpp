// SPDX-License-Identifier: Apache-2.0
#include "Object/ModalObject.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace idiophone {
namespace {

template <class Values>
bool allFinite(const Values& values) {
    return std::ranges::all_of(values, [](auto value) { return std::isfinite(value); });
}

/// Returns false if a value exceeds the limit or is NaN.
template <class Values, class Limit>
bool allWithin(const Values& values, Limit limit) {
    return std::ranges::all_of(values, [limit](auto value) { return std::abs(value) <= limit; });
}

// Also the limit of vertices in a mesh file.
constexpr double maximumMetres = 1e6;

std::string sizesFault(const ModalObject& object) {
    if (object.modeCount() == 0)
        return "it has no modes";
    if (object.modeCount() > maximumObjectModes)
        return "it has more than " + std::to_string(maximumObjectModes) + " modes";
    if (object.shapeVertexCount() == 0)
        return "no vertex carries mode shapes";
    if (object.vertices.size() % 3 != 0 || object.faces.size() % 3 != 0)
        return "vertices and faces must come in threes";
    // Divide instead of multiplying, so that a hostile size cannot wrap around.
    if (object.shapes.size() % 3 != 0 || object.shapes.size() / 3 % object.modeCount() != 0 ||
        object.shapes.size() / 3 / object.modeCount() != object.shapeVertexCount())
        return "the size of the mode shapes is not vertices x modes x 3";
    for (const auto& [name, size] : {std::pair{"bending parts", object.bending.size()},
                                     {"decays", object.decaysPerSecond.size()},
                                     {"extra decays", object.extraDecaysPerSecond.size()},
                                     {"gains", object.gains.size()}})
        if (size != 0 && size != object.modeCount())
            return std::string("the ") + name + " are not one for each mode";
    return {};
}

std::string eigenvaluesFault(const ModalObject& object) {
    if (!allFinite(object.eigenvalues) || !allFinite(object.bending))
        return "an eigenvalue is not a finite number";
    if (!(object.eigenvalues.front() > 0))
        return "an eigenvalue is not positive";
    if (!std::ranges::is_sorted(object.eigenvalues))
        return "the eigenvalues are not in ascending order";
    // The model does not hold beyond 1 GHz, and later squares could overflow. Below 1 mHz, the size
    // of a tuned key could overflow.
    if (object.eigenvalues.back() > 4e19)
        return "an eigenvalue lies beyond 1 GHz";
    if (object.eigenvalues.front() < 3.9e-5)
        return "an eigenvalue lies below 1 mHz";
    for (std::size_t mode = 0; mode < object.bending.size(); ++mode)
        if (object.bending[mode] < 0 || object.bending[mode] > object.eigenvalues[mode])
            return "a bending part is not between 0 and its eigenvalue";
    return {};
}

std::string decaysFault(const ModalObject& object) {
    // No object decays faster than in a nanosecond.
    constexpr double fastestPerSecond = 1e9;
    // This ratio multiplies the damping of other materials.
    constexpr double largestScale = 1e12;
    for (std::size_t mode = 0; mode < object.decaysPerSecond.size(); ++mode) {
        const double decay = object.decaysPerSecond[mode];
        if (!(decay > 0 && decay <= fastestPerSecond))
            return "a decay is not between 0 and 1e9 per second";
        if (!(object.material.damping.perSecond(object.eigenvalues[mode]) > 0))
            return "its modes have decays, but its material has no damping to scale them by";
        if (object.damping(mode).scale > largestScale)
            return "a decay is more than 1e12 times what its material's damping makes it";
    }
    for (const double decay : object.extraDecaysPerSecond)
        if (!(decay >= 0 && decay <= fastestPerSecond))
            return "an extra decay is not between 0 and 1e9 per second";
    return {};
}

std::string geometryFault(const ModalObject& object) {
    if (!allWithin(object.shapes, largestShape))
        return "a mode shape is not between -1e8 and 1e8 per √kg";
    if (!allWithin(object.vertices, maximumMetres))
        return "a vertex does not lie within 1000 km";
    const auto vertexCount = static_cast<std::int64_t>(object.vertexCount());
    const auto isVertex = [&](std::int32_t index) { return index >= 0 && index < vertexCount; };
    if (!std::ranges::all_of(object.faces, isVertex))
        return "a face names a vertex that does not exist";
    if (!std::ranges::all_of(object.shapeVertices, isVertex))
        return "the list of vertices with shapes names a vertex that does not exist";
    if (std::ranges::adjacent_find(object.shapeVertices, std::greater_equal{}) !=
        object.shapeVertices.end())
        return "the list of vertices with shapes is not in ascending order";
    if (!std::ranges::all_of(object.clampedVertices, isVertex) ||
        std::ranges::adjacent_find(object.clampedVertices, std::greater_equal{}) !=
            object.clampedVertices.end())
        return "the list of clamped vertices is not one of vertices in ascending order";
    return {};
}

std::string radiationFault(const ModalObject& object) {
    if (auto fault = faultOf(object.radiation, object.modeCount()); !fault.empty())
        return fault;
    if (!allWithin(object.gains, 1e3f))
        return "a gain is beyond 1000";
    return {};
}

std::string scalarsFault(const ModalObject& object) {
    if (!(object.thicknessMetres >= 0 && object.thicknessMetres <= maximumMetres) ||
        (object.body == BodyKind::shell && object.thicknessMetres == 0))
        return "the thickness is not a positive number of at most 1000 km";
    if (object.body == BodyKind::shell && object.thicknessMetres < 1e-9)
        return "the thickness of the shell is less than a nanometre";
    if (!std::isfinite(object.bandHz) || object.bandHz <= 0)
        return "the analysed band is not a positive number";
    // The minimum is the mass of objects whose shapes would be far too large, the maximum that of
    // the moon.
    const double massKg = object.mass.massKg;
    if (!(massKg >= 1e-18 && massKg <= 1e23))
        return "the mass is not between 1e-18 and 1e23 kg";
    if (!allWithin(object.mass.centreMetres, maximumMetres))
        return "the centre does not lie within 1000 km";
    constexpr double maximumApartSquared = 12 * maximumMetres * maximumMetres;
    if (!allWithin(object.mass.inertiaKgM2, maximumApartSquared * massKg))
        return "the inertia is larger than 1.2e13 m² times its mass";
    if (!std::isfinite(object.provenance.analysisSeconds))
        return "the analysis time is not a finite number";
    return {};
}

std::string textsFault(const ModalObject& object) {
    // JSON inside JSON writes a byte as up to seven, and a file's header is limited to 1 MiB.
    constexpr std::size_t longestBytes = 128 * 1024;
    const auto bytes = object.name.size() + object.method.size() + object.material.name.size() +
                       object.material.source.size() + object.provenance.source.size() +
                       object.provenance.software.size() + object.provenance.notes.size();
    return bytes > longestBytes ? "its texts are longer than 128 KiB" : std::string();
}

} // namespace

Result<ModalObject> validated(ModalObject object) {
    if (auto material = validated(object.material); !material)
        return failure(material.error().message);
    for (const auto fault : {textsFault, sizesFault, eigenvaluesFault, decaysFault, geometryFault,
                             radiationFault, scalarsFault})
        if (const auto sentence = fault(object); !sentence.empty())
            return failure(sentence);
    return object;
}

std::vector<float> vertexNormals(const ModalObject& object) {
    std::vector<double> sums(object.vertices.size(), 0.0);
    const auto coordinate = [&](std::int32_t vertex, int axis) {
        return static_cast<double>(object.vertices[vertex * 3 + axis]);
    };
    for (std::size_t face = 0; face < object.faceCount(); ++face) {
        const auto* corner = &object.faces[face * 3];
        std::array<double, 3> u{}, v{};
        for (int axis = 0; axis < 3; ++axis) {
            u[axis] = coordinate(corner[1], axis) - coordinate(corner[0], axis);
            v[axis] = coordinate(corner[2], axis) - coordinate(corner[0], axis);
        }
        // The cross product is twice the area long, which weights the sum by area.
        const std::array<double, 3> cross{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                          u[0] * v[1] - u[1] * v[0]};
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis)
                sums[corner[c] * 3 + axis] += cross[axis];
    }
    std::vector<float> normals(object.vertices.size());
    for (std::size_t i = 0; i < normals.size(); i += 3) {
        const double length = std::hypot(sums[i], sums[i + 1], sums[i + 2]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            normals[i + axis] = length > 0 ? static_cast<float>(sums[i + axis] / length)
                                           : (axis == 2 ? 1.0f : 0.0f);
    }
    return normals;
}

std::vector<double> summedSquareShapes(const ModalObject& object) {
    std::vector<double> sums(object.modeCount());
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
        const auto shapes = object.shapesAt(row);
        for (std::size_t k = 0; k < shapes.size(); ++k)
            sums[k / 3] += static_cast<double>(shapes[k]) * static_cast<double>(shapes[k]);
    }
    return sums;
}

std::optional<std::size_t> sharingPartner(const ModalObject& object, std::size_t mode) noexcept {
    const auto isPartner = [&](std::size_t other) {
        if (other == mode || !object.isShared(other) ||
            std::abs(object.gains[mode] + object.gains[other]) < 0.5f)
            return false;
        for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
            const auto shapes = object.shapesAt(row);
            if (!std::ranges::equal(shapes.subspan(3 * mode, 3), shapes.subspan(3 * other, 3)))
                return false;
        }
        return true;
    };
    for (std::size_t other = 0; object.isShared(mode) && other < object.modeCount(); ++other)
        if (isPartner(other))
            return other;
    return std::nullopt;
}

std::size_t nearestShapeRow(const ModalObject& object, const std::array<double, 3>& pointMetres) {
    std::size_t nearest = 0;
    double nearestSquared = std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
        const auto* vertex = &object.vertices[object.shapeVertices[row] * 3];
        double squared = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double difference = vertex[axis] - pointMetres[axis];
            squared += difference * difference;
        }
        if (squared < nearestSquared) {
            nearestSquared = squared;
            nearest = row;
        }
    }
    return nearest;
}

} // namespace idiophone
