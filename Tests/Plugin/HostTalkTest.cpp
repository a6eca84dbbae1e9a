// Hosts that send a value only once, and the thread on which each request takes effect.
#include "Instrument/FactoryContent.h"
#include "Plugin/ListeningHost.h"
#include "Support/TestSound.h"
#include "Support/WaitUntil.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <functional>
#include <memory>
#include <set>
#include <thread>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// Reports a tempo only after a call of `tell`.
class SparingHost final : public juce::AudioPlayHead {
public:
    juce::Optional<PositionInfo> getPosition() const override { return position; }

    void tell(double beatsPerMinute) {
        position.emplace();
        position->setBpm(beatsPerMinute);
    }
    void sayNothing() { position = juce::nullopt; }

private:
    juce::Optional<PositionInfo> position;
};

juce::MidiBuffer programChange(int program, int stamp = 0) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::programChange(1, program), stamp);
    return midi;
}

} // namespace

TEST_CASE("A tempo reported once holds until the next prepare") {
    constexpr double eighth = 6; // index of the choice
    enum class Reports { never, once, always };
    const auto played = [](Reports reports, bool preparesAgain) {
        SparingHost host;
        Processor processor;
        restore(processor, overTubes(testState()));
        processor.setPlayHead(&host);
        processor.prepareToPlay(testRateHz, testBlockSize);
        processor.view().parameters.change(ParameterId::motorDepth, 90);
        processor.view().parameters.change(ParameterId::motorSync, eighth);
        if (reports != Reports::never)
            host.tell(150);
        render(processor, testBlockSize, testBlockSize, {});
        if (reports == Reports::once)
            host.sayNothing();
        if (preparesAgain)
            processor.prepareToPlay(testRateHz, testBlockSize);
        return render(processor, 24000, testBlockSize, testMusic(24000));
    };
    const auto once = played(Reports::once, false);
    CHECK((once == played(Reports::always, false)));
    CHECK((once != played(Reports::never, false)));
    CHECK((played(Reports::once, true) == played(Reports::never, true)));
}

TEST_CASE("A callback leaves the MIDI buffer empty") {
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    juce::AudioBuffer<float> sound(2, testBlockSize);
    auto midi = testMusic(testBlockSize, 50);
    processor.processBlock(sound, midi);
    CHECK(midi.isEmpty());
}

TEST_CASE("A program change in real time loads at the next poll of the message thread") {
    struct Clock final : juce::Timer {
        void timerCallback() override { ++ticks; }
        int ticks = 0;
    } clock;
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    int program = 0;
    while (program < 4) {
        render(processor, testBlockSize, testBlockSize, programChange(++program));
        clock.ticks = 0;
        clock.startTimer(50);
        waitUntil([&] { return processor.getCurrentProgram() == program; },
                  [] { juce::Timer::callPendingTimersSynchronously(); });
        CHECK(clock.ticks <= 2); // polls and ticks are equally frequent
    }
}

TEST_CASE("Offline only the callback loads the program, and in real time only the message thread") {
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    render(processor, testBlockSize, testBlockSize, programChange(2));
    CHECK(processor.getCurrentProgram() == 0);
    processor.setNonRealtime(true);
    pollOften(processor);
    CHECK(processor.getCurrentProgram() == 0);
    render(processor, testBlockSize, testBlockSize, {});
    CHECK(processor.getCurrentProgram() == 2);
}

TEST_CASE(
    "A key pressed after the program change strikes in the new preset and is released there") {
    constexpr int wok = 15, vibraphone = 9, note = 40; // a key that the wok lacks
    const auto struck = [](int stamp) {
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), stamp);
        return midi;
    };
    const auto played = [&](bool asksByMidi, bool isLetGo) {
        Processor processor;
        processor.setCurrentProgram(wok);
        processor.setNonRealtime(true);
        processor.prepareToPlay(testRateHz, testBlockSize);
        juce::MidiBuffer midi;
        if (asksByMidi) {
            midi = programChange(vibraphone, 100);
            midi.addEvents(struck(100), 0, testBlockSize, 0);
            if (isLetGo)
                midi.addEvent(juce::MidiMessage::noteOff(1, note), 300);
        }
        CHECK(loudest(render(processor, testBlockSize, testBlockSize, midi)) == 0);
        if (!asksByMidi)
            processor.setCurrentProgram(vibraphone);
        auto later = asksByMidi ? juce::MidiBuffer() : struck(0);
        later.addEvent(juce::MidiMessage::noteOff(1, note), 4000);
        return render(processor, 24000, testBlockSize, later);
    };
    const auto expected = played(false, false);
    REQUIRE(loudest(expected) > 0.001f);
    CHECK((played(true, false) == expected));
    CHECK(loudest(played(true, true)) == 0);
}

TEST_CASE("The last existing program that MIDI asks for is loaded, and keys wait for it") {
    constexpr int wok = 15, vibraphone = 9, key = 40; // a key that the wok lacks
    REQUIRE(factoryPresets().size() <= 120);
    Processor processor;
    processor.setCurrentProgram(wok);
    processor.prepareToPlay(testRateHz, testBlockSize);
    auto midi = programChange(vibraphone);
    midi.addEvent(juce::MidiMessage::programChange(10, 120), 10);
    midi.addEvent(juce::MidiMessage::noteOn(1, key, juce::uint8{100}), 20);
    render(processor, testBlockSize, testBlockSize, midi);
    processor.setCurrentProgram(wok); // by the host, before the next poll of the message thread
    CHECK(loudest(render(processor, testBlockSize, testBlockSize, {})) == 0);
    processor.poll();
    REQUIRE(processor.getCurrentProgram() == vibraphone);
    CHECK(loudest(render(processor, 4800, testBlockSize, {})) > 0.001f);

    // The key strikes only once: a later load without a MIDI request strikes nothing.
    processor.setCurrentProgram(vibraphone);
    render(processor, 4800, testBlockSize, {}); // the old sound fades out
    processor.reset();
    CHECK(loudest(render(processor, 4800, testBlockSize, {})) == 0);
}

TEST_CASE("A VST3 has the factory presets as programs, and one for any other sound") {
    juce::AudioProcessor::setTypeOfNextNewPlugin(juce::AudioProcessor::wrapperType_VST3);
    Processor processor;
    juce::AudioProcessor::setTypeOfNextNewPlugin(juce::AudioProcessor::wrapperType_Undefined);
    const int presets = static_cast<int>(factoryPresets().size()), own = presets;
    REQUIRE(processor.getNumPrograms() == presets + 1);
    std::set<juce::String> names;
    for (int program = 0; program <= own; ++program) {
        names.insert(processor.getProgramName(program));
        processor.setCurrentProgram(program);
        CHECK(processor.getCurrentProgram() == std::min(program, presets - 1));
    }
    CHECK(names.size() == factoryPresets().size() + 1); // some hosts choose programs by name
    CHECK(names.count({}) == 0);
    CHECK(processor.getProgramName(own + 1).isEmpty());

    // Choosing the current program changes nothing.
    restore(processor, testState());
    CHECK(processor.getCurrentProgram() == own);
    const auto before = saved(processor);
    processor.setCurrentProgram(own);
    CHECK(saved(processor) == before);
    processor.setCurrentProgram(0);
    CHECK(processor.getCurrentProgram() == 0);
}

TEST_CASE("Formats other than VST3 have as many programs as factory presets") {
    Processor processor;
    CHECK(processor.getNumPrograms() == static_cast<int>(factoryPresets().size()));
    restore(processor, testState());
    CHECK(processor.getCurrentProgram() == 0);
}

TEST_CASE("Dampers do not shorten the tail, because a pedal may hold them up") {
    Processor processor;
    auto state = testState();
    state.parameters.set(ParameterId::letRing, 1);
    restore(processor, state);
    const double ringing = processor.getTailLengthSeconds();
    state.parameters.set(ParameterId::letRing, 0);
    state.parameters.set(ParameterId::releaseTime, 0.05);
    restore(processor, state);
    CHECK(processor.getTailLengthSeconds() == ringing);
}

TEST_CASE("Clicks during a pause of the host are not heard afterwards") {
    const auto clicked = [](auto&& pause) {
        Processor processor;
        processor.prepareToPlay(testRateHz, testBlockSize);
        render(processor, testBlockSize, testBlockSize, {});
        for (int impact = 0; impact < 20; ++impact) {
            processor.view().instrument.playNote(72, 100);
            processor.view().instrument.strikeObject(0, {}, 100);
            processor.view().instrument.scrapeObject(0, {}, 1);
        }
        pause(processor);
        return loudest(render(processor, 4800, testBlockSize, {}));
    };
    CHECK(clicked([](Processor&) {}) > 0.001f);
    CHECK(clicked([](Processor& processor) { processor.reset(); }) == 0);
    CHECK(clicked([](Processor& processor) {
              processor.prepareToPlay(testRateHz, testBlockSize);
          }) == 0);
}

TEST_CASE("While no callbacks come, strikes and scrapes are ignored, but releases take effect") {
    constexpr int vibraphone = 9, key = 60;
    constexpr std::size_t bar = 7; // the slot of that key
    Processor processor;
    processor.setCurrentProgram(vibraphone);
    processor.prepareToPlay(testRateHz, testBlockSize);
    const auto soundFor = [&](double seconds, const juce::MidiBuffer& midi = {}) {
        return loudest(
            render(processor, static_cast<int>(seconds * testRateHz), testBlockSize, midi));
    };
    // Another channel taps the key. The bar then rings on only if some channel holds the key.
    const auto ringsOn = [&] {
        juce::MidiBuffer tap;
        tap.addEvent(juce::MidiMessage::noteOn(2, key, juce::uint8{100}), 0);
        tap.addEvent(juce::MidiMessage::noteOff(2, key), 100);
        const float tapped = soundFor(0.1, tap);
        soundFor(1);
        return soundFor(0.1) > 0.05f * tapped;
    };
    const auto pause = [&] {
        waitUntil([&] { return !processor.windowSession().instrument.isProcessing(); },
                  [&] { processor.poll(); });
    };
    const std::function<void(bool)> grips[] = {
        [&](bool isDown) { processor.view().instrument.playNote(key, isDown ? 100 : 0); },
        [&](bool isDown) { processor.view().instrument.strikeObject(bar, {}, isDown ? 100 : 0); },
        [&](bool isDown) { processor.view().instrument.scrapeObject(bar, {}, isDown ? 1 : 0); },
    };
    for (const auto& grip : grips) {
        CHECK_FALSE(ringsOn());
        pause();
        grip(true);
        CHECK_FALSE(ringsOn());
        grip(true); // callbacks have resumed
        CHECK(ringsOn());
        pause();
        grip(false);
        CHECK_FALSE(ringsOn());
    }
}

TEST_CASE("If another thread chooses a program, the message thread reports its values and then the "
          "program") {
    struct Host final : juce::AudioProcessorListener {
        void audioProcessorParameterChanged(juce::AudioProcessor*, int, float) override {
            valuesSent += juce::MessageManager::existsAndIsCurrentThread() ? 1 : 0;
        }
        void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails& details) override {
            if (details.programChanged)
                valuesSentBefore.push_back(valuesSent.load());
        }
        std::atomic<int> valuesSent{0};
        std::vector<int> valuesSentBefore;
    } host;
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    processor.addListener(&host);
    const auto elsewhere = [&] {
        std::thread thread([&] { processor.setCurrentProgram(3); });
        thread.join();
        pollOften(processor);
    };
    processor.setNonRealtime(true);
    elsewhere();
    CHECK(host.valuesSentBefore.empty());
    processor.setNonRealtime(false);
    pollOften(processor);
    constexpr int each = static_cast<int>(parameterCount);
    std::vector expected{each, 2 * each}; // sent twice, for wrappers that pass nothing on at first
    CHECK(host.valuesSentBefore == expected);
    elsewhere();
    processor.setCurrentProgram(5);
    processor.removeListener(&host);
    for (int times = 3; times <= 5; ++times)
        expected.push_back(times * each);
    CHECK(host.valuesSentBefore == expected);
}

TEST_CASE("A plugin made on another thread reports none of its initial values") {
    ListeningHost host(ParameterId::level);
    std::unique_ptr<Processor> processor;
    std::thread thread([&] { processor = std::make_unique<Processor>(); });
    thread.join();
    processor->addListener(&host);
    pollOften(*processor);
    processor->removeListener(&host);
    CHECK(host.heard.empty());
}

TEST_CASE("A parameter that the host moves during a program change is sent to it once more") {
    ListeningHost host(ParameterId::tau);
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    processor.addListener(&host);
    processor.setCurrentProgram(3);
    CHECK(host.heard.size() == 1);
    host.heard.clear();
    auto* tau = processor.getParameters()[static_cast<int>(ParameterId::tau)];
    tau->setValue(0.9f); // like a host that still reads the former values
    pollOften(processor);
    CHECK(host.heard == std::vector{tau->getValue()});
    tau->setValue(0.8f);
    pollOften(processor);
    CHECK(host.heard.size() == 1);
    processor.removeListener(&host);
}
