#include "Analysis/SharedUnknowns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace idiophone {
namespace {

using Eigen::Index;

/// [panels×6] where each lies, and its normal, so long that faces of an edge or the two sides of a
/// sheet are further apart than neighbours of one cluster.
Eigen::MatrixXd placesAndNormals(const std::vector<BoundaryPanel>& panels,
                                 const std::vector<int>& chosen,
                                 Index clusters) {
    double areaM2 = 0;
    for (const int panel : chosen)
        areaM2 += panels[static_cast<std::size_t>(panel)].areaM2;
    const double normalMetres = 2 * std::sqrt(areaM2 / static_cast<double>(clusters));
    Eigen::MatrixXd places(static_cast<Index>(chosen.size()), 6);
    for (std::size_t row = 0; row < chosen.size(); ++row) {
        const auto& panel = panels[static_cast<std::size_t>(chosen[row])];
        places.row(static_cast<Index>(row)) << panel.centroid.transpose(),
            normalMetres * panel.normal.transpose();
    }
    return places;
}

/// Which of them are one cluster, around centres that lie as far apart as can be, each the point
/// that is furthest from those before.
std::vector<int> clustersOf(const Eigen::MatrixXd& places, Index clusters) {
    std::vector<int> owners(static_cast<std::size_t>(places.rows()), 0);
    Eigen::VectorXd distances =
        Eigen::VectorXd::Constant(places.rows(), std::numeric_limits<double>::infinity());
    Index centre = 0;
    for (Index cluster = 0; cluster < clusters; ++cluster) {
        const Eigen::VectorXd toCentre =
            (places.rowwise() - places.row(centre)).rowwise().squaredNorm();
        for (Index row = 0; row < places.rows(); ++row)
            if (toCentre(row) < distances(row)) {
                distances(row) = toCentre(row);
                owners[static_cast<std::size_t>(row)] = static_cast<int>(cluster);
            }
        distances.maxCoeff(&centre);
    }
    return owners;
}

} // namespace

std::vector<int> sharedUnknowns(const std::vector<BoundaryPanel>& panels,
                                const SurfaceOrbits& orbits,
                                Index maximumUnknowns) {
    if (static_cast<Index>(orbits.firsts.size()) > maximumUnknowns)
        return clustersOf(placesAndNormals(panels, orbits.firsts, maximumUnknowns),
                          maximumUnknowns);
    std::vector<int> all(orbits.firsts.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

} // namespace idiophone
