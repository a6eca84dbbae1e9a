// Bending of a free beam whose section varies along its length: the one-dimensional model that
// tunes bars before a three-dimensional one confirms them.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace idiophone {

/// A cross-section, per metre of length.
struct BeamSection {
    double bendingStiffnessNM2 = 0; ///< E I, > 0
    double shearStiffnessN = 0;     ///< κ G A, > 0
    double massKgPerM = 0;          ///< ρ A, > 0
    double rotaryInertiaKgM = 0;    ///< ρ I, > 0
};

/// κ of a rectangular section (Cowper 1966).
constexpr double rectangularShearCoefficient(double poissonRatio) noexcept {
    return 10 * (1 + poissonRatio) / (12 + 11 * poissonRatio);
}

/// Undamped frequencies in Hz of the `count` lowest bending modes, the two rigid motions left out,
/// of a beam that is free at both ends. `nodesMetres` are ascending places along it, from end to
/// end, among them every place where the section has an edge; between two the section is smooth.
/// Quadratic elements with reduced integration, which neither lock nor depend on the slenderness:
/// with 48 of them the first four modes are within 1e-5. `count` ≤ 4 nodes.
std::vector<double> freeBeamFrequenciesHz(std::span<const double> nodesMetres,
                                          const std::function<BeamSection(double)>& sectionAt,
                                          int count);

} // namespace idiophone
