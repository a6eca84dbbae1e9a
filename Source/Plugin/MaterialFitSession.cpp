#include "Plugin/MaterialFitSession.h"

#include "Analysis/BodyModel.h"
#include "Editor/ImportMeasures.h"
#include "Editor/Utf8.h"
#include "Geometry/LengthUnit.h"
#include "Geometry/MeshReader.h"
#include "Mesh/ObjectMesh.h"
#include "Object/MaterialFile.h"
#include "Plugin/FileKinds.h"
#include "Plugin/ImportSummary.h"
#include "Plugin/ImportedSound.h"

#include <algorithm>
#include <utility>

namespace idiophone {
namespace {

using Struck = RecordedStrike::Struck;
using FitStage = MaterialFitStatus::Stage;
using MaybeStruck = Result<std::optional<StruckObject>>;

MaybeStruck objectOfFile(const std::filesystem::path& file, double thicknessMetres) {
    const auto read = readMeshFile(file);
    if (!read)
        return failure(withoutFolder(read.error().message, file));
    const auto guess = guessLengthUnit(read->mesh, read->isInMetres);
    StruckObject object{.name = fileNameOf(file),
                        .mesh = read->mesh,
                        .thicknessMetres = thicknessMetres,
                        .notes = joinedSentences({read->notes, guess.sentence})};
    object.mesh.vertices *= guess.unit.metresPerUnit;
    return object;
}

/// Bodies are solids, and sheets are shells of the given thickness.
MaybeStruck objectOfShape(const std::string& shape, ShapeSizes sizes) {
    const double thickness = std::exchange(sizes.thicknessMetres, 0); // a bowl is a shell here
    if (shape == "bowl") // its outside was measured, and the mesh is the middle of its wall
        for (auto* size : {&sizes.radiusMetres, &sizes.footRadiusMetres, &sizes.heightMetres})
            *size = std::max(*size - thickness / 2, 1e-4);
    return simpleShape(shape, sizes).map([&](Mesh&& mesh) {
        const bool isBody = shape == "box" || shape == "ring" || shape == "icosphere";
        return std::optional(StruckObject{
            .name = "such a " + (shape == "box" ? "bar" : shape),
            .mesh = std::move(mesh),
            .method = isBody ? AnalysisMethod::tetrahedra : AnalysisMethod::twoLayer,
            .thicknessMetres = thickness > 0 ? thickness : StruckObject{}.thicknessMetres});
    });
}

} // namespace

std::string MaterialFitSession::recordingPatterns() const {
    return recordingFiles;
}

std::string MaterialFitSession::meshPatterns() const {
    return meshFiles;
}

/// Returns the single object that plays, if its mesh can be analysed again.
std::shared_ptr<const ModalObject> MaterialFitSession::shown() const {
    const auto playing = session.instrument();
    if (!layoutOf(playing) || imports.playsPreview())
        return nullptr;
    const auto& object = playing->slots().front().object;
    return findMethod(object->method) ? object : nullptr; // a recorded object has no mesh
}

double MaterialFitSession::thicknessMetresOf(const ModalObject& object) const {
    return object.thicknessMetres *
           (object.hasLiveThickness() ? parameters[ParameterId::thickness].exactValue() / 100 : 1);
}

std::string MaterialFitSession::shownObject() const {
    const auto object = shown();
    if (object == nullptr)
        return {};
    auto text = fromUtf8(object->name) + ", " + sidesText(sidesMetresOf(*object));
    if (object->thicknessMetres > 0)
        text << ", wall " << thicknessText(thicknessMetresOf(*object));
    return text.toStdString();
}

/// Returns what makes the struck object on the worker, or nothing if none plays.
std::optional<MaterialWorkshop::StruckObjectMaker>
MaterialFitSession::struckIn(const RecordedStrike& strike) const {
    switch (strike.struck) {
    case Struck::mesh:
        return [file = strike.mesh, thickness = strike.sizes.thicknessMetres] {
            return objectOfFile(file, thickness);
        };
    case Struck::shape:
        return [kind = strike.shape, sizes = strike.sizes] { return objectOfShape(kind, sizes); };
    case Struck::unknown:
        return [] { return MaybeStruck(std::nullopt); };
    case Struck::shown:
        break;
    }
    const auto object = shown();
    if (object == nullptr)
        return std::nullopt;
    return [object, thickness = thicknessMetresOf(*object)] {
        return MaybeStruck(StruckObject{.name = object->name,
                                        .mesh = objectMesh(*object),
                                        .method = findMethod(object->method),
                                        .thicknessMetres = thickness});
    };
}

void MaterialFitSession::fitMaterial(const RecordedStrike& strike) {
    workshop.cancel();
    outcome = {};
    origin = session.origin();
    auto struck = struckIn(strike);
    if (struck)
        workshop.start(
            {.recording = strike.recording,
             .materialName = strike.materialName.empty() ? "Material" : strike.materialName,
             .struckObject = std::move(*struck)});
    else
        outcome = {.stage = FitStage::failed,
                   .report = "No single object with a mesh plays now: choose what was struck."};
}

MaterialFitStatus MaterialFitSession::fitStatus() const {
    return outcome.stage == FitStage::none ? workshop.status() : outcome;
}

void MaterialFitSession::poll() {
    if (outcome.stage != FitStage::none)
        return;
    if (const auto made = workshop.takeProduct())
        return keep(*made);
    if (auto status = workshop.status(); status.stage == FitStage::failed) {
        session.reportError(status.report);
        outcome = std::move(status);
    }
}

/// Saves a material, and chooses it unless another sound was loaded meanwhile.
void MaterialFitSession::keep(const RecordedMaterial& made) {
    const auto saved = addUserMaterial(made.fit.material);
    if (!saved) {
        session.reportError(saved.error().message);
        outcome = {.stage = FitStage::failed, .report = saved.error().message};
        return;
    }
    const bool isHeard = origin == session.origin();
    if (isHeard)
        materials.choose(saved->name);
    else
        materials.readUserMaterials();
    outcome = {.stage = FitStage::done,
               .progress = 1,
               .report = joinedSentences(
                   {"'" + saved->name + "' is saved" + (isHeard ? " and chosen." : " in the list."),
                    "It is " + made.findings + ".", made.notes})};
}

} // namespace idiophone
