// One equation of BoundaryElements: the coefficients of all triangles at one collocation point.
// Internal to Analysis.
#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace idiophone {

/// A triangle as a source and as a collocation point.
struct BoundaryPanel {
    Eigen::Matrix3d corners; ///< columns, counter-clockwise seen from outside
    Eigen::Vector3d centroid, normal;
    double areaM2 = 0, longestEdgeMetres = 0;
};
std::vector<BoundaryPanel> boundaryPanels(const Mesh& mesh);

/// The coefficients of one equation, with separate real and imaginary parts. `BoundaryElements`
/// defines K, S, K' and N.
struct BoundaryRow {
    Eigen::ArrayXd pressureReal, pressureImaginary; ///< [F] of p: −K − β N
    Eigen::ArrayXd slopeReal, slopeImaginary;       ///< [F] of q = ∂p/∂n: −S − β K'
};

/// Makes rows at the centroids of selected panels. Precomputes the frequency-independent parts.
/// Immutable once built.
class BoundaryRows {
public:
    /// `targets` are the panels that get equations.
    BoundaryRows(std::vector<BoundaryPanel> panels, std::vector<int> targets);

    const std::vector<BoundaryPanel>& panels() const { return panels_; }

    /// Fills the row of `targets[target]` for the wave number k in rad/m and β = −j·coupling,
    /// without the terms p/2 and βq/2.
    void fill(std::size_t target, double waveNumber, double couplingMetres, BoundaryRow& row) const;

    /// Fills the row of a point on no panel, with β = 0.
    void fillAt(const Eigen::Vector3d& pointMetres, double waveNumber, BoundaryRow& row) const;

private:
    struct Point {
        Eigen::Vector3d place, normal;
        double weight = 0; ///< of the rule, times the panel's area
    };

    /// Closed forms for a triangle near a collocation point. They hold the static integrals, and
    /// the next terms of K and N in powers of k that do not vanish for r → 0.
    struct NearPair {
        double singleLayer = 0, doubleLayer = 0, adjoint = 0, hypersingular = 0;
        double doubleLayerOfK2 = 0, hypersingularOfK2 = 0; ///< times k²
    };

    /// The panels that are near a collocation point.
    struct Surroundings {
        std::vector<int> near;       ///< panels with closed forms
        std::vector<NearPair> pairs; ///< closed forms of `near`
        std::vector<int> middle;     ///< panels that need at least three points at any frequency
    };

    struct Equation;

    static NearPair nearPair(const BoundaryPanel& target, const BoundaryPanel& source);
    Surroundings surroundingsOf(const BoundaryPanel& target) const;
    void fill(const Equation& equation, const Surroundings& around, BoundaryRow& row) const;

    /// Adds the sources' kernels by quadrature. `points` holds the same number of points for each
    /// panel. With `isRemainder`, leaves out the terms that a NearPair has in closed form.
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
