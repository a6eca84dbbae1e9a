#include "Analysis/PreviewAnalysis.h"

#include "Analysis/BodyModel.h"
#include "Analysis/ElasticLaw.h"
#include "Analysis/MethodChoice.h"
#include "Analysis/ShellBody.h"
#include "Analysis/SolidBody.h"
#include "Geometry/Decimation.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/MeshRepair.h"

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <utility>

namespace idiophone {
namespace {

// Measured: repair and decimation of 20,000 triangles take half of the time, these elements the
// other half.
constexpr int elementBudget = 300, shellVertexBudget = 300;

Result<Mesh>
lightened(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    auto repaired = repairMesh(mesh, {.weldTolerance = settings.weldTolerance,
                                      .largestComponentOnly = settings.largestComponentOnly,
                                      .cancelled = control.cancelled});
    if (!repaired)
        return tl::unexpected(repaired.error());
    if (repaired->mesh.vertexCount() <= previewVertices)
        return std::move(repaired->mesh);
    return decimate(repaired->mesh, previewVertices, control.quiet());
}

Result<BodyModel>
coarseShell(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    auto shell = shellBody(mesh,
                           {.material = settings.material,
                            .thicknessMetres = settings.thicknessMetres,
                            .maxFrequencyHz = settings.maxFrequencyHz,
                            .vertexBudget = shellVertexBudget,
                            .fitsMesh = true},
                           control);
    if (shell)
        shell->method = methodName(AnalysisMethod::twoLayer);
    return shell;
}

Result<BodyModel>
coarseSolid(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    auto solid = solidBody(mesh,
                           {.material = settings.material,
                            .law = elasticLaw(settings.material, grainAlong(mesh)),
                            .maxFrequencyHz = settings.maxFrequencyHz,
                            .elementBudget = elementBudget},
                           control);
    if (solid)
        solid->method = methodName(AnalysisMethod::tetrahedra);
    return solid;
}

Result<BodyModel>
coarseBody(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    const auto method =
        settings.method
            ? *settings.method
            : chooseMethod(checkMesh(mesh, control.cancelled), settings.thicknessMetres).method;
    if (method != AnalysisMethod::tetrahedra)
        return coarseShell(mesh, settings, control);
    auto solid = coarseSolid(mesh, settings, control);
    if (solid || settings.method || control.isCancelled())
        return solid;
    return coarseShell(mesh, settings, control);
}

/// Stiff bodies such as a hollow ball may have no mode below the resolved band. The band then
/// extends: a mode that is some per cent off is better than none.
Result<ModalObject>
solved(const BodyModel& coarse, const AnalysisSettings& settings, const WorkControl& control) {
    constexpr double least = 100;
    for (double highestHz = std::max(coarse.servedBandHz, least);; highestHz *= 4) {
        const double bandHz = std::min(highestHz, settings.maxFrequencyHz);
        auto object = solveBody(coarse,
                                {.name = settings.name,
                                 .source = settings.source,
                                 .lowestFrequencyHz = settings.lowestFrequencyHz,
                                 .maxFrequencyHz = bandHz,
                                 .maximumModes = settings.maximumModes},
                                control);
        if (object || control.isCancelled() || bandHz >= settings.maxFrequencyHz)
            return object;
    }
}

} // namespace

Result<ModalObject>
analysePreview(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    try {
        if (const auto usable = validate(settings); !usable)
            return tl::unexpected(usable.error());
        control.report(0, "Simplifying the mesh");
        const auto light = lightened(mesh, settings, control);
        if (!light)
            return tl::unexpected(light.error());
        const auto coarse = coarseBody(*light, settings, control);
        if (!coarse)
            return tl::unexpected(coarse.error());
        auto object = solved(*coarse, settings, control);
        if (object)
            object->provenance.notes = "A preview of few elements.";
        return object;
    } catch (const std::bad_alloc&) {
        return failure("The preview needs more memory than this machine has.");
    } catch (const std::exception& fault) {
        return failure(std::string("The preview failed: ") + fault.what() + ".");
    }
}

} // namespace idiophone
