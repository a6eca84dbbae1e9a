#include "Analysis/SharedUnknowns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace idiophone {
namespace {

using Eigen::Index;

/// [panels×6] centroids and scaled normals. The scale puts the faces at a sharp edge, and the two
/// sides of a sheet, farther apart than neighbours in one cluster.
Eigen::MatrixXd placesAndNormals(const std::vector<BoundaryPanel>& panels,
                                 const std::vector<int>& chosen,
                                 Index clusters) {
    double areaM2 = 0;
    for (const int panel : chosen)
        areaM2 += panels[panel].areaM2;
    const double normalMetres = 2 * std::sqrt(areaM2 / static_cast<double>(clusters));
    Eigen::MatrixXd places(chosen.size(), 6);
    for (std::size_t row = 0; row < chosen.size(); ++row) {
        const auto& panel = panels[chosen[row]];
        places.row(row) << panel.centroid.transpose(), normalMetres * panel.normal.transpose();
    }
    return places;
}

/// Returns the cluster of each panel. Each new centre is the point farthest from the earlier ones.
std::vector<int> clustersOf(const Eigen::MatrixXd& places, Index clusters) {
    std::vector<int> owners(places.rows(), 0);
    Eigen::VectorXd distances =
        Eigen::VectorXd::Constant(places.rows(), std::numeric_limits<double>::infinity());
    Index centre = 0;
    for (Index cluster = 0; cluster < clusters; ++cluster) {
        const Eigen::VectorXd toCentre =
            (places.rowwise() - places.row(centre)).rowwise().squaredNorm();
        for (Index row = 0; row < places.rows(); ++row)
            if (toCentre(row) < distances(row)) {
                distances(row) = toCentre(row);
                owners[row] = static_cast<int>(cluster);
            }
        distances.maxCoeff(&centre);
    }
    return owners;
}

/// Returns a few members of each cluster at even steps, weighted by area. It prefers orbits that no
/// symmetry fixes.
std::vector<Collocation> collocationsOf(const std::vector<BoundaryPanel>& panels,
                                        const SurfaceOrbits& orbits,
                                        const std::vector<int>& owners,
                                        Index clusters) {
    std::vector<std::vector<int>> free(clusters), fixed = free;
    for (int orbit = 0; orbit < std::ssize(owners); ++orbit)
        (orbits.areFixed[orbit] ? fixed : free)[owners[orbit]].push_back(orbit);
    std::vector<Collocation> result;
    for (std::size_t cluster = 0; cluster < free.size(); ++cluster) {
        const auto& members = free[cluster].empty() ? fixed[cluster] : free[cluster];
        const std::size_t first = result.size(),
                          count = std::min<std::size_t>(members.size(), maximumCollocations);
        double area = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const int orbit = members[(2 * k + 1) * members.size() / (2 * count)];
            const int face = orbits.firsts[orbit];
            result.push_back({orbit, panels[face].areaM2});
            area += result.back().share;
        }
        for (std::size_t k = first; k < result.size(); ++k)
            result[k].share /= area;
    }
    return result;
}

} // namespace

SharedUnknowns sharedUnknowns(const std::vector<BoundaryPanel>& panels,
                              const SurfaceOrbits& orbits,
                              Index maximumUnknowns) {
    const auto orbitCount = static_cast<Index>(orbits.firsts.size());
    SharedUnknowns result{
        .ofOrbits = {}, .count = std::min(orbitCount, maximumUnknowns), .collocations = {}};
    if (orbitCount > maximumUnknowns) {
        result.ofOrbits =
            clustersOf(placesAndNormals(panels, orbits.firsts, maximumUnknowns), maximumUnknowns);
    } else {
        result.ofOrbits.resize(orbits.firsts.size());
        std::iota(result.ofOrbits.begin(), result.ofOrbits.end(), 0);
    }
    result.collocations = collocationsOf(panels, orbits, result.ofOrbits, result.count);
    return result;
}

} // namespace idiophone
