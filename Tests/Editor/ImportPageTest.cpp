// Tests of the import page and of dropped files, without a screen.
#include "Editor/ImportPage.h"
#include "Editor/EditorWindow.h"
#include "Editor/WindowParts.h"
#include "Support/ImportedFiles.h"
#include "Support/PresetNumber.h"
#include "Support/TestSound.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using ImportStage = ImportStatus::Stage;

namespace {

void click(juce::Button& button) {
    REQUIRE(button.isEnabled());
    button.onClick();
}

struct Page {
    Page() { page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight); }

    juce::String report() {
        return part<juce::TextEditor>(page, "What was made of the file").getText();
    }
    juce::String file() { return part<juce::Label>(page, "File").getText(); }
    void choose(const juce::String& list, int item) {
        part<juce::ComboBox>(page, list).setSelectedId(item, juce::sendNotificationSync);
    }

    Processor processor;
    Look look;
    ImportPage page{processor.view()};
};

} // namespace

TEST_CASE("Thickness is parsed in the typed unit, in millimetres by default") {
    CHECK(parseThicknessMetres("2").value() == Approx(0.002));
    CHECK(parseThicknessMetres(" 2,5 mm").value() == Approx(0.0025));
    CHECK(parseThicknessMetres("0.3cm").value() == Approx(0.003));
    CHECK(parseThicknessMetres("0.01 m").value() == Approx(0.01));
    CHECK(parseThicknessMetres("1 in").value() == Approx(0.0254));
    for (const auto* wrong : {"", "mm", "thick", "-2", "0", "3 miles", "5000 mm", "."})
        CHECK_FALSE(parseThicknessMetres(wrong));
    for (const double metres : {0.002, 0.0005, 0.0125, 1.0})
        CHECK(parseThicknessMetres(thicknessText(metres)).value() == Approx(metres));
}

TEST_CASE("A size is parsed in the typed unit, in centimetres by default") {
    CHECK(parseSizeMetres("12").value() == Approx(0.12));
    CHECK(parseSizeMetres("12,5 cm").value() == Approx(0.125));
    CHECK(parseSizeMetres("80 mm").value() == Approx(0.08));
    CHECK(parseSizeMetres("2m").value() == Approx(2));
    for (const auto* wrong : {"", "0.05", "25 m", "-3", "cm", "3 miles"})
        CHECK_FALSE(parseSizeMetres(wrong));
    for (const double metres : {0.002, 0.125, 1.2, 12.0})
        CHECK(parseSizeMetres(sizeText(metres)).value() == Approx(metres));
}

TEST_CASE("A number has three significant digits, and all of those before the point") {
    CHECK(threeDigits(2.3) == "2.30");
    CHECK(threeDigits(0.04) == "0.040");
    CHECK(threeDigits(9.996) == "10.0");
    CHECK(threeDigits(99.96) == "100");
    CHECK(threeDigits(1447.03) == "1447");
    CHECK(figureText(2.3) == "2.3");
    CHECK(figureText(0.04) == "0.04");
    CHECK(figureText(0.0001) == "0");
    CHECK(figureText(30) == "30");
    CHECK(figureText(340.2) == "340");
}

TEST_CASE("Size and mass are texts in centimetres, and grams or kilograms") {
    CHECK(measuresText({0.3, 0.12, 0.004}, 0.34) == "30 x 12 x 0.4 cm, 340 g");
    CHECK(measuresText({1.234, 0.5, 0}, 12.345) == "123 x 50 x 0 cm, 12.3 kg");
    CHECK(measuresText({}, 0) == "");
}

TEST_CASE("The time that is left is said in seconds, then in minutes") {
    ImportStatus status;
    status.stage = ImportStage::previewed;
    status.step = "Finding its modes";
    CHECK(ImportPage::stepText(status) == "A preview plays. Finding its modes...");
    status.secondsLeft = 12;
    CHECK(ImportPage::stepText(status) == "A preview plays. Finding its modes, about 12 s left");
    status.stage = ImportStage::working;
    status.secondsLeft = 150;
    CHECK(ImportPage::stepText(status) == "Finding its modes, about 3 min left");
}

TEST_CASE("The page shows size and mass, and a typed longest side scales the object") {
    Page p;
    auto& size = part<juce::Label>(p.page, "Longest side");
    auto& measures = part<juce::Label>(p.page, "Size and mass");
    p.processor.view().workshop.openFile(smallPlateFile("plate.obj", 1));
    finish(p.processor);
    p.page.refresh();
    CHECK(size.getText() == "6 cm");
    CHECK(measures.getText().startsWith("6 x 3.6 x 0 cm, 33"));
    CHECK(measures.isVisible());

    size.setText("12 cm", juce::sendNotificationSync);
    CHECK(p.processor.view().workshop.importStatus().isWorking());
    finish(p.processor);
    p.page.refresh();
    CHECK(size.getText() == "12 cm");
    CHECK(measures.getText().startsWith("12 x 7.2 x 0 cm"));
    CHECK(p.report().contains("Scaled to a longest side of 120 mm"));

    size.setText("very large", juce::sendNotificationSync);
    CHECK(size.getText() == "12 cm");
    CHECK_FALSE(p.processor.view().workshop.importStatus().isWorking());

    p.choose("Unit", 6); // feet
    finish(p.processor);
    p.page.refresh();
    CHECK(size.getText() == "1.83 cm");

    p.processor.view().workshop.openFile(smallPlateFile("next.obj", 1));
    finish(p.processor);
    p.choose("Unit", 1);
    size.setText("20", juce::sendNotificationSync);
    p.processor.view().workshop.openFile(smallPlateFile("last.obj", 1));
    finish(p.processor);
    p.page.refresh();
    CHECK(size.getText() == "6 cm"); // a new file has its own size
}

TEST_CASE("A shortcut sets size, material and thickness in one click and analyses anew") {
    Page p;
    auto& bell = part<juce::Button>(p.page, "Make it: Bell");
    CHECK_FALSE(bell.isEnabled()); // bars
    p.processor.view().workshop.openFile(smallPlateFile("plate.obj", 1));
    finish(p.processor);
    p.page.refresh();
    CHECK_FALSE(bell.getToggleState());
    click(bell);
    CHECK(bell.getToggleState());
    finish(p.processor);
    p.page.refresh();
    const auto object = p.processor.view().instrument.playedObjects().front().object;
    CHECK(object->material.name == "Bell bronze");
    CHECK(object->thicknessMetres == Approx(0.003));
    CHECK(part<juce::Label>(p.page, "Longest side").getText() == "12 cm");
    CHECK(part<juce::Label>(p.page, "Size and mass").getText().startsWith("12 x 7.2"));

    p.processor.setCurrentProgram(4); // a steel ring, which did not come from a file
    p.page.refresh();
    CHECK_FALSE(bell.getToggleState());
    CHECK(part<juce::Label>(p.page, "Size and mass").getText().endsWith("g"));
    click(part<juce::Button>(p.page, "Make it: Toy"));
    const auto status = p.processor.view().workshop.importStatus();
    CHECK(status.isWorking());
    CHECK(status.settings.material == "Tin");
    p.processor.view().workshop.cancelImport();
}

TEST_CASE("Every shortcut can be made") {
    for (const auto& shortcut : objectShortcuts) {
        INFO(shortcut.name);
        CHECK(findMaterial(shortcut.material) != nullptr);
        const auto settings = withShortcut({}, shortcut);
        CHECK(parseSizeMetres(sizeText(settings.longestMetres)).has_value());
        CHECK(parseThicknessMetres(thicknessText(settings.thicknessMetres)).has_value());
        CHECK(settings.method == (shortcut.isShell ? "two-layer" : ""));
    }
}

TEST_CASE("The page shows the file and the choices made, and new settings start a new analysis") {
    Page p;
    CHECK(p.file().contains("Drop"));
    p.processor.view().workshop.openFile(smallPlateFile("plate.obj", 1000));
    p.page.refresh();
    CHECK(part<juce::Button>(p.page, "Cancel the analysis").isVisible());
    finish(p.processor);
    p.page.refresh();
    CHECK(p.file() == "plate.obj");
    CHECK(p.report().contains("modes from"));
    CHECK(p.report().contains("looks like millimetres"));
    CHECK(p.report().contains("Taken as a shell of 2 mm"));
    CHECK_FALSE(part<juce::Button>(p.page, "Cancel the analysis").isVisible());
    CHECK(part<juce::ComboBox>(p.page, "Unit").getText() == "Auto: mm");
    CHECK(part<juce::ComboBox>(p.page, "Method").getText() == "Auto: Shell");

    part<juce::ComboBox>(p.page, "Material").setText("Glass", juce::sendNotificationSync);
    CHECK(p.processor.view().workshop.importStatus().isWorking());
    part<juce::Label>(p.page, "Thickness of shells").setText("4 mm", juce::sendNotificationSync);
    finish(p.processor);
    p.page.refresh();
    const auto object = p.processor.view().instrument.playedObjects().front().object;
    CHECK(object->material.name == "Glass");
    CHECK(object->thicknessMetres == Approx(0.004));

    const auto number = p.processor.view().instrument.instrumentNumber();
    part<juce::Label>(p.page, "Thickness of shells")
        .setText("nonsense", juce::sendNotificationSync);
    CHECK(part<juce::Label>(p.page, "Thickness of shells").getText() == "4 mm");
    p.page.refresh();
    p.page.refresh();
    finish(p.processor);
    CHECK(p.processor.view().instrument.instrumentNumber() == number);
}

TEST_CASE("The page holds the object at an end, and says how a preset's object is held") {
    Page p;
    auto& held = part<juce::ComboBox>(p.page, "Held");
    auto& support = part<juce::ComboBox>(p.page, "Support");
    p.processor.view().workshop.openFile(writtenFile(
        "square.obj",
        "v 0 0 0\nv 0.012 0 0\nv 0.012 0.02 0\nv 0 0.02 0\nf 1 2 3\ng half\nf 1 3 4\n"));
    finish(p.processor);
    p.page.refresh();
    CHECK(held.getText() == "Nowhere");
    CHECK_FALSE(support.isEnabled());
    juce::StringArray choices;
    for (int item = 0; item < held.getNumItems(); ++item)
        choices.add(held.getItemText(item));
    CHECK(choices.joinIntoString(", ") == "Nowhere, Near end, Far end, Part: half, Painted region");

    p.choose("Held", 3);
    CHECK(held.getText() == "Far end");
    p.choose("Support", 3);
    finish(p.processor);
    p.page.refresh();
    CHECK(p.report().contains("Clamps hold"));
    CHECK(support.getText() == "Wood");
    const auto object = p.processor.view().instrument.playedObjects().front().object;
    REQUIRE_FALSE(object->clampedVertices.empty());
    CHECK(object->vertices[3 * static_cast<std::size_t>(object->clampedVertices.front()) + 1] ==
          Approx(0.02));
    CHECK_FALSE(object->extraDecaysPerSecond.empty());

    p.processor.setCurrentProgram(0); // bars
    p.page.refresh();
    CHECK(held.getText() == "Nowhere");

    p.processor.view().workshop.openFile(smallPlateFile("next.obj", 1));
    p.page.refresh();
    CHECK(held.getText() == "Nowhere"); // a new file has parts of its own
    p.processor.view().workshop.cancelImport();

    p.processor.setCurrentProgram(presetNumber("Jaw Harp Reed"));
    p.page.refresh();
    CHECK(held.getText() == "As before");
    p.processor.setCurrentProgram(4); // a steel ring
    p.page.refresh();
    CHECK(held.getText() == "Nowhere");
}

TEST_CASE("The page shows an import error as a sentence, and says when an import is cancelled") {
    Page p;
    p.processor.view().workshop.openFile(writtenFile("broken.obj", "f 1 2 3\n"));
    finish(p.processor);
    p.page.refresh();
    CHECK(p.report().contains("broken.obj"));
    const auto& report = part<juce::TextEditor>(p.page, "What was made of the file");
    CHECK(report.findColour(juce::TextEditor::textColourId) == colourOf(p.page, LookColour::error));

    p.processor.view().workshop.openFile(meshFile("ball.obj", icosphereMesh(0.1, 4)));
    p.page.refresh();
    click(part<juce::Button>(p.page, "Cancel the analysis"));
    CHECK(p.processor.view().workshop.importStatus().stage == ImportStage::cancelled);
    CHECK(part<juce::Label>(p.page, "Progress").getText() == "Cancelled.");
}

TEST_CASE("Two buttons switch between keys at their pitches and keys along a path") {
    Page p;
    auto& scaled = part<juce::Button>(p.page, "Keys scaled to their pitches");
    auto& zones = part<juce::Button>(p.page, "Keys along a strike path");
    CHECK_FALSE(zones.isEnabled()); // bars
    p.processor.view().workshop.openFile(smallPlateFile("plate.obj", 1));
    finish(p.processor);
    p.page.refresh();
    CHECK(scaled.getToggleState());
    click(zones);
    CHECK(p.processor.view().workshop.keyLayout() == KeyLayout::zones);
    CHECK(zones.getToggleState());
    CHECK_FALSE(scaled.getToggleState());
    click(scaled);
    CHECK(p.processor.view().workshop.keyLayout() == KeyLayout::scaled);
}

TEST_CASE("A preset's object is analysed again on request, but not when a setting changes") {
    Page p;
    p.processor.setCurrentProgram(4); // a steel ring
    p.page.refresh();
    const auto before = p.processor.soundSession().instrument();
    part<juce::ComboBox>(p.page, "Material").setText("Glass", juce::sendNotificationSync);
    CHECK_FALSE(p.processor.view().workshop.importStatus().isWorking());
    click(part<juce::Button>(p.page, "Analyse anew"));
    CHECK(p.processor.view().workshop.importStatus().isWorking());
    CHECK(p.processor.soundSession().instrument() == before);
    p.processor.view().workshop.cancelImport();
}

TEST_CASE("Files can be dropped anywhere on the window; unreadable files are reported") {
    Processor processor;
    const std::unique_ptr<juce::AudioProcessorEditor> editor(processor.createEditor());
    auto& window = dynamic_cast<EditorWindow&>(*editor);
    const auto file = juce::String(smallPlateFile("plate.obj", 1).string());
    window.setSize(1180, 860);
    CHECK(window.isInterestedInFileDrag({"song.mid", file}));
    window.fileDragMove({file}, 10, 10);
    window.fileDragExit({file});
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::none);
    window.filesDropped({"song.mid", file}, 10, 10);
    CHECK(processor.view().workshop.importStatus().isWorking());
    finish(processor);
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::done);
    CHECK(part<ImportPage>(window, "").isVisible());
    window.setSize(WindowSize::minimumWidth, WindowSize::minimumHeight);
    CHECK(part<ImportPage>(window, "").isVisible());

    for (const auto* refused : {"song.mid", "folder"}) {
        INFO(refused);
        const auto path = juce::File::getCurrentWorkingDirectory().getChildFile(refused);
        REQUIRE(window.isInterestedInFileDrag({path.getFullPathName()}));
        window.filesDropped({path.getFullPathName()}, 10, 10);
        CHECK(processor.view().workshop.importStatus().stage == ImportStage::done);
        const auto status = processor.view().status.takeStatus();
        CHECK(status.isError);
        CHECK(status.sentence.starts_with('"' + std::string(refused) + '"'));
        CHECK(status.sentence.ends_with("none of .obj, .off, .ply, .stl, .gltf, .glb, .modal, "
                                        ".wav, .flac, .aif, .aiff, .scl, .kbm, "
                                        ".json."));
    }
    const auto captured = juce::File::getSpecialLocation(juce::File::tempDirectory)
                              .getChildFile("Idiophone-drag-1a/Idiophone capture.mid");
    CHECK_FALSE(window.isInterestedInFileDrag({captured.getFullPathName()}));
}

TEST_CASE("The page's buttons show their whole text and have tooltips") {
    Page p;
    p.page.setLookAndFeel(&p.look);
    for (const auto* title :
         {"Open a mesh, a recording or a modal object", "Analyse anew",
          "Keys scaled to their pitches", "Keys along a strike path", "Make it: Plate"}) {
        auto& button = part<juce::TextButton>(p.page, title);
        INFO(title);
        CHECK(juce::GlyphArrangement::getStringWidth(Look::textFont(), button.getButtonText()) +
                  10 <
              static_cast<float>(button.getWidth()));
        CHECK(button.getTooltip().isNotEmpty());
    }
    CHECK(part<juce::TextEditor>(p.page, "What was made of the file").getHeight() >= 60);
    p.page.setLookAndFeel(nullptr);
}
