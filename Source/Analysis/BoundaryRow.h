// One equation of BoundaryElements: what every triangle adds to it at one collocation point.
// Internal to Analysis.
#pragma once

#include "Geometry/Mesh.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace idiophone {

/// A triangle as a source of sound and as a place to collocate at.
struct BoundaryPanel {
    Eigen::Matrix3d corners; ///< columns, counter-clockwise seen from outside
    Eigen::Vector3d centroid, normal;
    double areaM2 = 0, longestEdgeMetres = 0;
};
std::vector<BoundaryPanel> boundaryPanels(const Mesh& mesh);

/// The coefficients of an equation, real and imaginary parts apart. K, S, K' and N are those of
/// `BoundaryElements`.
struct BoundaryRow {
    Eigen::ArrayXd pressureReal, pressureImaginary; ///< [F] of p: −K − β N
    Eigen::ArrayXd slopeReal, slopeImaginary;       ///< [F] of q = ∂p/∂n: −S − β K'
};

/// Makes rows at the centroids of some of the panels. Keeps what does not depend on the frequency.
/// Immutable once built.
class BoundaryRows {
public:
    /// `targets` are the panels at which there will be equations.
    BoundaryRows(std::vector<BoundaryPanel> panels, std::vector<int> targets);

    const std::vector<BoundaryPanel>& panels() const { return panels_; }

    /// The row of `targets[target]` for the wave number k in rad/m and β = −j·coupling, without the
    /// terms p/2 and βq/2.
    void fill(std::size_t target, double waveNumber, double couplingMetres, BoundaryRow& row) const;

    /// That of a point on no panel, with β = 0.
    void fillAt(const Eigen::Vector3d& pointMetres, double waveNumber, BoundaryRow& row) const;

private:
    struct Point {
        Eigen::Vector3d place, normal;
        double weight = 0; ///< of the rule, times the area
    };

    /// The closed forms of a triangle near a collocation point: the static integrals, and what does
    /// not vanish as r → 0 of the next terms of K and N in powers of k.
    struct NearPair {
        double singleLayer = 0, doubleLayer = 0, adjoint = 0, hypersingular = 0;
        double doubleLayerOfK2 = 0, hypersingularOfK2 = 0; ///< times k²
    };

    /// What is not far from a collocation point.
    struct Surroundings {
        std::vector<int> near;       ///< panels with closed forms
        std::vector<NearPair> pairs; ///< theirs
        std::vector<int> middle;     ///< panels that need three points at any frequency
    };

    struct Equation;

    static NearPair nearPair(const BoundaryPanel& target, const BoundaryPanel& source);
    Surroundings surroundingsOf(const BoundaryPanel& target) const;
    void fill(const Equation& equation, const Surroundings& around, BoundaryRow& row) const;

    /// Adds the sources' kernels by quadrature; `points` holds as many of each panel as the other.
    /// With `isRemainder` without what the closed forms of a NearPair contain.
    template <bool isRemainder>
    void add(const Equation& equation,
             std::span<const int> sources,
             std::span<const Point> points,
             BoundaryRow& row) const;

    std::vector<BoundaryPanel> panels_;
    std::vector<int> targets_;
    std::vector<int> all_; ///< every panel
    std::vector<Point> onePoint_, threePoints_, sixPoints_;
    std::vector<Surroundings> surroundings_; ///< of each target
    double longestEdgeMetres_ = 0;
};

} // namespace idiophone
