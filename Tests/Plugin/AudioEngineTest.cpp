#include "Plugin/AudioEngine.h"

#include "Plugin/SessionParts.h"

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr int blockSamples = 512;

/// An engine without a session, whose messages the test writes itself.
struct Playing {
    explicit Playing(const Sound& sound = testSound()) {
        parameters.load(sound.parameters);
        engine.prepare(48000, playerOf(sound));
    }

    static std::unique_ptr<Player> playerOf(const Sound& sound) {
        return std::make_unique<Player>(sound.instrument, 48000, sound.preset.surface,
                                        sound.preset.seed, sound.preset.parameters);
    }

    float block(juce::MidiBuffer midi = {}) {
        juce::AudioBuffer<float> buffer(2, blockSamples);
        buffer.clear();
        engine.process({.samples = buffer}, midi, nullptr, false);
        CHECK(midi.isEmpty());
        return buffer.getMagnitude(0, blockSamples);
    }

    BareHost host;
    HostParameters parameters{host};
    EngineMessages messages;
    ProgramChanges programs{2};
    EngineReport report;
    AudioEngine engine{parameters, messages, programs, report};
};

juce::MidiBuffer struck(int note) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), 0);
    return midi;
}

} // namespace

TEST_CASE("The engine plays MIDI notes and notes of the window, and reports its peak") {
    Playing playing;
    CHECK(playing.engine.isPrepared());
    CHECK(playing.block() == 0);
    const float byMidi = playing.block(struck(65));
    CHECK(byMidi > 0);
    CHECK(playing.report.peak >= byMidi);
    CHECK(playing.report.modesMixed > 0);

    Playing byWindow;
    byWindow.messages.window.pushNote(65, 100);
    CHECK(byWindow.block() == byMidi);
}

TEST_CASE("A reset silences the engine and discards what the window has queued") {
    Playing playing;
    playing.block(struck(65));
    playing.messages.window.pushNote(67, 100);
    playing.messages.reset = true;
    CHECK(playing.block() == 0);
    CHECK(playing.block() == 0);
}

TEST_CASE(
    "A player that was handed over plays from the next callback, and the former one is returned") {
    Playing playing;
    const auto other = testSound("other");
    std::weak_ptr<const Instrument> former;
    {
        auto sound = testSound("former");
        former = sound.instrument;
        playing.messages.players.publish(Playing::playerOf(sound));
    }
    playing.block();
    playing.messages.players.publish(Playing::playerOf(other));
    CHECK(playing.block(struck(65)) > 0);
    CHECK_FALSE(former.expired());
    playing.messages.players.collect();
    CHECK(former.expired());
}

TEST_CASE("Values that are being handed over wait for their player") {
    Playing playing;
    playing.block(struck(65));
    const float before = playing.block();
    ++playing.messages.soundChanges;
    playing.parameters[ParameterId::bypass].setExactValue(1);
    for (int i = 0; i < 8; ++i)
        CHECK(playing.block() > before / 100);
    ++playing.messages.soundChanges;
    for (int i = 0; i < 4; ++i)
        playing.block();
    CHECK(playing.block() == 0);
}

TEST_CASE("Keys held since a program change are struck when its player arrives") {
    Playing playing;
    auto midi = juce::MidiBuffer();
    midi.addEvent(juce::MidiMessage::programChange(1, 1), 0);
    midi.addEvent(juce::MidiMessage::noteOn(1, 65, juce::uint8{100}), 1);
    playing.block(midi);
    const auto request = playing.programs.pending();
    CHECK(ProgramChanges::programOf(request) == 1);
    auto player = Playing::playerOf(testSound("other"));
    player->setLabel(request);
    const auto* answering = player.get();
    playing.messages.players.publish(std::move(player));
    playing.block();
    CHECK_FALSE(answering->silent());
}
