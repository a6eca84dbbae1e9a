#include "Editor/CaptureButton.h"

#include "Editor/EditorWindow.h"
#include "Editor/OpenWindow.h"
#include "Editor/Utf8.h"
#include "Editor/WindowParts.h"
#include "Support/PresetNumber.h"
#include "Support/SoundFile.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// A processor whose dice have struck something.
struct Thrown {
    Thrown() {
        processor.setCurrentProgram(presetNumber("Dice on Rosewood"));
        processor.setNonRealtime(true);
        processor.prepareToPlay(48000, 480);
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, 72, static_cast<juce::uint8>(100)), 0);
        render(processor, 48000, 480, midi);
        REQUIRE(processor.view().stage.hasCaptured());
    }
    CaptureButton<juce::TextButton> button() {
        auto& view = processor.view();
        return {view.status, stageCapture(view.stage, StageView::CaptureKind::midi, "*.mid"),
                "MIDI"};
    }
    Processor processor;
};

} // namespace

TEST_CASE("Each drag of a capture writes its own file, which later drags do not change") {
    Thrown thrown;
    auto midi = thrown.button();
    const auto first = midi.take();
    REQUIRE(first.existsAsFile());
    const auto written = first.loadFileAsString();
    thrown.processor.prepareToPlay(48000, 480);
    auto other = thrown.button();
    const auto second = other.take();
    REQUIRE(second.existsAsFile());
    CHECK(second != first);
    CHECK(first.loadFileAsString() == written);
    for (const auto& file : {first, second}) {
        CHECK(file.hasFileExtension(".mid"));
        CHECK(DragFolder::contains(pathOf(file)));
    }
    CHECK_FALSE(DragFolder::contains(pathOf(first.getParentDirectory().getSiblingFile("x"))));
    CHECK_FALSE(DragFolder::contains(testFolder() / "Idiophone-drag-1" / "x.mid"));

    // No other user can have made the folder, and it is created again after deletion.
    const auto folder = first.getParentDirectory();
#ifndef _WIN32
    using std::filesystem::perms;
    CHECK((std::filesystem::status(pathOf(folder)).permissions() &
           (perms::group_all | perms::others_all)) == perms::none);
#endif
    REQUIRE(folder.deleteRecursively());
    const auto third = midi.take();
    CHECK(third.existsAsFile());
    CHECK(third.getParentDirectory() != folder);
    third.getParentDirectory().deleteRecursively();
}

TEST_CASE("A capture saved without an extension gets one, and does not overwrite a file unasked") {
    Thrown thrown;
    auto midi = thrown.button();
    const auto bare = fileOf(testFolder() / "throw"), with = bare.withFileExtension("mid");
    midi.save(midi.take(), bare);
    CHECK_FALSE(bare.exists());
    REQUIRE(with.getSize() > 0);

    with.replaceWithText("another's");
    midi.save(midi.take(), bare);
    CHECK(with.loadFileAsString() == "another's");
    CHECK(thrown.processor.view().status.takeStatus().sentence ==
          "There is already a file throw.mid.");
    const auto taken = midi.take();
    midi.save(taken, with); // the chooser has asked about this file
    CHECK(with.loadFileAsString() != "another's");
    CHECK_FALSE(taken.exists());
    taken.getParentDirectory().deleteRecursively();
}

TEST_CASE("A drag of the last 30 seconds writes them as a WAV file named after the preset") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 480);
    const auto window = open(processor);
    auto* last = find<CaptureButton<IconButton>>(*window, "Last 30 seconds");
    REQUIRE(last != nullptr);
    const auto checkNothing = [&](const auto& act) {
        processor.view().status.reportError("Another error.");
        act();
        CHECK(processor.view().status.takeStatus().sentence.starts_with(
            "There is nothing to save yet"));
    };
    checkNothing([&] { CHECK(last->fileToDrag() == juce::File()); });
    checkNothing([&] { last->onClick(); });
    render(processor, 24000, 480, testMusic(24000));
    const auto file = last->take();
    REQUIRE(file.existsAsFile());
    CHECK(file.getFileName().startsWith("Test keyboard 20"));
    CHECK(file.hasFileExtension(".wav"));
    CHECK(DragFolder::contains(pathOf(file)));
    CHECK(loudest(readSoundFile(pathOf(file)).sound) > 0.001f);
    file.getParentDirectory().deleteRecursively();
}

TEST_CASE("The last 30 seconds are those before the click, however long the file is chosen") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 480);
    const auto window = open(processor);
    auto* last = find<CaptureButton<IconButton>>(*window, "Last 30 seconds");
    REQUIRE(last != nullptr);
    render(processor, 24000, 480, testMusic(24000));
    const auto taken = last->take();
    REQUIRE(taken.existsAsFile());
    processor.view().instrument.silence();
    render(processor, 31 * 48000, 480, {});
    CHECK_FALSE(processor.view().recorder.hasLastSound());
    const auto chosen = fileOf(testFolder() / "take.wav");
    last->save(taken, chosen);
    CHECK(loudest(readSoundFile(pathOf(chosen)).sound) > 0.001f);

    const auto nowhere = fileOf(testFolder() / "none" / "take.wav");
    chosen.copyFileTo(taken);
    last->save(taken, nowhere);
    CHECK(processor.view().status.takeStatus().sentence ==
          "The file " + nowhere.getFullPathName().toStdString() +
              " cannot be written. Choose another folder.");
    taken.getParentDirectory().deleteRecursively();
}

TEST_CASE("Files for dragging are removed a week after the last one of their folder") {
    const auto system = pathOf(juce::File::getSpecialLocation(juce::File::tempDirectory));
    const auto name = "Idiophone-drag-" + testFolder().filename().string();
    const auto old = system / (name + "-old"), young = system / (name + "-young"),
               others = system / ("Others-drag-" + testFolder().filename().string());
    for (const auto& folder : {old, young, others}) {
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "x.wav") << "x";
        const auto days = std::chrono::hours(24 * (folder == young ? 6 : 8));
        std::filesystem::last_write_time(folder,
                                         std::filesystem::file_time_type::clock::now() - days);
    }
    DragFolder::removeOld();
    CHECK_FALSE(std::filesystem::exists(old));
    CHECK(std::filesystem::exists(young / "x.wav"));
    CHECK(std::filesystem::exists(others / "x.wav"));
    for (const auto& folder : {young, others})
        std::filesystem::remove_all(folder);
}
