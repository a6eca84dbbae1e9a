#include "Editor/SampleForm.h"

#include "Editor/OpenWindow.h"
#include "Editor/PageDeck.h"
#include "Editor/RecorderStrip.h"
#include "Editor/WindowParts.h"
#include "Editor/WindowScale.h"
#include "Plugin/FactoryPrograms.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"
#include "Support/WaitUntil.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using SampleStage = SampleStatus::Stage;

namespace {

struct Form {
    Form() {
        restore(processor, testState());
        processor.prepareToPlay(48000, 480);
        form.setSize(776, 348);
        form.refresh();
    }
    juce::ComboBox& list(const char* title) {
        auto* found = find<juce::ComboBox>(form, title);
        INFO(title);
        REQUIRE(found != nullptr);
        return *found;
    }
    void choose(const char* title, int number) {
        list(title).setSelectedId(number, juce::sendNotificationSync);
    }
    juce::Button& button(const char* title) {
        auto* found = find<juce::Button>(form, title);
        INFO(title);
        REQUIRE(found != nullptr);
        return *found;
    }
    /// Returns the sentence once nothing runs.
    std::string wait() {
        waitUntil([&] {
            const auto stage = processor.view().samples.sampleStatus().stage;
            return stage != SampleStage::estimating && stage != SampleStage::exporting;
        });
        form.refresh();
        return find<juce::Label>(form, "Size of the export")->getText().toStdString();
    }

    UserSettings user;
    Processor processor;
    SampleForm form{processor.view()};
};

} // namespace

TEST_CASE("The form says how many samples there will be before the export starts") {
    Form window;
    CHECK(window.list("Lowest key").getText() == "C4 (60)");
    CHECK(window.list("Highest key").getText() == "C5 (72)");
    CHECK_THAT(window.wait(), ContainsSubstring("65 samples, ") && ContainsSubstring(" MB."));
    window.choose("Velocity layers", 2);
    CHECK_THAT(window.wait(), ContainsSubstring("26 samples, "));
    window.choose("Which keys", 3);
    CHECK_THAT(window.wait(), ContainsSubstring("10 samples, "));
    window.choose("Highest key", 62); // note 61
    CHECK_THAT(window.wait(), ContainsSubstring("2 samples, "));
    window.choose("Round robins", 3);
    CHECK_THAT(window.wait(), ContainsSubstring("6 samples, "));
    CHECK(window.button("Export...").isEnabled());
}

TEST_CASE("Places of an object have choices of their own") {
    Form window;
    CHECK_FALSE(window.list("Number of places").isVisible());
    window.choose("What to sample", 2);
    CHECK(window.list("Number of places").isVisible());
    CHECK_FALSE(window.list("Lowest key").isVisible());
    CHECK(window.list("Object to sample").getNumItems() == 13);
    window.choose("Number of places", 2);
    CHECK_THAT(window.wait(), ContainsSubstring("10 samples, "));
    window.choose("Number of places", 100);
    CHECK_THAT(window.wait(), ContainsSubstring("only"));
    CHECK_FALSE(window.button("Export...").isEnabled());
}

TEST_CASE("The form exports, says where the samples are and offers to show them") {
    Form window;
    const auto folder = testFolder() / "exported";
    std::filesystem::create_directories(folder);
    window.choose("Highest key", 61);
    window.choose("Velocity layers", 2);
    window.choose("Longest sample", 1);
    window.wait();
    CHECK_FALSE(window.button("Show folder").isVisible());
    window.form.exportTo(fileOf(folder));
    CHECK(window.button("Stop").isVisible());
    CHECK_FALSE(window.button("Export...").isVisible());
    CHECK_FALSE(window.list("Lowest key").isEnabled());
    CHECK(window.wait() ==
          "2 samples are complete in " + (folder / "Test keyboard").string() + ".");
    CHECK(window.button("Show folder").isVisible());
    CHECK(window.button("Export...").isVisible());
    CHECK(std::filesystem::exists(folder / "Test keyboard" / "Test keyboard.sfz"));
    window.choose("Velocity layers", 3);
    CHECK_THAT(window.wait(), ContainsSubstring("3 samples, "));
    CHECK_FALSE(window.button("Show folder").isVisible());
}

TEST_CASE("An export can be stopped, and goes on while the form is closed") {
    Form window;
    const auto folder = testFolder() / "stopped";
    std::filesystem::create_directories(folder);
    window.choose("Velocity layers", 127);
    window.choose("Level at the end", 120);
    window.form.exportTo(fileOf(folder));
    {
        SampleForm other(window.processor.view());
        other.refresh();
        CHECK(find<juce::Button>(other, "Stop")->isVisible());
    }
    CHECK(window.processor.view().samples.sampleStatus().isExporting());
    RecorderStrip strip(window.processor.view());
    CHECK(find<IconButton>(strip, "Export samples")->getToggleState());
    window.button("Stop").onClick();
    CHECK_THAT(window.wait(), ContainsSubstring("Stopped.") && ContainsSubstring("Test keyboard"));
    strip.refresh();
    CHECK_FALSE(find<IconButton>(strip, "Export samples")->getToggleState());
}

TEST_CASE("The form follows another instrument") {
    Form window;
    restore(window.processor, testState("other"));
    REQUIRE(window.processor.view().presets.loadPreset(factoryPresetId("Steel Plate")));
    window.form.refresh();
    window.choose("What to sample", 2);
    CHECK(window.list("Object to sample").getNumItems() == 1);
    CHECK(window.list("Lowest key").getSelectedId() > 0);
}

TEST_CASE("What is said about an export tells progress, time and errors") {
    SampleStatus status;
    CHECK(SampleForm::sentenceOf(status).isEmpty());
    status = {.stage = SampleStage::estimated, .samples = 305, .seconds = 1860, .megabytes = 1240};
    CHECK(SampleForm::sentenceOf(status) == "305 samples, 31 min of sound in all, about 1.2 GB.");
    status = {.stage = SampleStage::estimated, .samples = 1, .seconds = 0.2, .megabytes = 0.01};
    CHECK(SampleForm::sentenceOf(status) == "1 sample, 1 s of sound in all, about 0.1 MB.");
    status = {.stage = SampleStage::exporting, .progress = 0.421, .folder = "/music/Bell"};
    CHECK(SampleForm::sentenceOf(status) == "Exporting to /music/Bell: 42 %...");
    status.secondsLeft = 200;
    CHECK(SampleForm::sentenceOf(status) == "Exporting to /music/Bell: 42 %, about 3 min left");
    status = {.stage = SampleStage::failed, .sentence = "The disk is full."};
    CHECK(SampleForm::sentenceOf(status) == "The disk is full.");
}

TEST_CASE("The export opens in the window by its button and closes by Escape") {
    const UserSettings user;
    Processor processor;
    const auto window = open(processor);
    auto* form = find<SampleForm>(*window, "Export samples");
    auto* exporting = find<IconButton>(*window, "Export samples");
    auto* picture = find<PageDeck>(*window, "Pages");
    REQUIRE((form != nullptr && exporting != nullptr && picture != nullptr));
    CHECK_FALSE(form->isVisible());
    exporting->onClick();
    CHECK(form->isVisible());
    CHECK_FALSE(picture->isVisible());
    CHECK(form->keyPressed(juce::KeyPress(juce::KeyPress::escapeKey)));
    CHECK_FALSE(form->isVisible());
    CHECK(picture->isVisible());
    exporting->onClick();
    CHECK(window->keyPressed(juce::KeyPress(juce::KeyPress::escapeKey))); // wherever the focus is
    CHECK_FALSE(form->isVisible());
    exporting->onClick();
    exporting->onClick();
    CHECK_FALSE(form->isVisible());
}

TEST_CASE("The form's parts are named and inside it, and do not overlap in the smallest window") {
    const UserSettings user;
    Processor processor;
    const auto window = open(processor);
    window->setSize(WindowSize::minimumWidth, WindowSize::minimumHeight);
    find<IconButton>(*window, "Export samples")->onClick();
    auto* form = find<SampleForm>(*window, "Export samples");
    for (const int source : {1, 2}) {
        find<juce::ComboBox>(*form, "What to sample")
            ->setSelectedId(source, juce::sendNotificationSync);
        std::vector<juce::Rectangle<int>> places;
        visit(*form, [&](juce::Component& part) {
            const bool isControl = dynamic_cast<juce::ComboBox*>(&part) != nullptr ||
                                   dynamic_cast<juce::Button*>(&part) != nullptr;
            if (!isControl || !isOnScreen(part, *window) ||
                dynamic_cast<juce::ComboBox*>(part.getParentComponent()) != nullptr)
                return;
            INFO(part.getTitle());
            CHECK(part.getTitle().isNotEmpty());
            places.push_back(form->getLocalArea(&part, part.getLocalBounds()));
            CHECK(form->getLocalBounds().contains(places.back()));
            CHECK(places.back().getHeight() >= 24);
            for (std::size_t i = 0; i + 1 < places.size(); ++i)
                CHECK_FALSE(places[i].intersects(places.back()));
        });
        CHECK(places.size() == (source == 1 ? 13 : 11)); // with Export and Close
    }
}
