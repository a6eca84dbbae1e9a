// Bodies solved for their modes, and modes found by their shape: for comparing with theory.
#pragma once

#include "Analysis/Eigensolver.h"
#include "Analysis/ElasticLaw.h"
#include "Geometry/Mesh.h"
#include "Object/Material.h"

#include <functional>
#include <vector>

namespace idiophone::test {

/// Three rows of the model's matrices at each point.
struct SolvedBody {
    VibrationModel model;
    Eigen::MatrixXd points; ///< [n/3 × 3] in metres
    Modes modes;
};

using PointTest = std::function<bool(const Eigen::Vector3d& point)>;
using Field = std::function<Eigen::Vector3d(const Eigen::Vector3d& point)>;

/// Quadratic tetrahedra within a closed surface whose triangles are kept. Points for which
/// `clamped` holds do not move.
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

/// All frequencies in the band, ascending.
std::vector<double> frequenciesHz(const SolvedBody& body);

/// The frequency of the mode that is most like a displacement field. The likeness, the modal
/// assurance criterion with the mass as its product, must be 0.8 or more.
double frequencyLikeHz(const SolvedBody& body, const Field& field);

/// The frequencies of the modes with less than a tenth of their kinetic energy along z.
std::vector<double> inPlaneFrequenciesHz(const SolvedBody& body);

} // namespace idiophone::test
