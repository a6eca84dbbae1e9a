// Sound frames for the window, and mutes set in the window.
#include "Support/TestSound.h"

#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Synth/SynthesisSettings.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

namespace {

juce::MidiBuffer note(int number, int velocity = 100) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, number, static_cast<juce::uint8>(velocity)), 0);
    return midi;
}

/// Renders `samples` samples and returns the newest frame.
const SoundFrame* frameAfter(Processor& processor, int samples, const juce::MidiBuffer& midi = {}) {
    processor.view().sound.takeSoundFrame();
    render(processor, samples, 480, midi);
    return processor.view().sound.takeSoundFrame();
}

struct Prepared {
    explicit Prepared(const State& state = testState()) {
        restore(processor, state);
        processor.prepareToPlay(48000, 480);
    }
    Processor processor;
};

constexpr int keys = highestTestNote - lowestTestNote + 1;

} // namespace

TEST_CASE("A frame shows the current state of every mode of the struck object") {
    Prepared prepared;
    auto& processor = prepared.processor;
    const auto* frame = frameAfter(processor, 4800, note(69));
    REQUIRE(frame != nullptr);
    CHECK(frame->object == 69 - lowestTestNote);
    CHECK(frame->note == 69);
    CHECK(frame->instrumentNumber == processor.view().instrument.instrumentNumber());
    REQUIRE(frame->modes.size() == 12);
    CHECK(frame->modesOmitted == 0);
    CHECK(frame->velocity == 100);
    CHECK(std::abs(double(frame->modes[0].frequencyHz) - 440) < 0.01);
    CHECK(std::abs(double(frame->modes[3].frequencyHz) - 440 * std::pow(4, 1.37)) < 0.5);
    // d = 5 + 1e-8 λ, and T60 = 2 ln(1000) / d.
    const double damping = 5 + 1e-8 * std::pow(2 * std::numbers::pi * 440, 2);
    CHECK(std::abs(double(frame->modes[0].t60Seconds) * damping / 2 / std::log(1000) - 1) < 1e-4);
    CHECK(frame->modes[0].standing == ModeStanding::sounding);
    CHECK(frame->modes[0].amplitude > 1e-4f);
    REQUIRE(frame->slots.size() == 1);
    CHECK(frame->slots[0].note == 69);
    CHECK(frame->slots[0].share == frame->slots[0].modesMixed);
    CHECK(frame->modesMixed == frame->slots[0].modesMixed);
    CHECK(frame->modesMixed + frame->modesDropped == 12);
    CHECK(frame->peakLeft > 0);
    CHECK(frame->load >= 0);

    const auto tauStep = processor.view().parameters.value(ParameterId::tau) * pascalsPerTau;
    CHECK(std::abs(frame->tauPascals - tauStep) < 1e-12);
    for (const auto& mode : frame->modes)
        if (mode.standing == ModeStanding::belowTau)
            CHECK(double(mode.amplitude) <= tauStep);
}

TEST_CASE("Size moves the modes of a frame, sounding or not, unless the pitch is kept") {
    Prepared prepared;
    auto& processor = prepared.processor;
    processor.view().sound.watchObject(9);
    processor.view().parameters.change(ParameterId::size, 2);
    const auto* frame = frameAfter(processor, 4800);
    REQUIRE(frame != nullptr);
    CHECK(std::abs(double(frame->modes[0].frequencyHz) - 440) < 0.01);
    processor.view().parameters.change(ParameterId::keepPitch, 0);
    frame = frameAfter(processor, 4800);
    REQUIRE(frame != nullptr);
    CHECK(frame->object == 9);
    CHECK(std::abs(double(frame->modes[0].frequencyHz) - 220) < 0.01);
    CHECK(frame->modes[0].standing == ModeStanding::belowTau);
    CHECK(frame->slots.empty());
}

TEST_CASE("The window chooses the watched object until the instrument changes") {
    Prepared prepared;
    auto& processor = prepared.processor;
    processor.view().sound.watchObject(2);
    CHECK(processor.view().sound.watchedObject() == 2u);
    CHECK(frameAfter(processor, 4800, note(69))->object == 2);
    processor.view().sound.watchObject(std::nullopt);
    CHECK(frameAfter(processor, 4800)->object == 9);
    processor.view().sound.watchObject(1000);
    CHECK(frameAfter(processor, 4800)->object == 9);
    processor.view().sound.watchObject(3);
    restore(processor, testState("other"));
    frameAfter(processor, 4800);
    CHECK(processor.view().sound.watchedObject() == std::nullopt);
    CHECK(frameAfter(processor, 4800, note(62))->object == 2);
}

TEST_CASE("Without sound a silent frame is shown, and no frame comes twice") {
    Processor processor;
    restore(processor, testState());
    const SoundFrame* frame = nullptr;
    for (int ask = 0; ask < 30 && frame == nullptr; ++ask)
        frame = processor.view().sound.takeSoundFrame();
    REQUIRE(frame != nullptr);
    CHECK(frame->modes.size() == 12);
    CHECK(frame->modes[0].amplitude == 0);
    processor.prepareToPlay(48000, 480);
    processor.view().sound.takeSoundFrame();
    CHECK(processor.view().sound.takeSoundFrame() == nullptr);
    CHECK(frameAfter(processor, 4800) != nullptr);
    CHECK(processor.view().sound.takeSoundFrame() == nullptr);
}

TEST_CASE("Watching leaves the sound bit-identical") {
    const auto music = testMusic(48000);
    Prepared plain, watched;
    const auto expected = render(plain.processor, 48000, 480, music);
    HostSound seen;
    int frames = 0;
    watched.processor.view().sound.takeSoundFrame();
    for (int start = 0; start < 48000; start += 480) {
        juce::MidiBuffer block;
        block.addEvents(music, start, 480, -start);
        seen.append(render(watched.processor, 480, 480, block));
        frames += watched.processor.view().sound.takeSoundFrame() != nullptr ? 1 : 0;
    }
    CHECK(seen == expected);
    CHECK(frames >= 20); // one second in steps of 10 ms
    CHECK(frames <= 31);
}

TEST_CASE("A muted mode is silent and saved with the sound, but a solo mode is not saved") {
    Prepared prepared;
    auto& processor = prepared.processor;
    const auto before = saved(processor);
    CHECK(processor.view().sound.muteMode(9, 0, true));
    CHECK(processor.view().sound.hearModeAlone(8, 3, true));
    const auto bytes = saved(processor);
    CHECK(bytes != before);
    const auto state = parseState(bytes);
    REQUIRE(state);
    CHECK(state->preset.mutedModes.size() == 1);
    CHECK(state->preset.mutedModes.contains("69", 0));

    const auto* frame = frameAfter(processor, 4800, note(69));
    CHECK(frame->modes[0].standing == ModeStanding::silenced);
    CHECK(frame->modes[0].isMuted);
    CHECK(frame->modes[1].standing == ModeStanding::sounding);
    frame = frameAfter(processor, 4800, note(68));
    for (std::size_t mode = 0; mode < 12; ++mode) {
        CHECK((frame->modes[mode].standing == ModeStanding::silenced) == (mode != 3));
        CHECK(frame->modes[mode].isHeardAlone == (mode == 3));
    }

    Prepared restored(*state);
    CHECK(frameAfter(restored.processor, 4800, note(69))->modes[0].isMuted);
    CHECK(restored.processor.view().sound.takeSoundFrame() == nullptr);
    frame = frameAfter(restored.processor, 4800, note(68));
    CHECK(frame->modes[0].standing != ModeStanding::silenced);

    processor.view().sound.unmuteModes(9);
    processor.view().sound.hearAllModes(8);
    CHECK(saved(processor) == before);
    frame = frameAfter(processor, 4800, note(69));
    CHECK(frame->modes[0].standing == ModeStanding::sounding);
}

TEST_CASE("Rebuilt players keep mutes and solo modes, but another instrument does not") {
    Prepared prepared;
    auto& processor = prepared.processor;
    processor.view().sound.muteMode(9, 0, true);
    processor.view().sound.hearModeAlone(8, 3, true);
    processor.prepareToPlay(96000, 480);
    CHECK(frameAfter(processor, 9600, note(69))->modes[0].isMuted);
    CHECK(frameAfter(processor, 9600, note(68))->modes[0].standing == ModeStanding::silenced);
    restore(processor, testState());
    CHECK_FALSE(frameAfter(processor, 9600, note(69))->modes[0].isMuted);
    CHECK(frameAfter(processor, 9600, note(68))->modes[0].standing == ModeStanding::sounding);
}

TEST_CASE("An undo that restores a sound does not restore its solo modes") {
    Prepared prepared;
    auto& processor = prepared.processor;
    const bool prepares = GENERATE(false, true);
    processor.view().sound.hearModeAlone(9, 3, true); // before any callback takes it
    REQUIRE(processor.view().presets.loadPreset(factoryPresetId("Wok")));
    processor.windowSession().history.undo();
    if (prepares)
        processor.prepareToPlay(48000, 480);
    const auto* frame = frameAfter(processor, 4800, note(69));
    REQUIRE(frame != nullptr);
    CHECK_FALSE(frame->modes[3].isHeardAlone);
    CHECK(frame->modes[0].standing == ModeStanding::sounding);
}

TEST_CASE("Muting is a step, and its undo and redo change the sound") {
    Prepared prepared;
    auto& processor = prepared.processor;
    processor.view().sound.muteMode(9, 0, true);
    CHECK(processor.windowSession().history.undoName() == "Mute mode");
    processor.windowSession().history.undo();
    const auto* frame = frameAfter(processor, 4800, note(69));
    CHECK_FALSE(frame->modes[0].isMuted);
    CHECK(frame->modes[0].standing == ModeStanding::sounding);
    processor.windowSession().history.redo();
    frame = frameAfter(processor, 4800, note(69));
    CHECK(frame->modes[0].standing == ModeStanding::silenced);
    processor.view().sound.unmuteModes(9);
    processor.windowSession().history.undo();
    CHECK(frameAfter(processor, 4800, note(69))->modes[0].isMuted);
    processor.view().sound.muteMode(9, 99, true); // no such mode, and no step
    CHECK(processor.windowSession().history.redoName() == "Unmute modes");
}

TEST_CASE("Modes and objects that do not exist are not muted") {
    Prepared prepared;
    auto& processor = prepared.processor;
    const auto before = saved(processor);
    CHECK_FALSE(processor.view().sound.muteMode(keys, 0, true));
    CHECK_FALSE(processor.view().sound.muteMode(0, 12, true));
    CHECK_FALSE(processor.view().sound.muteMode(0, -1, true));
    CHECK_FALSE(processor.view().sound.hearModeAlone(0, 12, true));
    processor.view().sound.unmuteModes(keys);
    processor.view().sound.hearAllModes(keys);
    CHECK(saved(processor) == before);
}

TEST_CASE("Muting during sound is repeatable and makes no click") {
    const auto played = [](bool mutes) {
        Prepared prepared;
        HostSound sound;
        for (int block = 0; block < 100; ++block) {
            if (mutes && block >= 20)
                prepared.processor.view().sound.muteMode(9, 1, block / 10 % 2 == 0);
            sound.append(
                render(prepared.processor, 480, 480, block == 0 ? note(69) : juce::MidiBuffer()));
        }
        return sound;
    };
    const auto sound = played(true);
    CHECK(sound == played(true));
    const auto plain = played(false);
    CHECK(sound != plain);
    // A click has a large second difference. Muting must stay below that of the sound itself.
    const auto roughest = [](const std::vector<float>& of) {
        float most = 0;
        for (std::size_t k = 9602; k < of.size(); ++k)
            most = std::max(most, std::abs(of[k] - 2 * of[k - 1] + of[k - 2]));
        return most;
    };
    CHECK(roughest(sound.left) < 1.02f * roughest(plain.left));
}

TEST_CASE("The mode budget is shared among resonators, loudest first") {
    Prepared prepared;
    auto& processor = prepared.processor;
    processor.view().parameters.change(ParameterId::modeBudget,
                                       parameterInfo(ParameterId::modeBudget).minimum);
    processor.view().parameters.change(ParameterId::qualitySlope, 1);
    juce::MidiBuffer chord;
    for (const int key : {60, 62, 64, 65, 67, 69, 71, 72})
        chord.addEvent(juce::MidiMessage::noteOn(1, key, static_cast<juce::uint8>(key)), 0);
    const auto* frame = frameAfter(processor, 4800, chord);
    REQUIRE(frame->slots.size() == 8);
    std::int32_t shared = 0;
    for (std::size_t rank = 0; rank < 8; ++rank) {
        shared += frame->slots[rank].share;
        CHECK(frame->slots[rank].share <= frame->slots[rank].modesRinging);
        if (rank > 0)
            CHECK(frame->slots[rank].amplitude <= frame->slots[rank - 1].amplitude);
    }
    CHECK(double(shared) <= frame->budgetModes);
    double entitled = 0;
    for (const auto& slot : frame->slots)
        entitled += double(slot.entitlement);
    CHECK(std::abs(entitled - frame->budgetModes) < 1e-3);
    CHECK(frame->slots[0].entitlement > frame->slots[7].entitlement);
    CHECK(frame->modesBeyond > 0);
}

TEST_CASE("A drag in the window sounds, and the scraped object is shown") {
    Prepared prepared;
    auto& processor = prepared.processor;
    float loudestSample = 0;
    for (int event = 0; event < 60; ++event) {
        processor.view().instrument.scrapeObject(4, {0.015 * event, 0.5, 0}, 1);
        loudestSample = std::max(loudestSample, loudest(render(processor, 800, 800, {})));
    }
    CHECK(loudestSample > 1e-5f);
    CHECK(frameAfter(processor, 4800)->object == 4);
    processor.view().parameters.change(ParameterId::letRing, 0);
    processor.view().parameters.change(ParameterId::releaseTime, 0.05);
    processor.view().instrument.scrapeObject(4, {}, 0);
    processor.view().instrument.scrapeObject(99, {}, 1);
    render(processor, 48000, 480, {});
    CHECK(loudest(render(processor, 480, 480, {})) < 1e-2f * loudestSample);
}

TEST_CASE("Factory presets have no muted modes, and mutes do not carry over to the next preset") {
    Processor processor;
    processor.prepareToPlay(48000, 480);
    processor.setCurrentProgram(1);
    processor.view().sound.muteMode(0, 0, true);
    processor.setCurrentProgram(2);
    processor.setCurrentProgram(1);
    const auto state = parseState(saved(processor));
    REQUIRE(state);
    CHECK(state->preset.mutedModes.empty());
}
