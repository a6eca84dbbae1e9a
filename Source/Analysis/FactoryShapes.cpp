#include "Analysis/FactoryShapes.h"

#include "Analysis/FactoryBars.h"
#include "Analysis/ModalAnalysis.h"
#include "Analysis/SolidShell.h"
#include "Analysis/TubeTuning.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/SpreadVertices.h"
#include "Geometry/TurnedSections.h"

#include <chrono>
#include <string_view>

namespace idiophone {
namespace {

struct Sheet {
    std::string_view name, source, material;
    double thicknessMetres = 0;
    double maxFrequencyHz = 0;
    std::size_t shapeVertexCount = 0;
};

Result<ModalObject>
analysedSheet(const Mesh& mesh, const Sheet& sheet, const WorkControl& control) {
    return analyse(
        mesh,
        {.name = std::string(sheet.name),
         .source = std::string(sheet.source),
         .material = *findMaterial(sheet.material),
         .method = AnalysisMethod::twoLayer,
         .thicknessMetres = sheet.thicknessMetres,
         .maxFrequencyHz = sheet.maxFrequencyHz,
         .shapeVertices = spreadVertices(mesh, allVertices(mesh), sheet.shapeVertexCount),
         .radiation = RadiationMethod::exact},
        control);
}

struct Turned {
    std::string_view name, source, material;
    double edgeMetres = 0;
    double maxFrequencyHz = 0;
    std::size_t shapeVertexCount = 0; ///< on the outside
    std::vector<Eigen::Vector3d> listeningDirections = stereoDirections();
};

Result<ModalObject> analysedTurned(const std::vector<LathePoint>& section,
                                   const Turned& turned,
                                   const WorkControl& control) {
    const auto start = std::chrono::steady_clock::now();
    const LatheMesh lathe = latheMesh(section, turned.edgeMetres);
    auto object =
        solveBody(solidShell(lathe.mesh, lathe.thicknessMetres, *findMaterial(turned.material)),
                  {.name = std::string(turned.name),
                   .source = std::string(turned.source),
                   .maxFrequencyHz = turned.maxFrequencyHz,
                   .shapeVertices =
                       spreadVertices(lathe.mesh, allVertices(lathe.mesh), turned.shapeVertexCount),
                   .listeningDirections = turned.listeningDirections,
                   .radiation = RadiationMethod::exact},
                  control);
    if (object)
        object->provenance.analysisSeconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return object;
}

/// A sheet like a steel baking tray, struck all over.
Result<ModalObject> makePlate(const WorkControl& control) {
    return analysedSheet(sheetMesh(0.30, 0.20, 1900),
                         {.name = "plate",
                          .source = "generated steel plate, 300 x 200 x 3 mm",
                          .material = "Steel",
                          .thicknessMetres = 0.003,
                          // Above, a wavelength has fewer than eight edges.
                          .maxFrequencyHz = 22000,
                          .shapeVertexCount = 180},
                         control);
}

Result<ModalObject> makeTable(const WorkControl& control) {
    return analysedSheet(
        sheetMesh(0.9, 0.6, 1400),
        {.name = "table",
         .source = "generated wooden table top, 900 x 600 x 25 mm, a small table's",
         .material = "Wood",
         .thicknessMetres = 0.025,
         .maxFrequencyHz = 10000,
         .shapeVertexCount = 110},
        control);
}

/// A flat steel band bent to a hoop.
Result<ModalObject> makeRing(const WorkControl& control) {
    return analysedSheet(hoopMesh(0.07, 0.015, 132, 5),
                         {.name = "ring",
                          .source = "generated steel hoop, radius 70 mm, 15 x 4 mm",
                          .material = "Steel",
                          .thicknessMetres = 0.004,
                          .maxFrequencyHz = 44000,
                          .shapeVertexCount = 240},
                         control);
}

Result<ModalObject> makeHandbell(const WorkControl& control) {
    return analysedTurned(bellSection({.lipRadiusMetres = 0.06734,
                                       .heightMetres = 0.08744,
                                       .shoulderRadiusMetres = 0.04382,
                                       .shoulderCurveMetres = 0.01347,
                                       .lipThicknessMetres = 0.00271,
                                       .sideThicknessMetres = 0.00251,
                                       .crownThicknessMetres = 0.00342}),
                          {.name = "handbell",
                           .source = "generated bronze handbell C5, mouth 135 mm, wall 2.5 to 3.4 "
                                     "mm; a profile whose (3,0) is a twelfth above (2,0)",
                           .material = "Bell bronze",
                           .edgeMetres = 0.00744,
                           .maxFrequencyHz = 18000,
                           .shapeVertexCount = 120},
                          control);
}

Result<ModalObject> makeGlassBowl(const WorkControl& control) {
    return analysedTurned(
        bowlSection({.rimRadiusMetres = 0.083,
                     .heightMetres = 0.073,
                     .footRadiusMetres = 0.035,
                     .footThicknessMetres = 0.005,
                     .rimThicknessMetres = 0.004}),
        {.name = "glass-bowl",
         .source = "generated glass bowl, 170 x 75 mm as one of Duralex; wall of 4 to 5 mm assumed",
         .material = "Glass",
         .edgeMetres = 0.009,
         .maxFrequencyHz = 20000,
         .shapeVertexCount = 120},
        control);
}

Result<ModalObject> makeWok(const WorkControl& control) {
    return analysedTurned(
        capSection(0.178, 0.1, 0.002),
        {.name = "wok",
         .source = "generated steel wok, 14 inches wide, 14 gauge; depth of 100 mm assumed",
         .material = "Steel",
         .edgeMetres = 0.013,
         .maxFrequencyHz = 10000,
         .shapeVertexCount = 120},
        control);
}

Result<ModalObject> makeShellCase(const WorkControl& control) {
    return analysedTurned(caseSection({.baseRadiusMetres = 0.049,
                                       .mouthRadiusMetres = 0.045,
                                       .heightMetres = 0.292,
                                       .mouthHeightMetres = 0.028,
                                       .cornerMetres = 0.009,
                                       .baseThicknessMetres = 0.008,
                                       .wallThicknessMetres = 0.002,
                                       .mouthThicknessMetres = 0.0013}),
                          {.name = "shell-case",
                           .source = "generated brass case after the 25-pounder's, 88 x 292 mm, "
                                     "without its rim; wall of 1.3 to 2 mm assumed",
                           .material = "Brass",
                           .edgeMetres = 0.01,
                           .maxFrequencyHz = 10000,
                           .shapeVertexCount = 120,
                           .listeningDirections = directionsAllAround()},
                          control);
}

struct Shape {
    std::string_view name;
    Result<ModalObject> (*make)(const WorkControl&);
};
constexpr Shape shapes[] = {
    {"plate", makePlate},          {"ring", makeRing}, {"handbell", makeHandbell},
    {"glass-bowl", makeGlassBowl}, {"wok", makeWok},   {"table", makeTable},
    {"shell-case", makeShellCase}};

constexpr int lowestTubularBell = 60, highestTubularBell = 77; // MIDI, as written

std::string tubularBellName(int note) {
    return "tubular-bell-" + std::to_string(note);
}

Result<ModalObject> makeTubularBell(int note, const WorkControl& control) {
    return tuneTube({.name = tubularBellName(note),
                     .source = "generated brass tube, 38 x 1.5 mm as symphonic chimes; mode 4 an "
                               "octave above its note",
                     .noteFrequencyHz = noteFrequencyHz(note),
                     .material = *findMaterial("Brass")},
                    control)
        .map([](TunedTube tube) { return std::move(tube.object); });
}

} // namespace

std::vector<std::string> factoryShapeNames() {
    std::vector<std::string> names;
    for (const auto& shape : shapes)
        names.emplace_back(shape.name);
    for (int note = lowestTubularBell; note <= highestTubularBell; ++note)
        names.push_back(tubularBellName(note));
    return names;
}

Result<ModalObject> makeFactoryShape(const std::string& name, const WorkControl& control) {
    for (const auto& shape : shapes)
        if (shape.name == name)
            return shape.make(control);
    for (int note = lowestTubularBell; note <= highestTubularBell; ++note)
        if (tubularBellName(note) == name)
            return makeTubularBell(note, control);
    return failure("there is no factory object '" + name + "'");
}

} // namespace idiophone
