// Bending of a free beam with a section that varies along its length. This one-dimensional model
// tunes bars before a three-dimensional one checks them.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace idiophone {

/// The properties of a cross-section, per metre of length.
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

/// Returns undamped frequencies in Hz of the `count` lowest bending modes of a beam free at both
/// ends, without the two rigid motions. `nodesMetres` are ascending positions from end to end. They
/// include every place where the section has an edge; between two, the section is smooth. The
/// quadratic elements use reduced integration, so they do not lock at any slenderness. With 48 of
/// them, the first four modes are within 1e-5. `count` ≤ 4 nodes.
std::vector<double> freeBeamFrequenciesHz(std::span<const double> nodesMetres,
                                          const std::function<BeamSection(double)>& sectionAt,
                                          int count);

} // namespace idiophone
