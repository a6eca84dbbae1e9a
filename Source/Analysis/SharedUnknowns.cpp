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

/// Of each cluster the member nearest to the mean of all, one that is not fixed if there is any.
std::vector<int> middlesOf(const Eigen::MatrixXd& places,
                           const std::vector<int>& owners,
                           const std::vector<bool>& areFixed) {
    const Index clusters = 1 + *std::ranges::max_element(owners);
    Eigen::MatrixXd means = Eigen::MatrixXd::Zero(clusters, places.cols());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(clusters);
    for (std::size_t row = 0; row < owners.size(); ++row) {
        means.row(owners[row]) += places.row(static_cast<Index>(row));
        counts(owners[row]) += 1;
    }
    means = counts.cwiseInverse().asDiagonal() * means;
    std::vector<int> middles(static_cast<std::size_t>(clusters), -1);
    Eigen::VectorXd distances =
        Eigen::VectorXd::Constant(clusters, std::numeric_limits<double>::infinity());
    for (std::size_t row = 0; row < owners.size(); ++row) {
        const int owner = owners[row];
        constexpr double farther = 1e6;
        const double distance =
            (places.row(static_cast<Index>(row)) - means.row(owner)).squaredNorm() *
            (areFixed[row] ? farther : 1);
        if (distance < distances(owner)) {
            distances(owner) = distance;
            middles[static_cast<std::size_t>(owner)] = static_cast<int>(row);
        }
    }
    return middles;
}

} // namespace

SharedUnknowns sharedUnknowns(const std::vector<BoundaryPanel>& panels,
                              const SurfaceOrbits& orbits,
                              Index maximumUnknowns) {
    const auto count = static_cast<Index>(orbits.firsts.size());
    if (count <= maximumUnknowns) {
        std::vector<int> all(orbits.firsts.size());
        std::iota(all.begin(), all.end(), 0);
        return {all, all};
    }
    const auto places = placesAndNormals(panels, orbits.firsts, maximumUnknowns);
    auto owners = clustersOf(places, maximumUnknowns);
    auto targets = middlesOf(places, owners, orbits.areFixed);
    return {std::move(owners), std::move(targets)};
}

} // namespace idiophone
