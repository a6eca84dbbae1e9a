// Finds the turns and mirrors that map a mesh onto itself, so that solvers need only one sector of
// it. All elements of a group commute, so that solutions separate into one set per character.
#pragma once

#include "Mesh/Mesh.h"

#include <complex>
#include <vector>

namespace idiophone {

/// A group of G commuting isometries of a mesh of F faces.
///
/// Every function f on the faces is a sum of parts, one per character χ, with f_χ(g·face) = χ(g)
/// f_χ(face). The values on the orbits' first faces determine a part.
struct SurfaceSymmetry {
    std::vector<std::vector<int>> images; ///< [G][F] images of the faces; first the identity
    /// [G×G] a row per character with its value for each element.
    Eigen::MatrixXcd characters;

    Eigen::Index order() const { return characters.rows(); }
};

/// Returns the largest group found. It consists of mirrors at coordinate planes through the
/// centroid, or of turns about a coordinate axis through it, possibly with the mirror across. A
/// mesh without symmetry gets the identity alone. Vertices may be off by 1e-6 of the size.
SurfaceSymmetry surfaceSymmetry(const Mesh& mesh);

/// Orbits: sets of faces that the elements map to each other.
struct SurfaceOrbits {
    std::vector<int> firsts;   ///< one face of each orbit, side by side in a sector
    std::vector<int> orbits;   ///< [F] the orbit of each face
    std::vector<int> elements; ///< [F] an element that maps the orbit's first face to this one
    /// [orbits] true if elements other than the identity map a face to itself. Only parts with a
    /// character of 1 for these elements are nonzero there.
    std::vector<bool> areFixed;
};
SurfaceOrbits orbitsOf(const SurfaceSymmetry& symmetry, const Mesh& mesh);

} // namespace idiophone
