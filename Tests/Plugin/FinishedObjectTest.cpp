#include "Plugin/FinishedObject.h"

#include "Support/ImportedFiles.h"
#include "Support/RecordedStrike.h"
#include "Support/TestSound.h"

#include <atomic>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::vector<Tone> tones{{440, 6, 0.4}, {1210, 11, 0.25}, {2370, 17, 0.15}};

} // namespace

TEST_CASE("A recording that is opened plays over the keys, with its own modes") {
    for (const auto* name : {"strike.wav", "strike.flac"}) {
        Processor processor;
        auto& workshop = processor.view().workshop;
        const auto file = recordedStrike(name, tones);
        CHECK(workshop.canOpen(file));
        workshop.openFile(file);
        finish(processor);
        const auto status = workshop.importStatus();
        INFO(status.error);
        REQUIRE(status.stage == ImportStatus::Stage::done);
        CHECK_THAT(status.notes, ContainsSubstring("The modes hold"));
        const auto& object = *processor.soundSession().instrument()->slots().front().object;
        for (const auto& [hz, decay, amplitude] : tones) {
            std::size_t nearest = 0;
            for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
                if (std::abs(object.dampedFrequencyHz(mode) - hz) <
                    std::abs(object.dampedFrequencyHz(nearest) - hz))
                    nearest = mode;
            CHECK(object.dampedFrequencyHz(nearest) == Approx(hz).epsilon(1e-3));
            CHECK(object.decayPerSecond(nearest) == Approx(decay).epsilon(0.1));
        }
        CHECK(workshop.keyLayout() == KeyLayout::scaled);
        CHECK_FALSE(workshop.canAnalyseAgain()); // there is no mesh of what was struck
        processor.prepareToPlay(48000, 480);
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, 69, juce::uint8(100)), 10);
        CHECK(loudest(render(processor, 9600, 480, midi)) > 0.01f);
    }
}

TEST_CASE("A file that is no recording of a strike is refused, and its fault named") {
    Processor processor;
    for (const auto& [name, bytes] :
         {std::pair{"text.wav", "no sound"}, {"empty.flac", ""}, {"cut.aiff", "FORM"}}) {
        processor.view().workshop.openFile(writtenFile(name, bytes));
        finish(processor);
        const auto status = processor.view().workshop.importStatus();
        CHECK(status.stage == ImportStatus::Stage::failed);
        CHECK_THAT(status.error, ContainsSubstring(name));
    }
}

TEST_CASE("The fit of a recording can be cancelled") {
    const std::atomic cancelled = true;
    const auto object = finishedObject(recordedStrike("strike.wav", tones),
                                       {.progress = {}, .cancelled = &cancelled});
    REQUIRE_FALSE(object);
    CHECK(isCancellation(object.error()));
}
