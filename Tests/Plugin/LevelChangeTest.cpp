// Changes between sounds whose levels are tens of decibels apart. The change must never be louder
// than the two sounds by themselves.
#include "Instrument/FactoryContent.h"
#include "Plugin/HistorySteps.h"
#include "Support/Level.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <functional>
#include <utility>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

constexpr int blockSize = 256;
constexpr int shortly = 20 * blockSize; // every fade is over by then
constexpr int note = 65;

juce::MidiBuffer strike(int stamp = 0) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), stamp);
    return midi;
}

/// Returns a sound with this level parameter. Its shapes compensate the level, so that all sounds
/// are about equally loud.
State soundOf(const std::string& folder, double levelDb, double roomPercent) {
    auto state = testState(folder);
    const auto gain = static_cast<float>(0.2 * std::pow(10, -levelDb / 40));
    state.objects.clear();
    for (int key = lowestTestNote; key <= highestTestNote; ++key) {
        auto object = syntheticObject({440 * std::exp2((key - 69) / 12.0), 1300}, {gain, gain});
        object.name = folder + std::to_string(key);
        state.objects.push_back(
            {.name = folder + "/" + std::to_string(key), .modal = encodeModalObject(object)});
    }
    auto& values = state.preset.parameters;
    values.set(strikeSpread, 0);
    values.set(level, levelDb);
    values.set(room, roomPercent);
    values.set(roomDecay, 3);
    state.parameters = values;
    return state;
}

/// Returns the peak of a strike with one sound alone.
float aloneWhere(const std::function<void(Processor&)>& load) {
    Processor processor;
    load(processor);
    processor.prepareToPlay(testRateHz, blockSize);
    return loudest(render(processor, shortly, blockSize, strike()));
}

/// Returns the peak of the last 2400 samples of both channels.
float atEndOf(const HostSound& sound) {
    return std::max(peak(std::span(sound.left).last(2400)),
                    peak(std::span(sound.right).last(2400)));
}

int programOf(const std::string& name) {
    const int program = factoryProgram(factoryPresetId(name));
    REQUIRE(program >= 0);
    return program;
}

/// The margin of 3 dB is for beats and the room.
constexpr float margin = 1.4f;

} // namespace

TEST_CASE("A change of level in either direction is never louder than the two sounds alone") {
    const auto [before, after] =
        GENERATE(std::pair{-55.0, 5.3}, std::pair{5.3, -41.0}, std::pair{-41.0, -55.0});
    const double roomPercent = GENERATE(0.0, 80.0);
    CAPTURE(before, after, roomPercent);
    const auto former = soundOf("former", before, roomPercent),
               next = soundOf("next", after, roomPercent);
    const auto alone = [](const State& state) {
        return aloneWhere([&](Processor& processor) { restore(processor, state); });
    };
    const float formerAlone = alone(former), nextAlone = alone(next);
    REQUIRE(formerAlone > 1e-4f);
    REQUIRE(nextAlone > 1e-4f);

    Processor processor;
    restore(processor, former);
    processor.prepareToPlay(testRateHz, blockSize);
    SECTION("nothing rings") {
        render(processor, shortly, blockSize, {});
        restore(processor, next);
        const float heard = loudest(render(processor, shortly, blockSize, strike()));
        CHECK(heard <= margin * nextAlone);
        CHECK(heard >= nextAlone / margin);
    }
    SECTION("the former sound rings") {
        const auto ringing = render(processor, shortly, blockSize, strike());
        const float last = atEndOf(ringing);
        restore(processor, next);
        CHECK(loudest(render(processor, shortly, blockSize, {})) <= margin * last);
        CHECK(loudest(render(processor, shortly, blockSize, strike())) <=
              margin * (nextAlone + last));
    }
    SECTION("the former sound rings, and the next is struck at once") {
        const auto ringing = render(processor, shortly, blockSize, strike());
        const float last = atEndOf(ringing);
        restore(processor, next);
        const float heard = loudest(render(processor, shortly, blockSize, strike()));
        CHECK(heard <= margin * (nextAlone + last));
        CHECK(heard >= (nextAlone - last) / margin);
    }
    SECTION("the former sound rings, and automation sets the level back at once") {
        const auto ringing = render(processor, shortly, 32, strike());
        const float last = atEndOf(ringing);
        restore(processor, next);
        float heard = loudest(render(processor, 32, 32, {}));
        processor.view().parameters.change(level, before);
        heard = std::max(heard, loudest(render(processor, shortly, 32, {})));
        CHECK(heard <= margin * last);
    }
    SECTION("two changes within a block, and a third one while the first fades") {
        const auto ringing = render(processor, shortly, blockSize, strike());
        const float last = atEndOf(ringing);
        restore(processor, next);
        render(processor, 64, 64, {});
        restore(processor, soundOf("third", before, roomPercent));
        render(processor, 64, 64, {});
        restore(processor, next);
        CHECK(loudest(render(processor, shortly, blockSize, {})) <= margin * last);
    }
    SECTION("comparison with B, undo and redo") {
        auto& history = processor.windowSession().history;
        const auto sound = [&](const State& state) {
            auto built = buildInstrument(state.preset.keyMap, state.objects);
            REQUIRE(built);
            return Sound{.preset = state.preset,
                         .instrument = *built,
                         .parameters = state.parameters,
                         .stored = state.parameters};
        };
        processor.windowSession().variants.compare(); // A and B are equal
        history.record("Load", [&] { processor.soundSession().playSound(sound(next)); });
        float allowed = nextAlone;
        bool playsNext = true;
        const auto goOver = [&](const std::function<void()>& change) {
            const auto ringing = render(processor, shortly, blockSize, strike());
            const float last = atEndOf(ringing);
            change();
            playsNext = !playsNext;
            allowed = playsNext ? nextAlone : formerAlone;
            CHECK(loudest(render(processor, shortly, blockSize, strike())) <=
                  margin * (allowed + last));
        };
        goOver([&] { processor.windowSession().variants.compare(); });
        goOver([&] { processor.windowSession().variants.compare(); });
        goOver([&] { history.undo(); });
        goOver([&] { history.redo(); });
    }
}

TEST_CASE("Many parameters that change at once make neither ringing nor struck sound louder") {
    // A soft mallet at a high level, and a hard mallet at a low level.
    auto state = testState();
    state.preset.parameters.set(strikeSpread, 0);
    state.parameters = state.preset.parameters;
    Processor processor;
    restore(processor, state);
    processor.prepareToPlay(testRateHz, blockSize);
    auto loud = state.parameters, soft = state.parameters;
    loud.set(malletHardness, 20000);
    loud.set(level, -40);
    soft.set(malletHardness, 1);
    soft.set(level, 0);
    const auto alone = [&](const ParameterValues& values) {
        auto own = state;
        own.parameters = values;
        return aloneWhere([&](Processor& fresh) { restore(fresh, own); });
    };
    const std::array values{loud, soft};
    const std::array most{alone(loud), alone(soft)};
    auto& history = processor.windowSession().history;
    const auto change = [&](std::size_t to) {
        processor.soundSession().changeParameters(processor.soundSession().loadedSound(),
                                                  values[to]);
    };
    history.record("First", [&] { change(0); });
    processor.windowSession().variants.compare();
    history.record("Second", [&] { change(1); });
    std::size_t playing = 1;
    const auto goOver = [&](const std::function<void()>& step) {
        const auto ringing = render(processor, shortly, blockSize, strike());
        const float last = atEndOf(ringing);
        step();
        playing = 1 - playing;
        CHECK(loudest(render(processor, shortly, blockSize, strike())) <=
              margin * (most[playing] + last));
    };
    for (int time = 0; time < 2; ++time) {
        goOver([&] { processor.windowSession().variants.compare(); });
        goOver([&] { processor.windowSession().variants.compare(); });
        goOver([&] { history.undo(); }); // the second comparison
        goOver([&] { history.redo(); });
        goOver([&] { change(0); });
        goOver([&] { change(1); });
    }
}

TEST_CASE("Factory presets tens of decibels apart are no louder in sequence than alone") {
    struct Pair {
        const char *former, *next;
    };
    const auto [former, next] =
        GENERATE(Pair{"Wooden Table", "Marimba"}, Pair{"Stones", "Marimba"},
                 Pair{"Wooden Table", "Tubular Bells"}, Pair{"Marimba", "Wooden Table"},
                 Pair{"Tubular Bells", "Wooden Table"});
    CAPTURE(former, next);
    const auto struck = [](Processor& processor, int stamp = 0) {
        const auto keys = processor.view().instrument.keyRange();
        juce::MidiBuffer midi;
        midi.addEvent(
            juce::MidiMessage::noteOn(1, (keys.lowest + keys.highest) / 2, juce::uint8{100}),
            stamp);
        return midi;
    };
    const auto playing = [&](const char* name) {
        auto processor = std::make_unique<Processor>();
        processor->setNonRealtime(true);
        processor->setCurrentProgram(programOf(name));
        processor->prepareToPlay(testRateHz, blockSize);
        return processor;
    };
    const auto freshly = playing(next);
    const auto key = struck(*freshly);
    const float nextAlone = loudest(render(*freshly, shortly, blockSize, key));

    SECTION("chosen by the host and struck at once") {
        const auto processor = playing(former);
        render(*processor, shortly, blockSize, {});
        processor->setCurrentProgram(programOf(next));
        CHECK(loudest(render(*processor, shortly, blockSize, key)) <= margin * nextAlone);
    }
    SECTION("chosen by the host while the former preset rings") {
        const auto processor = playing(former);
        const auto ringing = render(*processor, shortly, blockSize, struck(*processor));
        const float last = atEndOf(ringing);
        processor->setCurrentProgram(programOf(next));
        CHECK(loudest(render(*processor, shortly, blockSize, {})) <= margin * last);
    }
    SECTION("asked for by MIDI at the sample of the note, offline") {
        const auto processor = playing(former);
        const auto own = struck(*processor);
        const float formerAlone =
            loudest(render(*playing(former), shortly, blockSize, struck(*freshly)));
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::programChange(1, programOf(next)), 1000);
        midi.addEvents(struck(*freshly, 1000), 0, -1, 0);
        CHECK(loudest(render(*processor, shortly, blockSize, midi)) <=
              margin * (nextAlone + formerAlone));
    }
}

TEST_CASE("A scene that rings in its room gets no louder when a preset of a higher level loads") {
    Processor processor;
    processor.setNonRealtime(true);
    processor.setCurrentProgram(programOf("Thrown Shells"));
    processor.prepareToPlay(testRateHz, blockSize);
    juce::MidiBuffer thrown;
    thrown.addEvent(juce::MidiMessage::noteOn(1, processor.view().instrument.keyRange().lowest,
                                              juce::uint8{120}),
                    0);
    const auto scene = render(processor, 2 * static_cast<int>(testRateHz), blockSize, thrown);
    const float last = atEndOf(scene);
    REQUIRE(last > 1e-3f);
    processor.setCurrentProgram(programOf("Wooden Table"));
    CHECK(loudest(render(processor, shortly, blockSize, {})) <= margin * last);
}

TEST_CASE("A change of values alone stops neither a scrape nor the moving bodies of a scene") {
    Processor processor;
    processor.setNonRealtime(true);
    processor.prepareToPlay(testRateHz, blockSize);
    const auto heardAfter = [&](double levelChangeDb) {
        const int number = processor.view().instrument.instrumentNumber();
        auto values = processor.soundSession().loadedSound().parameters;
        values.set(level, values[level] + levelChangeDb);
        SECTION("by comparison or undo") {
            auto sound = processor.soundSession().loadedSound();
            sound.parameters = values;
            REQUIRE(processor.soundSession().playSound(sound));
        }
        SECTION("by a mutation") {
            processor.soundSession().changeParameters(processor.soundSession().loadedSound(),
                                                      values);
        }
        CHECK(processor.soundSession().loadedSound().parameters[level] == values[level]);
        CHECK(processor.view().instrument.instrumentNumber() == number);
        render(processor, shortly, blockSize, {});
        return loudest(render(processor, static_cast<int>(testRateHz), blockSize, {}));
    };
    SECTION("scraped") {
        auto state = testState();
        state.preset.parameters.set(contact, scrapeContact);
        state.preset.parameters.set(level, 0);
        state.parameters = state.preset.parameters;
        restore(processor, state);
        const float before = loudest(render(processor, shortly, blockSize, strike()));
        REQUIRE(before > 0);
        CHECK(heardAfter(-10) > before / 20);
    }
    SECTION("in a scene") {
        processor.setCurrentProgram(programOf("Falling Cylinder"));
        juce::MidiBuffer dropped;
        dropped.addEvent(juce::MidiMessage::noteOn(1, processor.view().instrument.keyRange().lowest,
                                                   juce::uint8{90}),
                         0);
        render(processor, static_cast<int>(testRateHz), blockSize, dropped);
        CHECK(heardAfter(20) > 1e-4f);
    }
}
