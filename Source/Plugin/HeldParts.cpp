#include "Plugin/HeldParts.h"

namespace idiophone {
namespace {

ClampRegion endOf(const Eigen::AlignedBox3d& box, bool isLow) {
    constexpr double depthShare = 0.002; // an end that is not flat is held by more than a point
    Eigen::Index axis = 0;
    const double depth = depthShare * box.sizes().maxCoeff(&axis);
    return {{.axis = static_cast<int>(axis),
             .isBelow = isLow,
             .metres = isLow ? box.min()(axis) + depth : box.max()(axis) - depth}};
}

} // namespace

std::vector<std::string> namesOfGroups(const HoldableParts& parts, const Mesh& mesh) {
    std::vector<std::string> names;
    for (const auto& group : parts.groups)
        if (static_cast<Eigen::Index>(group.faces.size()) < mesh.faceCount())
            names.push_back(group.name);
    return names;
}

Result<Support>
supportOf(const HeldSettings& held, const HoldableParts& parts, const Mesh& meshMetres) {
    using Kind = HeldSettings::Kind;
    if (!(held.quality >= 0))
        return failure("The quality factor of the support must not be negative.");
    Support support;
    if (held.quality > 0)
        support.quality = held.quality;
    const auto box = boxOfFaces(meshMetres);
    switch (held.kind) {
    case Kind::free:
        break;
    case Kind::lowEnd:
    case Kind::highEnd:
        support.clamps.push_back(endOf(box, held.kind == Kind::lowEnd));
        break;
    case Kind::group: {
        const auto group = findGroup(parts.groups, held.group);
        if (!group)
            return tl::unexpected(group.error());
        support.faces = (*group)->faces;
        break;
    }
    case Kind::places: {
        const double longest = box.sizes().maxCoeff();
        for (const auto& place : held.places)
            support.balls.push_back(
                {.centreMetres = box.min() + longest * Eigen::Vector3d(place.data()),
                 .radiusMetres = HeldSettings::placeRadius * longest});
        break;
    }
    case Kind::asBefore:
        support.vertices = parts.clampedVertices;
        break;
    }
    return support;
}

} // namespace idiophone
