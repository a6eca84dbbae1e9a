// Callbacks between a request for another sound and its first sample.
#include "Plugin/RealTimeTrap.h"
#include "Support/TestSound.h"

#include "Instrument/FactoryContent.h"
#include "Plugin/ControllerAssignments.h"
#include "Plugin/FactoryPrograms.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <functional>
#include <utility>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr int vibraphone = 9, key = 60;

juce::MidiBuffer programChange(int program) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::programChange(1, program), 0);
    return midi;
}

juce::MidiBuffer struck(int note) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), 0);
    return midi;
}

void pollForProgram(Processor& processor, int program) {
    processor.poll();
    if (processor.getCurrentProgram() != program)
        processor.poll(); // another program was requested during the first poll
    REQUIRE(processor.getCurrentProgram() == program);
}

/// Renders one callback while it receives a parameter change.
struct BusyHost final : juce::AudioProcessorListener {
    explicit BusyHost(std::function<void()> callback) : process(std::move(callback)) {}
    void audioProcessorParameterChanged(juce::AudioProcessor*, int, float) override {
        if (auto once = std::exchange(process, nullptr))
            once();
    }
    void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails&) override {}
    std::function<void()> process;
};

} // namespace

TEST_CASE("A key pressed while the host is notified of a new preset is struck once") {
    enum class Struck { afterwards, whileReported, asSoonAsLoaded };
    const auto played = [](Struck when) {
        Processor processor;
        processor.prepareToPlay(testRateHz, testBlockSize);
        render(processor, testBlockSize, testBlockSize, programChange(vibraphone));
        const double former = processor.view().parameters.value(ParameterId::level);
        HostSound sound;
        const auto strike = [&] {
            sound = render(processor, testBlockSize, testBlockSize, struck(key));
        };
        BusyHost host(when == Struck::whileReported ? strike : std::function<void()>());
        processor.addListener(&host);
        if (when == Struck::asSoonAsLoaded) {
            const AtAllocations look([&] {
                if (sound.left.empty() &&
                    processor.view().parameters.value(ParameterId::level) != former)
                    strike();
            });
            pollForProgram(processor, vibraphone);
        } else {
            pollForProgram(processor, vibraphone);
        }
        processor.removeListener(&host);
        if (sound.left.empty())
            strike();
        sound.append(render(processor, 24000, testBlockSize, {}));
        return sound;
    };
    const auto expected = played(Struck::afterwards);
    REQUIRE(loudest(expected) > 0.001f);
    CHECK((played(Struck::whileReported) == expected));
    CHECK((played(Struck::asSoonAsLoaded) == expected));
}

TEST_CASE("Until the new sound is ready, the former one plays on with its own values") {
    if (!realTimeTrapWorks())
        SKIP("nothing can be done at allocations here");
    auto other = testState("other", 1.5);
    other.parameters.set(ParameterId::size, 150);
    other.parameters.set(ParameterId::material, firstLibraryMaterial + 5);
    other.parameters.set(ParameterId::matchLoudness, 1);
    other.preset.name = "Other";
    const auto bytes = encodeState(other);
    using Load = std::function<void(Processor & processor, const Sound& before)>;
    const Load loads[] = {
        [&](Processor& processor, const Sound&) { restoreBytes(processor, bytes); },
        [](Processor& processor, const Sound&) { processor.setCurrentProgram(vibraphone); },
        [](Processor& processor, const Sound& before) {
            processor.soundSession().playSound(before);
        },
    };
    for (const auto& load : loads) {
        const auto played = [&](bool meanwhile) {
            Processor processor;
            processor.prepareToPlay(testRateHz, 64);
            const auto before = processor.soundSession().loadedSound();
            auto first = testState();
            first.parameters.set(ParameterId::level, -5);
            restore(processor, first);
            render(processor, testBlockSize, 64, struck(64));
            const double former = processor.view().parameters.value(ParameterId::level);
            HostSound sound;
            {
                const AtAllocations look([&] {
                    if (meanwhile && sound.left.empty() &&
                        processor.view().parameters.value(ParameterId::level) != former)
                        sound = render(processor, 64, 64, {});
                });
                load(processor, before);
            }
            REQUIRE(processor.view().parameters.value(ParameterId::level) != former);
            if (sound.left.empty())
                sound = render(processor, 64, 64, {});
            sound.append(render(processor, testBlockSize, 64, {}));
            return sound;
        };
        const auto expected = played(false);
        CHECK(loudest(expected) > 0.001f);
        CHECK((played(true) == expected));
    }
}

TEST_CASE("A key waits for its program through a reset and another preparation") {
    constexpr int wok = 15, silentKey = 40; // a key that the wok lacks
    const std::function<void(Processor&)> resets[] = {
        [](Processor& processor) { processor.reset(); },
        [](Processor& processor) { processor.prepareToPlay(testRateHz, testBlockSize); },
    };
    for (const auto& reset : resets) {
        Processor processor;
        processor.setCurrentProgram(wok);
        processor.prepareToPlay(testRateHz, testBlockSize);
        auto midi = programChange(vibraphone);
        midi.addEvents(struck(silentKey + 5), 0, testBlockSize, 0);
        render(processor, testBlockSize, testBlockSize, midi);
        reset(processor);
        CHECK(loudest(render(processor, testBlockSize, testBlockSize, struck(silentKey))) == 0);
        pollForProgram(processor, vibraphone);
        const auto sound = render(processor, 24000, testBlockSize, {});

        Processor other;
        other.setCurrentProgram(wok);
        other.prepareToPlay(testRateHz, testBlockSize);
        render(other, testBlockSize, testBlockSize, struck(silentKey + 5));
        reset(other);
        render(other, testBlockSize, testBlockSize, {});
        other.setCurrentProgram(vibraphone);
        CHECK(loudest(sound) > 0.001f);
        CHECK(
            (sound == render(other, 24000, testBlockSize, struck(silentKey)))); // and no other key
    }
}

TEST_CASE("A program change that loads before a second preparation strikes no key later") {
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    render(processor, testBlockSize, testBlockSize, programChange(vibraphone));
    pollForProgram(processor, vibraphone);
    processor.prepareToPlay(testRateHz, testBlockSize); // before a callback has taken its player
    render(processor, 4800, testBlockSize, struck(key));
    processor.setCurrentProgram(vibraphone);
    render(processor, 96000, testBlockSize, {}); // the old sound and its room fade out
    CHECK(loudest(render(processor, 4800, testBlockSize, {})) == 0);
}

TEST_CASE("If a program cannot be built, keys that already sound are not struck again") {
    if (!realTimeTrapWorks())
        SKIP("allocations cannot be made to fail here");
    constexpr int note = 72;
    const auto played = [](bool asks) {
        Processor processor;
        processor.prepareToPlay(testRateHz, testBlockSize);
        auto midi = asks ? programChange(vibraphone) : juce::MidiBuffer();
        midi.addEvents(struck(note), 0, testBlockSize, 0);
        auto sound = render(processor, testBlockSize, testBlockSize, midi);
        if (asks) {
            const MemoryLimit limit(20'000);
            processor.poll();
            CHECK(processor.view().status.takeStatus().isError);
            CHECK(processor.getCurrentProgram() == 0);
        }
        sound.append(render(processor, 24000, testBlockSize, {}));
        if (asks) { // a failed program is not loaded later either
            processor.setCurrentProgram(vibraphone);
            render(processor, 96000, testBlockSize, {}); // the room rings on
            CHECK(loudest(render(processor, 4800, testBlockSize, {})) == 0);
        }
        return sound;
    };
    const auto expected = played(false);
    REQUIRE(loudest(expected) > 0.001f);
    CHECK((played(true) == expected));
}

TEST_CASE("After a reset, loudness is matched as after a preparation with the same values") {
    auto state = testState();
    state.parameters.set(ParameterId::matchLoudness, 1);
    const auto change = [](Processor& processor) {
        processor.view().parameters.change(ParameterId::material, firstLibraryMaterial + 5);
        processor.view().parameters.change(ParameterId::mallet, firstRackMallet);
    };
    Processor fresh;
    restore(fresh, state);
    change(fresh);
    fresh.prepareToPlay(testRateHz, testBlockSize);
    const auto expected = render(fresh, 24000, testBlockSize, testMusic(24000));
    REQUIRE(loudest(expected) > 0);

    for (const bool isOffline : {false, true}) {
        Processor processor;
        processor.setNonRealtime(isOffline);
        restore(processor, state);
        processor.prepareToPlay(testRateHz, testBlockSize);
        render(processor, 24000, testBlockSize, testMusic(24000));
        change(processor);
        render(processor, 24000, testBlockSize, testMusic(24000));
        if (!isOffline)
            processor.poll();
        processor.reset();
        CHECK((render(processor, 24000, testBlockSize, testMusic(24000)) == expected));
    }
}

TEST_CASE("A sound loaded with the modulation wheel up keeps its loudness from the start") {
    auto state = testState();
    state.parameters.set(ParameterId::contact, scrapeContact);
    state.parameters.set(ParameterId::material, firstLibraryMaterial + 5);
    const auto played = [&](bool matches) {
        state.parameters.set(ParameterId::matchLoudness, matches ? 1 : 0);
        Processor processor;
        processor.prepareToPlay(testRateHz, testBlockSize);
        juce::MidiBuffer wheel;
        wheel.addEvent(juce::MidiMessage::controllerEvent(1, 1, 120), 0);
        render(processor, testBlockSize, testBlockSize, wheel);
        restore(processor, state);
        return render(processor, 48000, testBlockSize, struck(64)).left;
    };
    const auto plain = played(false), matched = played(true);
    const auto loudestFrom = [](const std::vector<float>& sound, int from) {
        return loudest(std::vector(sound.begin() + from, sound.begin() + from + 480));
    };
    const auto gain = [&](int from) {
        return loudestFrom(matched, from) / loudestFrom(plain, from);
    };
    REQUIRE(std::abs(gain(40000) - 1) > 0.01f);
    CHECK(std::abs(gain(480) / gain(40000) - 1) < 0.001f);
}

TEST_CASE("A state restored after a MIDI program change is the one that plays") {
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    render(processor, testBlockSize, testBlockSize, programChange(9));
    restore(processor, testState());
    const auto name = processor.soundSession().loadedSound().preset.name;
    for (int polls = 0; polls < 6; ++polls)
        processor.poll();
    CHECK(processor.soundSession().loadedSound().preset.name == name);
    render(processor, testBlockSize, testBlockSize, programChange(9)); // a new request still works
    pollForProgram(processor, 9);
}

TEST_CASE("A room silenced by All Sound Off stays silent when another sound is restored") {
    State state = testState();
    state.parameters.set(ParameterId::room, 100);
    Processor processor;
    restore(processor, state);
    processor.prepareToPlay(testRateHz, 64);
    juce::MidiBuffer chord, off;
    chord.addEvent(juce::MidiMessage::noteOn(1, 60, juce::uint8{120}), 0);
    off.addEvent(juce::MidiMessage::allSoundOff(1), 0);
    REQUIRE(loudest(render(processor, 9600, 64, chord)) > 1e-4f);
    render(processor, 64, 64, off);
    state.parameters.set(ParameterId::tune, 3);
    restore(processor, state);
    render(processor, 4800, 64, {});
    CHECK(loudest(render(processor, 4800, 64, {})) < 1e-6f);
}

TEST_CASE("Parameters moved after a program change keep their values, in a bounce and live") {
    constexpr int volumeControl = 7, program = 3;
    using enum ParameterId;
    const auto moved = [](int value, int stamp) {
        return juce::MidiMessage::controllerEvent(1, volumeControl, value).withTimeStamp(stamp);
    };
    const auto change = juce::MidiMessage::programChange(1, program).withTimeStamp(200);
    struct Case {
        std::vector<juce::MidiMessage> inBlock, inNext;
        bool byHost;
        bool staysMoved;
    };
    const Case cases[] = {
        {{change}, {moved(100, 0)}, false, true},
        {{change, moved(100, 201)}, {}, false, true},
        {{change}, {}, true, true},
        {{moved(100, 199), change}, {}, false, false},
        {{change, moved(100, 201), change.withTimeStamp(300)}, {}, false, false},
        {{change}, {}, false, false},
    };
    for (const auto& [inBlock, inNext, byHost, staysMoved] : cases) {
        const auto levelAfter = [&](bool offline, bool wasThere) {
            Processor processor;
            processor.setNonRealtime(offline);
            processor.prepareToPlay(testRateHz, testBlockSize);
            ControllerAssignments assignments;
            assignments[level] = volumeControl;
            processor.windowSession().controllers.assign(assignments);
            const auto block = [&](const std::vector<juce::MidiMessage>& messages) {
                juce::MidiBuffer midi;
                for (const auto& message : messages)
                    midi.addEvent(message, static_cast<int>(message.getTimeStamp()));
                render(processor, testBlockSize, testBlockSize, midi);
            };
            if (wasThere)
                block({moved(100, 0)});
            block(inBlock);
            if (byHost)
                processor.parameters()[level].changeByHand(
                    controlledValue(parameterInfo(level), 100));
            block(inNext);
            pollForProgram(processor, program);
            CHECK(processor.view().parameters.value(malletSpeed) ==
                  factoryPresets()[program].parameters[malletSpeed]);
            return processor.view().parameters.value(level);
        };
        const double expected = staysMoved ? controlledValue(parameterInfo(level), 100)
                                           : factoryPresets()[program].parameters[level];
        for (const bool offline : {false, true})
            for (const bool wasThere : {false, true})
                CHECK(levelAfter(offline, wasThere) == expected);
    }
}

TEST_CASE("Values of another sound loaded while a program is pending do not change the program") {
    constexpr int program = 3;
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    auto other = processor.soundSession().loadedSound(); // the same player with other values
    other.parameters.set(ParameterId::malletSpeed, 4.5);
    const std::function<void()> loads[] = {[&] { processor.setCurrentProgram(vibraphone); },
                                           [&] { processor.soundSession().playSound(other); }};
    for (const auto& load : loads) {
        processor.setCurrentProgram(0);
        render(processor, testBlockSize, testBlockSize, programChange(program));
        load();
        pollForProgram(processor, program);
        CHECK(processor.soundSession().loadedSound().parameters ==
              factoryPresets()[program].parameters);
    }
}

TEST_CASE(
    "A value set after a program change counts even while an earlier program is being built") {
    if (!realTimeTrapWorks())
        SKIP("nothing can be done at allocations here");
    constexpr int volumeControl = 7, program = 3;
    auto overtaking = programChange(program);
    overtaking.addEvent(juce::MidiMessage::controllerEvent(1, volumeControl, 100), 1);
    const auto loaded = [&](int overtakenAt, int last) {
        Processor processor;
        processor.prepareToPlay(testRateHz, testBlockSize);
        ControllerAssignments assignments;
        assignments[ParameterId::level] = volumeControl;
        processor.windowSession().controllers.assign(assignments);
        render(processor, testBlockSize, testBlockSize, programChange(vibraphone));
        int allocations = 0;
        const AtAllocations look([&] {
            if (++allocations == overtakenAt)
                render(processor, testBlockSize, testBlockSize, overtaking);
        });
        pollForProgram(processor, last);
        return std::pair(allocations, processor.view().parameters.value(ParameterId::level));
    };
    const auto [allocations, level] = loaded(0, vibraphone);
    const double moved = controlledValue(parameterInfo(ParameterId::level), 100);
    REQUIRE(level != moved);
    for (const int part : {2, 3, 4})
        CHECK(loaded(allocations / part, program).second == moved);
}

TEST_CASE(
    "Undo after a program change restores the values from before the change, not later ones") {
    constexpr int volumeControl = 7, program = 3;
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    ControllerAssignments assignments;
    assignments[ParameterId::level] = volumeControl;
    processor.windowSession().controllers.assign(assignments);
    const auto before = processor.soundSession().loadedSound().parameters;
    auto midi = programChange(program);
    midi.addEvent(juce::MidiMessage::controllerEvent(1, volumeControl, 20), 1);
    render(processor, testBlockSize, testBlockSize, midi);
    pollForProgram(processor, program);
    CHECK(processor.view().parameters.value(ParameterId::level) != before[ParameterId::level]);
    REQUIRE(processor.windowSession().history.canUndo());
    processor.windowSession().history.undo();
    CHECK(processor.soundSession().loadedSound().parameters == before);
}
