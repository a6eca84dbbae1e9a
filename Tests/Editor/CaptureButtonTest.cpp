#include "Editor/CaptureButton.h"

#include "Editor/Utf8.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// A processor whose dice have struck something.
struct Thrown {
    Thrown() {
        for (int program = 0; program < processor.getNumPrograms(); ++program)
            if (processor.getProgramName(program) == "Dice on Rosewood")
                processor.setCurrentProgram(program);
        processor.setNonRealtime(true);
        processor.prepareToPlay(48000, 480);
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, 72, static_cast<juce::uint8>(100)), 0);
        render(processor, 48000, 480, midi);
        REQUIRE(processor.view().stage.hasCaptured());
    }
    Processor processor;
};

} // namespace

TEST_CASE("Each drag of a capture writes its own file, which later drags do not change") {
    Thrown thrown;
    CaptureButton midi(thrown.processor.view(), StageView::CaptureKind::midi, "MIDI", "", "*.mid");
    const auto first = midi.writeForDrag();
    REQUIRE(first.existsAsFile());
    const auto written = first.loadFileAsString();
    thrown.processor.prepareToPlay(48000, 480);
    CaptureButton other(thrown.processor.view(), StageView::CaptureKind::midi, "MIDI", "", "*.mid");
    const auto second = other.writeForDrag();
    REQUIRE(second.existsAsFile());
    CHECK(second != first);
    CHECK(first.loadFileAsString() == written);
    for (const auto& file : {first, second}) {
        CHECK(file.hasFileExtension(".mid"));
        CHECK(CaptureButton::isForDrag(pathOf(file)));
    }
    CHECK_FALSE(CaptureButton::isForDrag(pathOf(first.getParentDirectory().getSiblingFile("x"))));
    CHECK_FALSE(CaptureButton::isForDrag(testFolder() / "Idiophone-drag-1" / "x.mid"));

    // No other user can have made the folder, and it is created again after deletion.
    const auto folder = first.getParentDirectory();
#ifndef _WIN32
    using std::filesystem::perms;
    CHECK((std::filesystem::status(pathOf(folder)).permissions() &
           (perms::group_all | perms::others_all)) == perms::none);
#endif
    REQUIRE(folder.deleteRecursively());
    const auto third = midi.writeForDrag();
    CHECK(third.existsAsFile());
    CHECK(third.getParentDirectory() != folder);
    third.getParentDirectory().deleteRecursively();
}

TEST_CASE("A capture saved without an extension gets one, and does not overwrite a file unasked") {
    Thrown thrown;
    CaptureButton midi(thrown.processor.view(), StageView::CaptureKind::midi, "MIDI", "", "*.mid");
    const auto bare = fileOf(testFolder() / "throw"), with = bare.withFileExtension("mid");
    midi.save(bare);
    CHECK_FALSE(bare.exists());
    REQUIRE(with.getSize() > 0);

    with.replaceWithText("another's");
    midi.save(bare);
    CHECK(with.loadFileAsString() == "another's");
    CHECK(thrown.processor.view().status.takeStatus().sentence ==
          "There is already a file throw.mid.");
    midi.save(with); // the chooser has asked about this file
    CHECK(with.loadFileAsString() != "another's");
}
