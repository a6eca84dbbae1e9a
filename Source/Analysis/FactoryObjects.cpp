#include "Analysis/FactoryObjects.h"

#include "Analysis/FactoryBars.h"
#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"

namespace idiophone {
namespace {

Material steel() {
    Material material = *findMaterial("Steel");
    material.poissonRatio = 1.0 / 3; // what the springs make of it
    return material;
}

/// A steel baking tray's worth of sheet, struck all over: `zones`.
Result<ModalObject> makePlate(const AnalysisControl& control) {
    constexpr double lengthMetres = 0.30, widthMetres = 0.20;
    const auto mesh = sheetMesh(lengthMetres, widthMetres, 1900);
    return analyse(mesh,
                   {.name = "plate",
                    .source = "generated steel plate, 300 x 200 x 3 mm",
                    .material = steel(),
                    .method = AnalysisMethod::twoLayer,
                    .thicknessMetres = 0.003,
                    // Beyond, a wavelength has fewer than eight edges.
                    .maxFrequencyHz = 22000,
                    .shapeVertices = evenSheetVertices(mesh, lengthMetres, widthMetres, 300)},
                   control);
}

/// A flat steel band bent to a hoop, resized for each key: `scaled`.
Result<ModalObject> makeRing(const AnalysisControl& control) {
    constexpr int around = 132, rows = 5;
    const auto mesh = hoopMesh(0.07, 0.015, around, rows);
    return analyse(mesh,
                   {.name = "ring",
                    .source = "generated steel hoop, radius 70 mm, 15 x 4 mm",
                    .material = steel(),
                    .method = AnalysisMethod::twoLayer,
                    .thicknessMetres = 0.004},
                   control);
}

} // namespace

std::vector<std::string> factoryObjectNames() {
    std::vector<std::string> names;
    for (int note = lowestXylophoneNote; note <= highestXylophoneNote; ++note)
        names.push_back(rosewoodXylophoneBar(note).name);
    names.insert(names.end(), {"plate", "ring"});
    return names;
}

Result<ModalObject> makeFactoryObject(const std::string& name, const AnalysisControl& control) {
    for (int note = lowestXylophoneNote; note <= highestXylophoneNote; ++note)
        if (const auto bar = rosewoodXylophoneBar(note); bar.name == name)
            return tuneBar(bar, control).map([](TunedBar tuned) {
                return std::move(tuned.object);
            });
    if (name == "plate")
        return makePlate(control);
    if (name == "ring")
        return makeRing(control);
    return failure("there is no factory object '" + name + "'");
}

} // namespace idiophone
