// A body with its stiffness and mass matrices, from any of the models, and its solution as a modal
// object.
#pragma once

#include "Analysis/AnalysedBand.h"
#include "Analysis/Clamp.h"
#include "Analysis/HeldSurface.h"
#include "Analysis/Radiation.h"
#include "Analysis/VibrationModel.h"
#include "Mesh/Mesh.h"
#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace idiophone {

enum class ModelKind {
    points,   ///< three rows per point, the surface's vertices first
    twoLayers ///< six rows per vertex of the surface, see TwoLayerShell
};

struct BodyModel {
    Mesh surface; ///< N vertices for display, strikes and radiation, as repairMesh leaves them
    VibrationModel model;
    ModelKind kind = ModelKind::points;
    Eigen::MatrixXd pointsMetres; ///< [P×3] positions of the model's points
    BodyKind body = BodyKind::shell;
    double thicknessMetres = 0; ///< shells only
    Material material;
    std::string method;
    /// The upper end of the band that the elements resolve. It is below the requested band if a
    /// budget made the elements coarser than the shortest wavelength needs.
    double servedBandHz = highestAnalysedHz;
    int components = 1; ///< separate parts; each has six rigid motions
    Support support;
    /// The support's faces and vertices of the mesh that was analysed; null: none.
    std::shared_ptr<const HeldSurface> heldSurface = nullptr;
    std::string notes; ///< remarks for the user about how the model was made
};

/// Joins the sentences that are not empty.
std::string joinedSentences(std::initializer_list<std::string> sentences);

struct SolveSettings {
    std::string name;
    std::string source;
    double lowestFrequencyHz = lowestAnalysedHz;
    double maxFrequencyHz = highestAnalysedHz;
    int maximumModes = maximumAnalysedModes;
    std::vector<int> shapeVertices = {}; ///< vertices of the surface, ascending; empty: all
    std::vector<Eigen::Vector3d> listeningDirections = stereoDirections(); ///< for the radiation
    RadiationMethod radiation = RadiationMethod::quick;
    /// [P] points outside the body at which to compute pressures, as for
    /// `Radiation::nearPressures`.
    std::vector<Eigen::Vector3d> nearPointsMetres = {};
    unsigned threads = 0; ///< maximum, with the same result for any; 0: as many as pay
};

/// Returns an object with every mode of the body in the band, its radiation and its mass. The
/// object passes `validated`. Errors, each one sentence: those of solveModes and radiationOf, no
/// mode in the band, `cancelledMessage`. `nearPressures`, if given, receives the pressures at the
/// near points [P×M].
Result<ModalObject> solveBody(const BodyModel& body,
                              const SolveSettings& settings,
                              const WorkControl& control = {},
                              Eigen::MatrixXcd* nearPressures = nullptr);

} // namespace idiophone
