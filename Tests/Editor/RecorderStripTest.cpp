#include "Editor/RecorderStrip.h"

#include "Editor/OpenWindow.h"
#include "Editor/WindowParts.h"
#include "Support/HomeFolder.h"
#include "Support/SoundFile.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

#ifndef _WIN32
TEST_CASE("The record button shows the time while it records, and then the file") {
    const HomeFolder home;
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 480);
    const auto window = open(processor);
    auto* strip =
        dynamic_cast<RecorderStrip*>(find<IconButton>(*window, "Record")->getParentComponent());
    REQUIRE(strip != nullptr);
    auto* record = find<IconButton>(*strip, "Record");
    auto* take = find<DragOutButton<juce::TextButton>>(*strip, "Recording");
    REQUIRE(take != nullptr);
    CHECK_FALSE(take->isVisible());
    const int width = strip->getWidth();
    const auto place = record->getScreenBounds();

    record->onClick();
    CHECK(record->getScreenBounds() == place); // a second click stops
    CHECK(record->getTitle() == "Stop recording");
    CHECK(record->getToggleState());
    CHECK(take->isVisible());
    CHECK(strip->getWidth() > width);
    CHECK(take->getButtonText() == "0:00");
    CHECK(take->fileToDrag() == juce::File());
    const auto red = take->findColour(juce::TextButton::textColourOffId);
    CHECK(red == colourOf(*strip, LookColour::error));
    for (const int end : {20, 40, 61}) { // less at once than the 30 s that wait for the recorder
        render(processor, (end == 61 ? 21 : 20) * 48000, 480, {});
        waitUntil([&] { return processor.view().recorder.recording().seconds >= end; });
    }
    strip->refresh();
    CHECK(take->getButtonText() == "1:01");

    record->onClick();
    CHECK(record->getTitle() == "Record");
    CHECK_FALSE(record->getToggleState());
    CHECK(take->isVisible());
    const auto file = take->fileToDrag();
    CHECK(file.existsAsFile());
    CHECK(take->getTooltip().startsWith(file.getFileName()));
    CHECK(take->findColour(juce::TextButton::textColourOffId) != red);
}

TEST_CASE("A window shows a recording that goes on since an earlier window") {
    const HomeFolder home;
    Processor processor;
    processor.prepareToPlay(48000, 480);
    find<IconButton>(*open(processor), "Record")->onClick();
    const auto window = open(processor);
    CHECK(find<IconButton>(*window, "Stop recording") != nullptr);
    CHECK(find<DragOutButton<juce::TextButton>>(*window, "Recording")->isVisible());
}
#endif
