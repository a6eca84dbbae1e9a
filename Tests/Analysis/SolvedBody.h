// Solves bodies for their modes and finds modes by shape, for comparison with theory.
#pragma once

#include "Analysis/Eigensolver.h"
#include "Analysis/ElasticLaw.h"
#include "Mesh/Mesh.h"
#include "Object/Material.h"

#include <functional>
#include <vector>

namespace idiophone::test {

/// A body and its modes. Each point has three rows in the model's matrices.
struct SolvedBody {
    VibrationModel model;
    Eigen::MatrixXd points; ///< [n/3 × 3] in metres
    Modes modes;
};

using PointTest = std::function<bool(const Eigen::Vector3d& point)>;
using Field = std::function<Eigen::Vector3d(const Eigen::Vector3d& point)>;

/// Solves quadratic tetrahedra inside a closed surface and keeps its triangles. Points with
/// `clamped` true do not move.
SolvedBody solvedSolid(const Mesh& closedSurface,
                       const ElasticLaw& law,
                       double densityKgPerM3,
                       double targetEdgeMetres,
                       const FrequencyBand& band,
                       const PointTest& clamped = {});

SolvedBody solvedShell(const Mesh& mesh,
                       const Material& material,
                       double thicknessMetres,
                       const FrequencyBand& band,
                       const PointTest& clamped = {});

/// Ascending.
std::vector<double> frequenciesHz(const SolvedBody& body);

/// Returns the frequency of the mode most similar to a displacement field. The similarity (modal
/// assurance criterion with the mass as inner product) must be at least 0.8.
double frequencyLikeHz(const SolvedBody& body, const Field& field);

/// Returns the frequencies of modes with less than a tenth of their kinetic energy along z.
std::vector<double> inPlaneFrequenciesHz(const SolvedBody& body);

} // namespace idiophone::test
