// From a mesh and a material to a modal object: repair, model, modes. What a musician drops on the
// window goes through here.
#pragma once

#include "Analysis/AnalysedBand.h"
#include "Analysis/AnalysisMethod.h"
#include "Analysis/Radiation.h"
#include "Geometry/Mesh.h"
#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <optional>
#include <vector>

namespace idiophone {

struct AnalysisSettings {
    std::string name;
    std::string source; ///< mesh file or generator, for the object's provenance
    Material material;
    std::optional<AnalysisMethod> method = {}; ///< empty: the one that suits the mesh
    double thicknessMetres = 0.005;            ///< of a shell
    double lowestFrequencyHz = lowestAnalysedHz;
    double maxFrequencyHz = highestAnalysedHz;
    int maximumModes = mostAnalysedModes; ///< an object with more in the band is refused
    int elementBudget = 8000;             ///< tetrahedra, about; for a wider band they are coarser
    bool largestComponentOnly = false;    ///< leave smaller components of the mesh out
    double weldTolerance = 1e-7;          ///< see RepairSettings
    std::vector<int> shapeVertices = {};  ///< input vertices whose shapes to keep; empty: all
    /// From where it can be heard; `directionsAllAround` for what turns in scenes.
    std::vector<Eigen::Vector3d> listeningDirections = stereoDirections();
    RadiationMethod radiation = RadiationMethod::quick;
};

/// Fails with a sentence where a setting, or a figure of the material, is out of range.
Result<void> validate(const AnalysisSettings& settings);

/// Shells of more vertices (after repair) are remeshed; the paper's springs, which want every
/// vertex as it is, are refused: they would take minutes to hours.
inline constexpr int shellVertexLimit = 20000;
inline constexpr int springMassVertexLimit = 40000;

/// The modal object of the repaired mesh, holding every mode in the band; it passes `validated`.
/// Finite elements, and shells that were not asked for by name, may remesh the surface, whose
/// vertices nearest to the `shapeVertices` then carry the shapes, and end the band below what was
/// asked for (`bandHz`, and a note). `provenance.notes`
/// says in plain words what repair did, which method was chosen and why, and what to beware of
/// (more than the six rigid zero modes, for one). The same input gives the same object, but for the
/// time it took. Errors are one sentence: settings out of range, an unusable or too large mesh, no
/// mode in the band, too many modes, or `cancelledMessage`.
Result<ModalObject>
analyse(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control = {});

} // namespace idiophone
