// Builds the parts of furniture from simple bodies: beams, tubes, rings and discs.
#pragma once

#include "Editor/Appearance.h"
#include "Editor/SceneObject.h"
#include "Editor/SceneVertex.h"

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace idiophone {

/// A drawn thing that cannot be struck.
struct FurniturePart {
    SceneObject shape;
    Appearance look;
    /// The object whose bodies it follows, in that object's coordinates; nothing: it stands still.
    std::optional<std::size_t> object;
    /// For a disc in a tube: the middle of its axis along x, about which the motor turns it.
    std::optional<ScenePlace> turnsAbout;
};

/// All lengths in metres. Bodies added between two calls of `finish` form one part.
class FurnitureParts {
public:
    using Vector = Eigen::Vector3f;

    /// `firstVertex` is the number of the first vertex in the picture's buffers.
    explicit FurnitureParts(std::size_t firstVertex) : base(firstVertex), begin(firstVertex) {}

    /// A bar of rectangular section from one end to the other. `up` is roughly its upper side.
    void addBeam(const Vector& from,
                 const Vector& to,
                 float width,
                 float height,
                 const Vector& up = Vector::UnitZ());
    /// A round bar with closed ends, which may taper.
    void addRod(const Vector& from, const Vector& to, float fromRadius, float toRadius, int sides);
    /// An upright pipe, open above and closed below.
    void addPipe(const Vector& top, float length, float radius, float wall, int sides);
    /// A lying ring of round section.
    void addRing(const Vector& middle, float radius, float thickness, int sides);
    /// A thin round plate, which faces along `normal`.
    void
    addDisc(const Vector& middle, const Vector& normal, float radius, float thickness, int sides);

    void addBall(const Vector& middle, float radius, int sides);

    /// Ends the part of all that was added since the last one.
    FurniturePart& finish(const Appearance& look, Form form = Form::free);

    std::vector<SceneVertex> vertices;
    std::vector<FurniturePart> parts;

private:
    void addFace(const Vector& a, const Vector& b, const Vector& c);
    void addQuad(const std::array<Vector, 4>& places, const std::array<Vector, 4>& normals);
    void addWall(const Vector& from,
                 const Vector& to,
                 float fromRadius,
                 float toRadius,
                 int sides,
                 bool inward);
    void addCap(const Vector& middle, const Vector& normal, float radius, int sides);

    std::size_t base, begin;
};

} // namespace idiophone
