// Materials from recordings, from the choice of what was struck to the sound.
#include "Object/MaterialFile.h"
#include "Plugin/FactoryPrograms.h"
#include "Support/ImportedFiles.h"
#include "Support/PresetNumber.h"
#include "Support/RecordedStrike.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
using Struck = RecordedStrike::Struck;
using FitStage = MaterialFitStatus::Stage;

namespace {

const std::vector<Tone> tones{{440, 6, 0.4}, {1210, 11, 0.25}, {2370, 17, 0.15}};

/// Polls until a fit has ended.
MaterialFitStatus finishFit(Processor& processor) {
    waitUntil([&] { return processor.view().materialFits.fitStatus().stage != FitStage::working; },
              [&] { processor.poll(); });
    processor.poll();
    return processor.view().materialFits.fitStatus();
}

/// Imports a glass plate and returns a recording of it.
std::filesystem::path recordedPlate(Processor& processor) {
    auto& workshop = processor.view().workshop;
    workshop.setImportSettings({.material = "Glass"});
    workshop.openFile(smallPlateFile("plate.obj", 1));
    finish(processor);
    REQUIRE(workshop.importStatus().stage == ImportStatus::Stage::done);
    const auto& object = *processor.soundSession().instrument()->slots().front().object;
    return recordedStrike("plate.wav", tonesOf(object, object.shapeVertexCount() / 5));
}

double ratioOf(const Material& material) {
    return material.youngsModulusPa / material.densityKgPerM3;
}

void checkGlass(const Material& found) {
    const auto& glass = *findMaterial("Glass");
    CHECK(ratioOf(found) == Approx(ratioOf(glass)).epsilon(0.05));
    CHECK(decaySeconds(found, 6000) == Approx(decaySeconds(glass, 6000)).epsilon(0.2));
}

} // namespace

TEST_CASE(
    "A material of the object that is shown is saved, listed, heard, and undone in one step") {
    const UserSettings user;
    Processor processor;
    auto& view = processor.view();
    const auto recording = recordedPlate(processor);
    CHECK_THAT(view.materialFits.shownObject(),
               ContainsSubstring("plate, 6 x 3.6 x 0 cm, wall 2 mm"));
    const double before = view.parameters.value(ParameterId::material);
    const auto& playing = *processor.soundSession().instrument();
    view.materialFits.fitMaterial(
        {.recording = recording, .materialName = "Window pane", .struck = Struck::shown});
    CHECK(processor.soundSession().instrument().get() == &playing);
    const auto status = finishFit(processor);
    INFO(status.report);
    REQUIRE(status.stage == FitStage::done);
    CHECK_THAT(status.report, ContainsSubstring("'Window pane' is saved and chosen. It is like ") &&
                                  ContainsSubstring("modes are those of plate"));
    const auto found = findAnyMaterial("Window pane");
    REQUIRE(found);
    checkGlass(*found);
    CHECK(view.materials.userMaterialNames() == std::vector<std::string>{"Window pane"});
    CHECK(view.materials.userMaterialIndex() == 0);
    CHECK(view.history.undoName() == "Window pane");
    view.history.undo();
    CHECK(view.parameters.value(ParameterId::material) == before);
    CHECK(view.materials.userMaterialIndex() == -1);
}

TEST_CASE("A material is fitted to the object of a mesh file, and to a shape of given sizes") {
    const UserSettings user;
    Processor processor;
    const auto recording = recordedPlate(processor);
    const auto mesh = smallPlateFile("in-millimetres.obj", 1000);
    auto& fits = processor.view().materialFits;
    fits.fitMaterial({.recording = recording,
                      .materialName = "Of a mesh",
                      .struck = Struck::mesh,
                      .mesh = mesh,
                      .sizes = {.thicknessMetres = 0.002}});
    const auto ofMesh = finishFit(processor);
    CHECK(ofMesh.stage == FitStage::done);
    CHECK_THAT(ofMesh.report, ContainsSubstring("looks like millimetres"));
    fits.fitMaterial(
        {.recording = recording,
         .materialName = "Of a shape",
         .struck = Struck::shape,
         .shape = "plate",
         .sizes = {.lengthMetres = 0.06, .widthMetres = 0.036, .thicknessMetres = 0.002}});
    CHECK(finishFit(processor).stage == FitStage::done);
    for (const auto* name : {"Of a mesh", "Of a shape"}) {
        const auto found = findAnyMaterial(name);
        REQUIRE(found);
        checkGlass(*found);
    }
}

TEST_CASE("Where the object is unknown the damping is fitted, and no material is overwritten") {
    const UserSettings user;
    Processor processor;
    auto& view = processor.view();
    const auto file = recordedStrike("strike.flac", tones);
    for (const auto* name : {"Glass 2", "Glass 3"}) {
        view.materialFits.fitMaterial({.recording = file, .materialName = "Glass"});
        const auto status = finishFit(processor);
        REQUIRE(status.stage == FitStage::done);
        CHECK_THAT(status.report, ContainsSubstring(std::string("'") + name + "' is saved") &&
                                      ContainsSubstring("only the damping is fitted"));
    }
    CHECK(view.materials.userMaterialNames() == std::vector<std::string>{"Glass 2", "Glass 3"});
}

TEST_CASE("If another sound was loaded meanwhile, the material is saved and not chosen") {
    const UserSettings user;
    Processor processor;
    auto& view = processor.view();
    view.materialFits.fitMaterial(
        {.recording = recordedStrike("strike.wav", tones), .materialName = "Late"});
    processor.setCurrentProgram(presetNumber("Marimba"));
    const double before = view.parameters.value(ParameterId::material);
    const auto status = finishFit(processor);
    CHECK(status.stage == FitStage::done);
    CHECK_THAT(status.report, ContainsSubstring("'Late' is saved in the list."));
    CHECK(view.parameters.value(ParameterId::material) == before);
    CHECK(view.materials.userMaterialNames() == std::vector<std::string>{"Late"});
}

TEST_CASE(
    "A recording, mesh or shape that is no good is named with its fault, and nothing is saved") {
    const UserSettings user;
    Processor processor;
    auto& view = processor.view();
    const auto good = recordedStrike("strike.wav", tones);
    const auto faultOf = [&](const RecordedStrike& strike) {
        view.materialFits.fitMaterial(strike);
        const auto status = finishFit(processor);
        CHECK(status.stage == FitStage::failed);
        return status.report;
    };
    CHECK_THAT(faultOf({.recording = writtenFile("text.wav", "no sound")}),
               ContainsSubstring("text.wav") && !ContainsSubstring("/"));
    CHECK(view.status.takeStatus().isError);
    CHECK_THAT(faultOf({.recording = good, .struck = Struck::mesh, .mesh = "none.obj"}),
               ContainsSubstring("none.obj"));
    CHECK_THAT(faultOf({.recording = good,
                        .struck = Struck::shape,
                        .shape = "ring",
                        .sizes = {.radiusMetres = 0.01, .sectionRadiusMetres = 0.02}}),
               ContainsSubstring("cross-section"));
    CHECK_THAT(faultOf({.recording = good, .struck = Struck::shown}), // the xylophone
               ContainsSubstring("No single object"));
    CHECK(view.materials.readUserMaterials().empty());
}

TEST_CASE("The object that is shown is offered only if it is a single one with a mesh") {
    const UserSettings user;
    Processor processor;
    auto& view = processor.view();
    CHECK(view.materialFits.shownObject().empty()); // a bar for each key
    processor.setCurrentProgram(presetNumber("Dice on Rosewood"));
    CHECK(view.materialFits.shownObject().empty());
    processor.setCurrentProgram(presetNumber("Steel Plate"));
    CHECK_FALSE(view.materialFits.shownObject().empty());
    view.workshop.openFile(recordedStrike("strike.wav", tones));
    finish(processor);
    CHECK(view.materialFits.shownObject().empty());
}

TEST_CASE("A cancelled fit saves nothing, and another can follow it") {
    const UserSettings user;
    Processor processor;
    auto& view = processor.view();
    const RecordedStrike strike{.recording = recordedStrike("strike.wav", tones)};
    view.materialFits.fitMaterial(strike);
    view.materialFits.cancelFit();
    CHECK(view.materialFits.fitStatus().stage == FitStage::cancelled);
    processor.poll();
    CHECK(view.materials.readUserMaterials().empty());
    view.materialFits.fitMaterial(strike);
    CHECK(finishFit(processor).stage == FitStage::done);
    CHECK(view.materials.userMaterialNames() == std::vector<std::string>{"Material"});
}
