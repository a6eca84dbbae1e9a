// Which turns and mirrors map a mesh onto itself, for solvers that need to treat but one sector of
// it. Only groups whose elements commute: their solutions fall apart into one set for each
// character.
#pragma once

#include "Geometry/Mesh.h"

#include <complex>
#include <vector>

namespace idiophone {

/// A group of G commuting isometries of a mesh of F faces.
///
/// Every function f on the faces is the sum over the characters χ of parts with
/// f_χ(g·face) = χ(g) f_χ(face), which the orbits' first faces tell of.
struct SurfaceSymmetry {
    std::vector<std::vector<int>> images; ///< [G][F] where each face goes; the first is identity
    /// [G×G] one row for each character, its value of each element.
    Eigen::MatrixXcd characters;

    Eigen::Index order() const { return characters.rows(); }
};

/// The largest that is found: mirrors of the coordinate planes through the centroid, or turns by a
/// whole part of a circle about a line along a coordinate axis through it, perhaps with the mirror
/// across. Of a mesh without any, the identity alone. Vertices may be off by 1e-6 of the size.
SurfaceSymmetry surfaceSymmetry(const Mesh& mesh);

/// The identity alone.
SurfaceSymmetry noSymmetry(const Mesh& mesh);

/// Faces that the elements take to each other.
struct SurfaceOrbits {
    std::vector<int> firsts;   ///< of each orbit one face; they lie side by side, as one sector
    std::vector<int> orbits;   ///< [F] which orbit a face is in
    std::vector<int> elements; ///< [F] an element that takes the orbit's first face there
    /// [orbits] whether other elements than the identity leave its faces in place. Only functions
    /// of characters that are 1 for these elements live there.
    std::vector<bool> areFixed;
};
SurfaceOrbits orbitsOf(const SurfaceSymmetry& symmetry, const Mesh& mesh);

} // namespace idiophone
