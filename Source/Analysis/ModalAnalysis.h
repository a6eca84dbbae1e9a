// Analyses a mesh with a material into a modal object: repair, model, modes. Also serves meshes
// dropped on the window.
#pragma once

#include "Analysis/AnalysedBand.h"
#include "Analysis/AnalysisMethod.h"
#include "Analysis/Clamp.h"
#include "Analysis/Radiation.h"
#include "Mesh/Mesh.h"
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
    double thicknessMetres = 0.005;            ///< shells only
    double lowestFrequencyHz = lowestAnalysedHz;
    double maxFrequencyHz = highestAnalysedHz;
    int maximumModes = maximumAnalysedModes; ///< more modes in the band are an error
    int elementBudget = 8000; ///< approximate number of tetrahedra; a wider band makes them coarser
    bool largestComponentOnly = false;   ///< leave smaller components of the mesh out
    Support support = {};                ///< what holds the body, if anything does
    std::vector<int> shapeVertices = {}; ///< input vertices that keep their shapes; empty: all
    /// Directions to the listener; `directionsAllAround` for bodies that turn in scenes. Empty: no
    /// radiation is computed.
    std::vector<Eigen::Vector3d> listeningDirections = stereoDirections();
    RadiationMethod radiation = RadiationMethod::quick;
    unsigned threads = 0; ///< maximum, with the same result for any; 0: as many as pay
};

/// Error, one sentence: a setting or a constant of the material is out of range.
Result<void> validate(const AnalysisSettings& settings);

/// Larger shells (after repair) are remeshed. The published springs need every original vertex, so
/// larger meshes are an error; they would take minutes to hours.
inline constexpr int shellVertexLimit = 20000;
inline constexpr int springMassVertexLimit = 40000;

/// Returns the modal object of the repaired mesh with every mode in the band; it passes
/// `validated`. Finite elements, and shells chosen automatically, may remesh the surface and end
/// the band below the requested maximum (`bandHz`, and a note). After a remeshing, the vertices
/// nearest to `shapeVertices` carry the shapes.
///
/// `provenance.notes` says what repair did, which method was chosen and why, and any warnings, such
/// as more than six rigid zero modes. The same input gives the same object except for the elapsed
/// time. Errors, each one sentence: settings out of range, an unusable or too large mesh, no mode
/// in the band, too many modes, or `cancelledMessage`.
Result<ModalObject>
analyse(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control = {});

/// Analyses into a first object within a second or two, which plays until `analyse` is done. Its
/// pitches are some per cent off. Decimates the mesh to `previewVertices` and uses few elements.
/// Meshes of 20,000 triangles take less than 2 s (docs/decisions/0023). Shells always use the
/// two-layer method. The band goes beyond what the elements resolve, up to the requested maximum or
/// some 350 modes: these upper modes are too high by several per cent. Every vertex carries shapes.
///
/// It reads name, source, material, method, thickness, `largestComponentOnly`, the support and the
/// band from the settings. Errors: those of `analyse`, and a mesh that cannot be decimated. Any
/// thread but the audio thread may call it.
Result<ModalObject>
analysePreview(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control = {});

inline constexpr int previewVertices = 400;

} // namespace idiophone
