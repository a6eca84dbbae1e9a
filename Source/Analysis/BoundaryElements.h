// Sound outside a closed surface that vibrates, by boundary elements: the pressure on the surface
// from its velocity, and what reaches a listener far away.
#pragma once

#include "Analysis/BoundaryRow.h"
#include "Analysis/SharedUnknowns.h"
#include "Analysis/SurfaceSymmetry.h"
#include "Geometry/Mesh.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace idiophone {

/// Time runs as e^{+jωt}. One unknown a triangle, collocated at its centroid, after Burton & Miller
/// 1971 (Proc. R. Soc. A 323): the Helmholtz integral equation plus β times its normal derivative,
/// so that no resonance of the space inside disturbs it.
///
///     p/2 − K p − β N p = −S q − β (q/2 + K' q),   q = ∂p/∂n = −jωρ v_n,   β = −j min(1/k, h)
///
/// S, K, K' and N are the single layer, the double layer, its adjoint and the hypersingular
/// operator of e^{−jkr}/(4πr); h is the mean edge of its triangles. Of near triangles the parts
/// that grow as r → 0 are integrated in closed form (PanelPotentials), the rest by Gauss' rules: so
/// the two faces of a sheet may be much closer than its triangles are wide.
///
/// With a symmetry of G elements a system of F/G unknowns is solved for each character that the
/// velocity has a part of, in place of one of F. Any velocity may be given.
///
/// Immutable once built; any number of threads may use one at once.
class BoundaryElements {
public:
    /// `surface` is closed and oriented outward, F faces, none degenerate, and `symmetry` its own.
    /// With more orbits than `maximumUnknowns` neighbouring triangles of like normals share an
    /// unknown (SharedUnknowns): the velocity keeps its detail, the pressure does
    /// not.
    BoundaryElements(const Mesh& surface,
                     SurfaceSymmetry symmetry,
                     Eigen::Index maximumUnknowns = std::numeric_limits<Eigen::Index>::max());

    Eigen::Index faceCount() const { return static_cast<Eigen::Index>(rows_.panels().size()); }
    /// Of the system of each character.
    Eigen::Index unknownCount() const { return unknowns_.count; }
    Eigen::Index symmetryOrder() const { return symmetry_.order(); }

    /// Pressures [F×M] in Pa for outward velocities [F×M] in m/s at the wave number k > 0 in rad/m.
    /// Error: `cancelledMessage`.
    Result<Eigen::MatrixXcd> surfacePressures(double waveNumber,
                                              const Eigen::MatrixXd& normalVelocities,
                                              const WorkControl& control = {}) const;

    /// [D×M] in Pa·m: W with p = W e^{−jkR}/R at a distance R, far away, from `originMetres`
    /// towards each of the unit `directions` [D×3],
    ///
    ///     W = 1/4π ∫ [jωρ v_n + jk (d·n) p] e^{jk d·y} dS.
    Eigen::MatrixXcd farField(double waveNumber,
                              const Eigen::MatrixXd& directions,
                              const Eigen::Vector3d& originMetres,
                              const Eigen::MatrixXd& normalVelocities,
                              const Eigen::MatrixXcd& pressures) const;

    /// [P×M] in Pa at points [P×3] outside of the surface, as near to it as need be.
    Eigen::MatrixXcd pressuresAt(double waveNumber,
                                 const Eigen::MatrixXd& pointsMetres,
                                 const Eigen::MatrixXd& normalVelocities,
                                 const Eigen::MatrixXcd& pressures) const;

    /// ρc, in Pa s/m.
    static double impedance();

    /// The same as `farField` where waves are short against the surface, without solving: every
    /// face that is visible from there is a part of an infinite wall, and the others are not heard.
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
    /// [orbits] of which faces nothing lives that turns by this character.
    std::vector<bool> silentOrbits(const Eigen::RowVectorXcd& character) const;
    std::vector<CharacterSystem> systemsFor(const Eigen::MatrixXd& normalVelocities,
                                            double waveNumber) const;
    Result<void> assemble(double waveNumber,
                          std::vector<CharacterSystem>& systems,
                          const WorkControl& control) const;

    Eigen::Index orbitCount() const { return static_cast<Eigen::Index>(orbits_.firsts.size()); }
    /// [orbits×G] the values of all faces.
    Eigen::MatrixXd arranged(const Eigen::ArrayXd& values) const;

    SurfaceSymmetry symmetry_;
    SurfaceOrbits orbits_;
    SharedUnknowns unknowns_;
    BoundaryRows rows_; ///< one for each collocation
    double largestCouplingMetres_ = 0;
};

} // namespace idiophone
