#include "Editor/PresetPhrase.h"

#include "Editor/EditorWindow.h"
#include "Editor/OpenWindow.h"
#include "Editor/WindowParts.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <set>
#include <utility>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// Notes what is played on it.
struct FakeInstrument final : InstrumentView {
    int instrumentNumber() const override { return number; }
    KeyRange keyRange() const override { return {}; }
    std::array<KeySound, 128> keySounds() const override { return sounds; }
    std::vector<PlayedObject> playedObjects() const override {
        return std::vector<PlayedObject>(objects);
    }
    std::vector<std::array<double, 3>> struckPlaces(std::size_t) const override { return {}; }
    bool isFreeToPlay() const override { return isFree; }
    void silence() override {}
    void playNote(int note, int velocity) override {
        played.emplace_back(note, velocity);
        if (velocity > 0)
            held.insert(note);
        else
            held.erase(note);
    }
    void strikeObject(std::size_t, const std::array<double, 3>&, int) override {}
    void scrapeObject(std::size_t, const std::array<double, 3>&, double) override {}

    void setKeys(int from, int to, KeySound sound) {
        for (int note = from; note <= to; ++note)
            sounds[static_cast<std::size_t>(note)] = sound;
    }

    int number = 1;
    std::size_t objects = 0;
    bool isFree = true;
    std::array<KeySound, 128> sounds{};
    std::vector<std::pair<int, int>> played;
    std::multiset<int> held;
};

struct FakeStage final : StageView {
    bool hasStage() const override { return isStage; }
    std::vector<BodyNow> stageBodies() const override { return {}; }
    void pauseStage(bool) override {}
    bool isStagePaused() const override { return false; }
    void resetStage() override {}
    bool hasCaptured() override { return false; }
    bool writeCapture(CaptureKind, const std::filesystem::path&) override { return false; }
    bool isStage = false;
};

FakeInstrument bars(int from, int to) {
    FakeInstrument instrument;
    instrument.setKeys(21, 108, InstrumentView::KeySound::resized);
    instrument.setKeys(from, to, InstrumentView::KeySound::own);
    instrument.objects = static_cast<std::size_t>(to - from + 1);
    return instrument;
}

struct Playing {
    FakeInstrument instrument = bars(65, 108);
    FakeStage stage;
    PresetPhrase phrase{instrument, stage};
};

std::vector<int> keysOf(const std::vector<PhraseNote>& notes) {
    std::vector<int> keys;
    for (const auto& note : notes)
        keys.push_back(note.note);
    return keys;
}

} // namespace

TEST_CASE("The phrase of tuned keys is a rising broken chord about the middle of the range") {
    const auto notes = phraseNotes(bars(65, 108), false);
    CHECK(keysOf(notes) == std::vector{78, 82, 85, 90, 94});
    CHECK(std::ranges::is_sorted(notes, {}, &PhraseNote::startMilliseconds));
    CHECK(notes.back().endMilliseconds == 2000);
    std::set<int> velocities;
    for (const auto& note : notes) {
        CHECK(note.startMilliseconds < note.endMilliseconds);
        velocities.insert(note.velocity);
    }
    CHECK(velocities.size() == notes.size());
    CHECK(*velocities.begin() >= 1);
    CHECK(*velocities.rbegin() <= 127);
}

TEST_CASE("A small range has a smaller chord, and missing bars are replaced by their neighbours") {
    CHECK(keysOf(phraseNotes(bars(60, 72), false)) == std::vector{60, 64, 67, 72});
    CHECK(keysOf(phraseNotes(bars(60, 60), false)) == std::vector{60});
    auto white = bars(60, 72);
    for (const int black : {61, 63, 66, 68, 70})
        white.setKeys(black, black, InstrumentView::KeySound::resized);
    for (const int key : keysOf(phraseNotes(white, false)))
        CHECK(white.keySounds()[static_cast<std::size_t>(key)] == InstrumentView::KeySound::own);
}

TEST_CASE("An object along its keys plays a few of them, a stage one, and silence none") {
    FakeInstrument plate;
    plate.setKeys(36, 96, InstrumentView::KeySound::own);
    plate.objects = 1;
    CHECK(keysOf(phraseNotes(plate, false)) == std::vector{51, 66, 81});
    CHECK(phraseNotes(bars(65, 108), true).size() == 1);
    CHECK(phraseNotes(FakeInstrument(), false).empty());
}

TEST_CASE("Factory presets play chords if they are tuned, single keys or a note otherwise") {
    constexpr int steelPlate = 3, steelRing = 4, vibraphone = 9, dice = 18;
    Processor processor;
    const auto& view = processor.view();
    for (const auto& [program, notes] :
         {std::pair(steelPlate, 3), {steelRing, 5}, {vibraphone, 5}, {dice, 1}}) {
        processor.setCurrentProgram(program);
        CHECK(phraseNotes(view.instrument, view.stage.hasStage()).size() ==
              static_cast<std::size_t>(notes));
    }
}

TEST_CASE("A phrase plays each note once at its time and releases all keys at the end") {
    Playing p;
    p.phrase.play();
    p.phrase.tick(0);
    CHECK(p.instrument.played.empty()); // a held arrow passes over presets
    int heard = 0;
    for (int milliseconds = 0; milliseconds < 3000; milliseconds += 20) {
        p.phrase.tick(milliseconds);
        heard = std::max(heard, static_cast<int>(p.instrument.held.size()));
    }
    CHECK(heard == 5);
    CHECK(p.instrument.held.empty());
    CHECK(p.instrument.played.size() == 10);
    CHECK_FALSE(p.phrase.isPlaying());
}

TEST_CASE("Ticks that come late delay the rest of the phrase and do not bunch its notes") {
    Playing p;
    p.phrase.play();
    p.phrase.tick(2150); // two seconds late
    CHECK(p.instrument.held.size() == 1);
    p.phrase.tick(2380);
    CHECK(p.instrument.held.size() == 1);
    p.phrase.tick(2400);
    CHECK(p.instrument.held.size() == 2);
    for (int milliseconds = 2400; milliseconds < 4400; milliseconds += 20)
        p.phrase.tick(milliseconds);
    CHECK(p.instrument.played.size() == 10);
    CHECK(p.instrument.held.empty());
}

TEST_CASE("A click, another sound, a host's song and another phrase each release the keys") {
    Playing p;
    const auto startsChord = [&] {
        p.phrase.play();
        for (const int milliseconds : {200, 440, 680})
            p.phrase.tick(milliseconds);
        CHECK(p.instrument.held.size() == 3);
    };
    startsChord();
    p.phrase.stop();
    CHECK(p.instrument.held.empty());
    startsChord();
    ++p.instrument.number;
    p.phrase.tick(720);
    CHECK(p.instrument.held.empty());
    startsChord();
    p.instrument.isFree = false;
    p.phrase.tick(720);
    CHECK(p.instrument.held.empty());
    p.phrase.play();
    CHECK_FALSE(p.phrase.isPlaying());
    p.instrument.isFree = true;
    startsChord();
    p.phrase.play();
    CHECK(p.instrument.held.empty());
    CHECK(p.phrase.isPlaying());
}

TEST_CASE("The window is free to play while the host processes and its song rests") {
    struct Host final : juce::AudioPlayHead {
        juce::Optional<PositionInfo> getPosition() const override {
            PositionInfo position;
            position.setIsPlaying(isPlaying);
            position.setBpm(120);
            position.setPpqPosition(0);
            return position;
        }
        bool isPlaying = false;
    } host;
    Processor processor;
    const auto& instrument = processor.view().instrument;
    processor.setPlayHead(&host);
    processor.prepareToPlay(48000, 512);
    for (const bool plays : {false, true, false}) {
        host.isPlaying = plays;
        render(processor, 512, 512, {});
        CHECK(instrument.isFreeToPlay() == !plays);
    }
}

TEST_CASE("Selecting a preset in the browser or by the arrows plays it, if the switch is on") {
    const UserSettings user;
    Processor processor;
    processor.prepareToPlay(48000, 512);
    const auto peak = [&] { return loudest(render(processor, 512, 512, {})); };
    const auto stepTo = [&](juce::AudioProcessorEditor& window, bool inBrowser) {
        processor.reset();
        REQUIRE(peak() == 0); // and the window sees a host that processes
        if (inBrowser)
            find<PresetBrowser>(window, "Preset browser")
                ->keyPressed(juce::KeyPress(juce::KeyPress::downKey));
        else
            find<juce::Button>(window, "Next preset")->onClick();
    };
    {
        const auto window = open(processor);
        stepTo(*window, false);
        runTimersUntil([&] { return peak() > 1e-4f; });
        find<juce::Button>(*window, "Preset")->onClick();
        stepTo(*window, true);
        runTimersUntil([&] { return peak() > 1e-4f; });

        auto* playSwitch = find<juce::ToggleButton>(*window, "Play on selection");
        REQUIRE(playSwitch != nullptr);
        CHECK(playSwitch->getToggleState());
        playSwitch->setToggleState(false, juce::dontSendNotification);
        playSwitch->onClick();
        for (const bool inBrowser : {true, false}) {
            stepTo(*window, inBrowser);
            for (int waited = 0; waited < 400; waited += 20) { // a phrase starts after 150 ms
                juce::Thread::sleep(20);
                juce::Timer::callPendingTimersSynchronously();
                CHECK(peak() == 0);
            }
        }
    }
    CHECK_FALSE(find<juce::ToggleButton>(*open(processor), "Play on selection")->getToggleState());
}
