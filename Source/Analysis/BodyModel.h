// A body ready to be solved for its modes, whichever model it was made by, and the modal object
// that comes of it.
#pragma once

#include "Analysis/AnalysisControl.h"
#include "Analysis/Radiation.h"
#include "Analysis/VibrationModel.h"
#include "Geometry/Mesh.h"
#include "Object/ModalObject.h"

#include <string>
#include <vector>

namespace idiophone {

struct BodyModel {
    Mesh surface; ///< what is drawn, struck and radiates: N vertices, as repairMesh leaves it
    /// Either six rows a vertex of the surface (TwoLayerShell) or three a point, the surface's
    /// vertices first.
    VibrationModel model;
    Eigen::MatrixXd pointsMetres; ///< [P×3] where the model's points lie, three rows each
    BodyKind body = BodyKind::shell;
    double thicknessMetres = 0; ///< of a shell
    Material material;
    std::string method;
    /// The end of the band that its elements serve: that asked for, or less where a budget made
    /// them coarser than the shortest wavelength there wants.
    double servedBandHz = 44000;
    int components = 1; ///< that do not touch: each has six rigid motions
    std::string notes;  ///< what there is to say of how it was made
};

struct SolveSettings {
    std::string name;
    std::string source;
    double lowestFrequencyHz = 20;
    double maxFrequencyHz = 44000;
    int maximumModes = 5000;
    std::vector<int> shapeVertices = {}; ///< of the surface, ascending; empty: all
    std::vector<Eigen::Vector3d> listeningDirections = stereoDirections(); ///< of its radiation
};

/// Every mode of the body in the band, as an object that passes `validated`, with radiation and
/// mass. Errors are one sentence: those of solveModes, no mode in the band, `cancelledMessage`.
Result<ModalObject> solveBody(const BodyModel& body,
                              const SolveSettings& settings,
                              const AnalysisControl& control = {});

/// [3N×M] the displacement of the surface for shapes of the model.
Eigen::MatrixXd surfaceShapes(const BodyModel& body, const Eigen::MatrixXd& shapes);

} // namespace idiophone
