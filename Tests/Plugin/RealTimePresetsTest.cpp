// No factory preset makes the audio callback allocate, lock or call the system, whatever a user
// does.
#include "Plugin/WatchedHost.h"

#include "Instrument/FactoryContent.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// Holds keys over the whole range for half a second while pressure, controllers and pitch wheel
/// sweep. Then it releases them and lets them ring for 0.1 s.
juce::MidiBuffer heldKeys(const InstrumentView::KeyRange& keys) {
    constexpr int released = 24000, keyCount = 6;
    juce::MidiBuffer midi;
    const auto keyAt = [&](int i) {
        return keys.lowest + (keys.highest - keys.lowest) * i / (keyCount - 1);
    };
    for (int i = 0; i < keyCount; ++i) {
        midi.addEvent(juce::MidiMessage::noteOn(1, keyAt(i), juce::uint8{100}), 700 * i);
        midi.addEvent(juce::MidiMessage::noteOff(1, keyAt(i)), released + 100 * i);
    }
    for (int stamp = 0; stamp < released; stamp += 96) {
        const double phase = 2 * std::numbers::pi * stamp / released;
        const auto sweep = [&](double turns) {
            return static_cast<int>(63.5 - 63.5 * std::cos(turns * phase));
        };
        midi.addEvent(juce::MidiMessage::channelPressureChange(1, sweep(1)), stamp);
        midi.addEvent(
            juce::MidiMessage::aftertouchChange(1, keyAt(stamp / 96 % keyCount), sweep(3)), stamp);
        midi.addEvent(juce::MidiMessage::controllerEvent(1, 1, sweep(1.5)), stamp);
        midi.addEvent(juce::MidiMessage::controllerEvent(1, 74, sweep(2.5)), stamp);
        midi.addEvent(juce::MidiMessage::pitchWheel(1, 129 * sweep(2)), stamp);
    }
    return midi;
}
constexpr int heldKeysSamples = 28800;

void play(WatchedHost& host, const juce::MidiBuffer& midi, int samples, int blockSize) {
    for (int start = 0; start < samples; start += blockSize) {
        juce::MidiBuffer block;
        block.addEvents(midi, start, blockSize, -start);
        host.block(block, blockSize);
    }
}

/// The smallest accepted peaks are low, because some presets are faint.
constexpr float leastStruck = 0.003f, leastPressed = 5e-6f, leastOfStage = 1e-4f;

float loudestOfBlock(WatchedHost& host) {
    host.loudestSample = 0;
    host.stageBlock({}, 240);
    return host.loudestSample;
}

/// Renders until the former sound is faint, so that its beats are not mistaken for the scene. Then
/// starts the scene and renders until it is heard.
void soundStage(WatchedHost& host) {
    float before = loudestOfBlock(host);
    for (int block = 0; block < 4000 && before >= leastOfStage / 4; ++block)
        before = loudestOfBlock(host);
    REQUIRE(before < leastOfStage / 4);
    juce::MidiBuffer notes;
    for (const int note : {72, 74, 77})
        notes.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), note);
    host.block(notes, 240);
    host.loudestSample = 0;
    for (int block = 0; block < 400 && host.loudestSample < leastOfStage; ++block)
        host.stageBlock({}, 240);
    host.checkHeard(leastOfStage);
}

void moveAllWhileStageIsHeard(WatchedHost& host) {
    const auto preset = host.processor.getProgramName(host.processor.getCurrentProgram());
    for (auto* parameter : host.processor.getParameters()) {
        host.what = (preset + ", heard, " + parameter->getName(100)).toStdString();
        if (loudestOfBlock(host) < leastOfStage)
            soundStage(host);
        host.loudestSample = 0;
        const float own = parameter->getValue();
        for (const float end : {0.0f, 1.0f}) {
            parameter->setValue(end);
            host.stageBlock({}, 256);
            host.stageBlock({}, 256);
        }
        parameter->setValue(own);
        // The preset's level and the volume may lower the sound to nothing.
        if (parameter->getName(100) != "Volume")
            host.checkHeard(leastOfStage / 10);
    }
}

} // namespace

TEST_CASE("No factory preset allocates, locks or calls the system, whatever notes are played") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(512);
    for (int program = 0; program < host.processor.getNumPrograms(); ++program) {
        host.choose(program);
        const auto music = testMusic(512, 30, host.processor.view().instrument.keyRange());
        for (int block = 0; block < 40; ++block)
            host.block(music, 512);
        if (!host.processor.view().stage.hasStage()) // the next test covers scenes
            host.checkHeard(leastStruck);
    }
}

TEST_CASE(
    "Strikes and contacts of a scene do not allocate or lock, and call the system only to wake "
    "the worker") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(480);
    const auto presets = factoryPresets();
    for (int program = 0; program < host.processor.getNumPrograms(); ++program) {
        if (presets[static_cast<std::size_t>(program)].keyMap.kind != KeyMapKind::scene)
            continue;
        host.choose(program);
        soundStage(host);
    }
}

TEST_CASE(
    "Strikes, scrapes, rolls and bows with every controller stay real-time safe in every factory "
    "preset") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    struct Way {
        ContactChoice contact;
        double coupling;
        float leastSample;
    };
    WatchedHost host(512);
    for (int program = 0; program < host.processor.getNumPrograms(); ++program) {
        host.choose(program);
        if (host.processor.view().stage.hasStage())
            continue; // bodies of a scene make their own contacts
        const auto midi = heldKeys(host.processor.view().instrument.keyRange());
        for (const auto& way :
             {Way{strikeContact, 0, leastStruck}, Way{scrapeContact, 0, leastPressed},
              Way{rollContact, 0, leastPressed}, Way{rollContact, 100, leastPressed},
              Way{bowContact, 0, leastPressed}}) {
            host.choose(program);
            host.processor.view().parameters.change(ParameterId::contact, way.contact);
            host.processor.view().parameters.change(ParameterId::rollCoupling, way.coupling);
            host.what += ", contact " + std::to_string(way.contact) + ", coupling " +
                         std::to_string(way.coupling);
            play(host, {}, 512, 512); // the former sound fades out
            host.loudestSample = 0;
            play(host, midi, heldKeysSamples, 512);
            host.checkHeard(way.leastSample);
        }
    }
}

TEST_CASE("Every parameter at either end stays real-time safe in every factory preset") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(256);
    for (int program = 0; program < host.processor.getNumPrograms(); ++program) {
        host.choose(program);
        const auto [lowest, highest] = host.processor.view().instrument.keyRange();
        juce::MidiBuffer music;
        for (int i = 0; i < 6; ++i) {
            const int note = lowest + (highest - lowest) * i / 5;
            music.addEvent(juce::MidiMessage::noteOn(i + 1, note, juce::uint8{100}), 40 * i);
            music.addEvent(juce::MidiMessage::channelPressureChange(i + 1, 20 * i), 40 * i + 3);
            music.addEvent(juce::MidiMessage::pitchWheel(i + 1, 3000 * i), 40 * i + 5);
        }
        for (auto* parameter : host.processor.getParameters()) {
            host.what = host.processor.getProgramName(program).toStdString() + ", " +
                        parameter->getName(100).toStdString();
            const float own = parameter->getValue();
            for (const float end : {0.0f, 1.0f}) {
                parameter->setValue(end);
                host.block(music, 256);
                host.block({}, 256);
            }
            parameter->setValue(own);
        }
        if (host.processor.view().stage.hasStage())
            moveAllWhileStageIsHeard(host);
        else
            host.checkHeard(leastStruck);
    }
}

TEST_CASE(
    "Matched loudness while the material moves stays real-time safe in every factory preset") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    const auto materials = choiceNames(ParameterId::material);
    WatchedHost host(256);
    for (int program = 0; program < host.processor.getNumPrograms(); ++program) {
        host.choose(program);
        if (host.processor.view().stage.hasStage())
            continue; // its loudness is not matched
        host.processor.view().parameters.change(ParameterId::matchLoudness, 1);
        const auto music = testMusic(256, 100, host.processor.view().instrument.keyRange());
        for (const char* material : {"Glass", "Plastic"}) {
            const auto choice = std::ranges::find(materials, material) - materials.begin();
            host.processor.view().parameters.change(ParameterId::material,
                                                    static_cast<double>(choice));
            host.what = host.processor.getProgramName(program).toStdString() + " of " + material;
            for (int block = 0; block < 100; ++block) { // 400 cells
                host.block(block % 10 == 0 ? music : juce::MidiBuffer(), 256);
                if (block == 50)
                    host.processor.poll(); // predicts
            }
            host.checkHeard(leastStruck);
        }
    }
}

TEST_CASE(
    "The callback stays real-time safe while modes are watched and muted and objects are scraped") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(512);
    for (int program = 0; program < host.processor.getNumPrograms(); ++program) {
        host.choose(program);
        const bool isStage =
            host.processor.view().stage.hasStage(); // notes would start the scene again
        const auto music = isStage
                               ? juce::MidiBuffer()
                               : testMusic(512, 60, host.processor.view().instrument.keyRange());
        if (isStage)
            soundStage(host);
        host.loudestSample = 0;
        int frames = 0;
        const auto objects = host.processor.view().instrument.playedObjects();
        for (int block = 0; block < 40; ++block) {
            const auto object = static_cast<std::size_t>(block) % objects.size();
            frames += host.processor.view().sound.takeSoundFrame() != nullptr ? 1 : 0;
            host.processor.view().sound.muteMode(object, block % 7, block % 3 != 0);
            host.processor.view().sound.hearModeAlone(object, block % 5, block % 8 == 0);
            if (block % 10 == 0)
                host.processor.view().sound.watchObject(object);
            host.processor.view().instrument.scrapeObject(object, {0.01 * block, 0.002 * block, 0},
                                                          block % 16 == 15 ? 0 : 1);
            host.stageBlock(music, 512);
        }
        CHECK(frames > 5);
        host.checkHeard(isStage ? leastOfStage : leastStruck);
    }
}
