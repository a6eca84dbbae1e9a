// Sound outside a closed vibrating surface, by boundary elements. Computes the surface pressure
// from the velocity, and the pressure at a distant listener.
#pragma once

#include "Analysis/BoundaryRow.h"
#include "Analysis/SharedUnknowns.h"
#include "Analysis/SurfaceSymmetry.h"
#include "Mesh/Mesh.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace idiophone {

/// The time factor is e^{+jωt}. Each triangle is one unknown, collocated at its centroid. The
/// method is Burton & Miller 1971 (Proc. R. Soc. A 323): the Helmholtz integral equation plus β
/// times its normal derivative. Resonances of the enclosed space then cause no error.
///
///     p/2 − K p − β N p = −S q − β (q/2 + K' q),   q = ∂p/∂n = −jωρ v_n,   β = −j min(1/k, h)
///
/// S, K, K' and N are the single layer, the double layer, its adjoint and the hypersingular
/// operator of e^{−jkr}/(4πr). h is the mean edge of the triangles. For near triangles, the parts
/// that grow as r → 0 are integrated in closed form (PanelPotentials) and the rest by Gauss rules.
/// So the two faces of a sheet may be much closer than its triangles are wide.
///
/// With a symmetry of G elements, one system of F unknowns becomes a system of F/G unknowns for
/// each character that the velocity contains. The velocity itself need not be symmetric.
///
/// Immutable, so any number of threads may share it.
class BoundaryElements {
public:
    /// `surface` is closed and oriented outward, with F faces, none degenerate. `symmetry` is that
    /// of `surface`. If there are more orbits than `maximumUnknowns`, neighbouring triangles with
    /// similar normals share an unknown (SharedUnknowns). The pressure then loses detail, but the
    /// velocity does not.
    BoundaryElements(const Mesh& surface,
                     SurfaceSymmetry symmetry,
                     Eigen::Index maximumUnknowns = std::numeric_limits<Eigen::Index>::max());

    Eigen::Index faceCount() const { return static_cast<Eigen::Index>(rows_.panels().size()); }
    /// The size of the system of each character.
    Eigen::Index unknownCount() const { return unknowns_.count; }
    Eigen::Index symmetryOrder() const { return symmetry_.order(); }

    /// Returns pressures [F×M] in Pa for outward velocities [F×M] in m/s at the wave number k > 0
    /// in rad/m. Error: `cancelledMessage`.
    Result<Eigen::MatrixXcd> surfacePressures(double waveNumber,
                                              const Eigen::MatrixXd& normalVelocities,
                                              const WorkControl& control = {}) const;

    /// Returns W [D×M] in Pa·m. The pressure at a large distance R from `originMetres` along each
    /// of the unit `directions` [D×3] is p = W e^{−jkR}/R with
    ///
    ///     W = 1/4π ∫ [jωρ v_n + jk (d·n) p] e^{jk d·y} dS.
    Eigen::MatrixXcd farField(double waveNumber,
                              const Eigen::MatrixXd& directions,
                              const Eigen::Vector3d& originMetres,
                              const Eigen::MatrixXd& normalVelocities,
                              const Eigen::MatrixXcd& pressures) const;

    /// Returns pressures [P×M] in Pa at points [P×3] outside the surface, at any distance from it.
    Eigen::MatrixXcd pressuresAt(double waveNumber,
                                 const Eigen::MatrixXd& pointsMetres,
                                 const Eigen::MatrixXd& normalVelocities,
                                 const Eigen::MatrixXcd& pressures) const;

    /// Approximates `farField` without solving, for waves much shorter than the surface. Each face
    /// visible from a direction acts as part of an infinite wall; hidden faces are silent.
    Eigen::MatrixXcd shortWaveField(double waveNumber,
                                    const Eigen::MatrixXd& directions,
                                    const Eigen::Vector3d& originMetres,
                                    const Eigen::MatrixXd& normalVelocities) const;

private:
    struct CharacterSystem;

    /// [D×F] jk/4π ∫ e^{jk d·y} dS over each face.
    Eigen::MatrixXcd planeWaves(double waveNumber,
                                const Eigen::MatrixXd& directions,
                                const Eigen::Vector3d& originMetres) const;
    /// [D×F] d·n.
    Eigen::MatrixXd cosines(const Eigen::MatrixXd& directions) const;
    /// [orbits] true where a field with this character is zero by symmetry.
    std::vector<bool> silentOrbits(const Eigen::RowVectorXcd& character) const;
    std::vector<CharacterSystem> systemsFor(const Eigen::MatrixXd& normalVelocities) const;
    Result<void> assemble(double waveNumber,
                          std::vector<CharacterSystem>& systems,
                          const WorkControl& control) const;

    Eigen::Index orbitCount() const { return static_cast<Eigen::Index>(orbits_.firsts.size()); }
    /// [orbits×G] the values of all faces, sorted by orbit and group element.
    Eigen::MatrixXd arranged(const Eigen::ArrayXd& values) const;

    SurfaceSymmetry symmetry_;
    SurfaceOrbits orbits_;
    SharedUnknowns unknowns_;
    BoundaryRows rows_; ///< one per collocation
    double largestCouplingMetres_ = 0;
};

} // namespace idiophone
