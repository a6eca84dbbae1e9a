// A body ready to be solved for its modes, whichever model it was made by, and the modal object
// that comes of it.
#pragma once

#include "Analysis/AnalysedBand.h"
#include "Analysis/Radiation.h"
#include "Analysis/VibrationModel.h"
#include "Geometry/Mesh.h"
#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <string>
#include <vector>

namespace idiophone {

enum class ModelKind {
    points,   ///< three rows a point, the surface's vertices first
    twoLayers ///< six rows a vertex of the surface: see TwoLayerShell
};

struct BodyModel {
    Mesh surface; ///< what is drawn, struck and radiates: N vertices, as repairMesh leaves it
    VibrationModel model;
    ModelKind kind = ModelKind::points;
    Eigen::MatrixXd pointsMetres; ///< [P×3] where the model's points lie, three rows each
    BodyKind body = BodyKind::shell;
    double thicknessMetres = 0; ///< of a shell
    Material material;
    std::string method;
    /// The end of the band that its elements serve: that asked for, or less where a budget made
    /// them coarser than the shortest wavelength there wants.
    double servedBandHz = highestAnalysedHz;
    int components = 1; ///< that do not touch: each has six rigid motions
    std::string notes;  ///< what there is to say of how it was made
};

struct SolveSettings {
    std::string name;
    std::string source;
    double lowestFrequencyHz = lowestAnalysedHz;
    double maxFrequencyHz = highestAnalysedHz;
    int maximumModes = mostAnalysedModes;
    std::vector<int> shapeVertices = {}; ///< of the surface, ascending; empty: all
    std::vector<Eigen::Vector3d> listeningDirections = stereoDirections(); ///< of its radiation
    RadiationMethod radiation = RadiationMethod::quick;
    /// [P] outside, where pressures are wanted too, as `Radiation::nearPressures`.
    std::vector<Eigen::Vector3d> nearPointsMetres = {};
};

/// Every mode of the body in the band, as an object that passes `validated`, with radiation and
/// mass. Errors are one sentence: those of solveModes and radiationOf, no mode in the band,
/// `cancelledMessage`. `nearPressures`, where given, receives those at the near points [P×M].
Result<ModalObject> solveBody(const BodyModel& body,
                              const SolveSettings& settings,
                              const WorkControl& control = {},
                              Eigen::MatrixXcd* nearPressures = nullptr);

} // namespace idiophone
