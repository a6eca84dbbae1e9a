// Long host sessions beyond what validators try: many notes, many instances, values that are not
// numbers, and a changing tempo.
#include "Support/Level.h"
#include "Support/ResidentMemory.h"
#include "Support/Sanitizers.h"
#include "Support/TestSound.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

namespace {

class TempoOnly final : public juce::AudioPlayHead {
public:
    juce::Optional<PositionInfo> getPosition() const override {
        PositionInfo position;
        if (beatsPerMinute)
            position.setBpm(*beatsPerMinute);
        return position;
    }
    std::optional<double> beatsPerMinute;
};

/// Returns whether this thread flushes subnormal results to zero.
bool flushesSubnormals() {
    volatile float small = std::numeric_limits<float>::min(); // hidden from the optimiser
    return small * 0.5f == 0;
}

/// Checks the floating-point mode inside the processor's callback, which asks for the position.
class FloatingPointWitness final : public juce::AudioPlayHead {
public:
    juce::Optional<PositionInfo> getPosition() const override {
        ++asked;
        flushed += flushesSubnormals() ? 1 : 0;
        return {};
    }
    mutable int asked = 0, flushed = 0;
};

} // namespace

TEST_CASE(
    "The motor opens once per note of the host's tempo, or at its own speed without a tempo") {
    constexpr double quarter = 4; // index of the choice
    TempoOnly host;
    const auto played = [&](double sync, double speed) {
        Processor processor;
        restore(processor, overTubes(testState()));
        processor.setPlayHead(&host);
        processor.prepareToPlay(testRateHz, testBlockSize);
        processor.view().parameters.change(ParameterId::motorDepth, 90);
        processor.view().parameters.change(ParameterId::motorSpeed, speed);
        processor.view().parameters.change(ParameterId::motorSync, sync);
        return render(processor, 48000, testBlockSize, testMusic(48000));
    };
    host.beatsPerMinute = 150;
    CHECK(played(quarter, 3) == played(freeMotor, 150.0 / 60 / 2));
    host.beatsPerMinute = 90;
    CHECK(played(quarter, 3) == played(freeMotor, 90.0 / 60 / 2));
    CHECK(played(quarter, 3) != played(freeMotor, 3));
    for (const auto none : {std::optional<double>{}, std::optional(0.0), std::optional(-3.0),
                            std::optional(std::numeric_limits<double>::quiet_NaN()),
                            std::optional(std::numeric_limits<double>::infinity())}) {
        host.beatsPerMinute = none;
        CHECK(played(quarter, 3) == played(freeMotor, 3));
    }
}

TEST_CASE("A parameter that moves within a callback acts from the next one on") {
    struct Moving final
        : juce::AudioPlayHead { // the callback asks for the position after it takes the values
        juce::Optional<PositionInfo> getPosition() const override {
            if (moves)
                processor.view().parameters.change(ParameterId::level, -60);
            return {};
        }
        explicit Moving(Processor& moved) : processor(moved) {}
        Processor& processor;
        bool moves = false;
    };
    constexpr int longBlock = 8192; // many pieces
    const auto played = [&](bool moves) {
        Processor processor;
        Moving host(processor);
        restore(processor, testState());
        processor.setPlayHead(&host);
        processor.prepareToPlay(testRateHz, longBlock);
        const auto music = testMusic(longBlock);
        render(processor, longBlock, longBlock, music);
        host.moves = moves;
        const auto first = render(processor, longBlock, longBlock, music);
        return std::pair(first, render(processor, longBlock, longBlock, music).left.back());
    };
    const auto still = played(false), moved = played(true);
    CHECK((moved.first == still.first));
    REQUIRE(still.second != 0);
    CHECK(std::abs(moved.second) < 0.01f * std::abs(still.second));
}

TEST_CASE("Two hundred notes a second for 30 s stay bounded, and silence follows") {
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    constexpr int samples = 30 * static_cast<int>(testRateHz), spacing = 240;
    juce::MidiBuffer midi;
    std::mt19937 random(11);
    const auto keys = processor.view().instrument.keyRange();
    const auto keyCount = static_cast<unsigned>(keys.highest - keys.lowest + 1);
    for (int stamp = 0; stamp < samples; stamp += spacing) {
        const int note = keys.lowest + static_cast<int>(random() % keyCount);
        midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{90}), stamp);
        midi.addEvent(juce::MidiMessage::noteOff(1, note), stamp + 100);
    }
    const auto sound = render(processor, samples, testBlockSize, midi).left;
    const auto levelDb = [&](int fromSecond) {
        constexpr auto second = static_cast<std::size_t>(testRateHz);
        const auto from = static_cast<std::size_t>(fromSecond) * second;
        return 20 * std::log10(rms(std::span(sound).subspan(from, 10 * second)));
    };
    REQUIRE(allFinite({sound, {}}));
    REQUIRE(processor.engineReport().notFinite == 0);
    CHECK(levelDb(0) > -60);
    INFO(levelDb(0) << " dB, " << levelDb(10) << " dB, " << levelDb(20) << " dB");
    CHECK(std::abs(levelDb(10) - levelDb(0)) < 0.5); // no notes or memory accumulate
    CHECK(std::abs(levelDb(20) - levelDb(10)) < 0.5);
    processor.view().parameters.change(ParameterId::letRing, 0);
    render(processor, 3 * static_cast<int>(testRateHz), testBlockSize, {});
    CHECK(loudest(render(processor, testBlockSize, testBlockSize, {})) == 0);
}

TEST_CASE("Automation with NaN, infinite or extreme values leaves the sound finite") {
    Processor processor; // its channels differ
    processor.prepareToPlay(testRateHz, 64);
    const auto music = testMusic(2048, 97, processor.view().instrument.keyRange());
    using Float = std::numeric_limits<float>;
    for (auto* parameter : processor.getParameters()) {
        for (const float value : {Float::quiet_NaN(), Float::signaling_NaN(), Float::infinity(),
                                  -Float::infinity(), Float::denorm_min(), -Float::denorm_min(),
                                  Float::min(), Float::max(), Float::lowest(), -0.0f}) {
            parameter->setValue(value);
            INFO(parameter->getName(100) << " at " << value);
            REQUIRE(allFinite(render(processor, 2048, 64, music)));
            REQUIRE(processor.engineReport().notFinite == 0);
        }
        const float kept = parameter->getValue();
        REQUIRE((kept >= 0 && kept <= 1));
        parameter->setValue(parameter->getDefaultValue());
    }
    processor.reset();
    CHECK(loudest(render(processor, 4096, 64, music)) > 0.001f);
    REQUIRE(parseState(saved(processor)));
}

TEST_CASE("Subnormals are flushed in a callback, and the host's own mode returns afterwards") {
    FloatingPointWitness witness;
    Processor processor;
    processor.setPlayHead(&witness);
    processor.prepareToPlay(testRateHz, testBlockSize);
    REQUIRE_FALSE(flushesSubnormals());
    render(processor, 10 * testBlockSize, testBlockSize, {});
    CHECK(witness.asked == 10);
    CHECK(witness.flushed == witness.asked);
    CHECK_FALSE(flushesSubnormals());
}

TEST_CASE("The faintest sound in the longest room tail ends in silence") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(testRateHz, testBlockSize);
    for (const auto parameter : {ParameterId::tau, ParameterId::level})
        processor.view().parameters.change(parameter, parameterInfo(parameter).minimum);
    for (const auto parameter : {ParameterId::room, ParameterId::roomDecay})
        processor.view().parameters.change(parameter, parameterInfo(parameter).maximum);
    juce::MidiBuffer note;
    note.addEvent(juce::MidiMessage::noteOn(1, lowestTestNote, juce::uint8{1}), 0);
    const auto sound = render(processor, 60 * static_cast<int>(testRateHz), testBlockSize, note);
    CHECK(loudest(sound) > 0);
    CHECK(sound.left.back() == 0);
    CHECK(sound.right.back() == 0);
}

TEST_CASE("Two hundred instances play in one process and share their objects") {
    constexpr int count = 200, measuredFrom = 20;
    std::vector<std::unique_ptr<Processor>> instances;
    juce::MidiBuffer chord;
    for (const int note : {72, 79, 84})
        chord.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), 0);
    double before = 0;
    for (int i = 0; i < count; ++i) {
        if (i == measuredFrom)
            before = residentKibibytes();
        instances.push_back(std::make_unique<Processor>());
        instances.back()->prepareToPlay(testRateHz, testBlockSize);
        REQUIRE(loudest(render(*instances.back(), 2 * testBlockSize, testBlockSize, chord)) >
                0.001f);
    }
    const double each = (residentKibibytes() - before) / (count - measuredFrom);
    WARN("each further instance takes " << each << " KiB");
    if (!IDIOPHONE_SANITIZED) // 88 keys with one bank each
        CHECK(each < 9 * 1024);
    const auto& first = instances.front()->soundSession().instrument()->slots().front().object;
    for (const auto& instance : instances)
        REQUIRE(instance->soundSession().instrument()->slots().front().object == first);
}

TEST_CASE("A plugin may be destroyed on a host thread while the message thread polls it") {
    struct Host final : juce::AudioProcessorListener {
        void audioProcessorParameterChanged(juce::AudioProcessor*, int, float) override {
            isPolled = true;
            isPolled.notify_all();
        }
        void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails&) override {}
        std::atomic<bool> isPolled{false};
    };
    std::atomic<bool> isOver{false};
    std::thread host([&] {
        for (int time = 0; time < 40; ++time) {
            Host listener;
            Processor processor;
            processor.addListener(&listener);
            processor.prepareToPlay(48000, 256);
            juce::MidiBuffer program;
            program.addEvent(juce::MidiMessage::programChange(1, 9), 0);
            render(processor, 256, 256, program); // the next poll loads it
            listener.isPolled.wait(false);        // the poll is still running
        }
        isOver = true;
    });
    while (!isOver) {
        juce::Timer::callPendingTimersSynchronously();
        std::this_thread::yield();
    }
    host.join();
}
