// What a long session in a host brings that validators do not try: crowds of notes and of
// instances, values that are no numbers, a tempo that changes.
#include "Support/Sanitizers.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <unistd.h>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double rateHz = 48000;
constexpr int blockSize = 512;

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

/// [KiB] Of this process, in memory; 0 where the system does not tell.
double residentKibibytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0;
    file >> pages >> pages;
    return file ? pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1024 : 0;
}

} // namespace

TEST_CASE("The motor opens once in every note of the host's tempo, and without one at its speed") {
    constexpr double quarter = 4; // of the choices
    TempoOnly host;
    const auto played = [&](double sync, double speed) {
        Processor processor;
        restore(processor, testState());
        processor.setPlayHead(&host);
        processor.prepareToPlay(rateHz, blockSize);
        processor.changeParameter(ParameterId::motorDepth, 90);
        processor.changeParameter(ParameterId::motorSpeed, speed);
        processor.changeParameter(ParameterId::motorSync, sync);
        return render(processor, 48000, blockSize, testMusic(48000));
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

TEST_CASE("Two hundred notes a second for half a minute: bounded, and silent when it is over") {
    Processor processor;
    processor.prepareToPlay(rateHz, blockSize);
    constexpr int samples = 30 * static_cast<int>(rateHz), spacing = 240;
    juce::MidiBuffer midi;
    std::mt19937 random(11);
    const auto keys = processor.keyRange();
    const auto keyCount = static_cast<unsigned>(keys.highest - keys.lowest + 1);
    for (int stamp = 0; stamp < samples; stamp += spacing) {
        const int note = keys.lowest + static_cast<int>(random() % keyCount);
        midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{90}), stamp);
        midi.addEvent(juce::MidiMessage::noteOff(1, note), stamp + 100);
    }
    const auto sound = render(processor, samples, blockSize, midi);
    const auto middle = sound.begin() + samples / 2;
    const float early = loudest({sound.begin() + samples / 6, middle});
    const float late = loudest({middle, sound.end()});
    CHECK(early > 0.001f);
    CHECK(late < 2 * early); // nothing piles up
    processor.changeParameter(ParameterId::letRing, 0);
    render(processor, 3 * static_cast<int>(rateHz), blockSize, {});
    CHECK(loudest(render(processor, blockSize, blockSize, {})) == 0);
}

TEST_CASE("Automation that is no number or next to none leaves a sound that is finite") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(rateHz, 64);
    const auto music = testMusic(2048, 97);
    using Float = std::numeric_limits<float>;
    for (auto* parameter : processor.getParameters()) {
        for (const float value : {Float::quiet_NaN(), Float::signaling_NaN(), Float::infinity(),
                                  -Float::infinity(), Float::denorm_min(), -Float::denorm_min(),
                                  Float::min(), Float::max(), Float::lowest(), -0.0f}) {
            parameter->setValue(value);
            INFO(parameter->getName(100) << " at " << value);
            REQUIRE(allFinite(render(processor, 2048, 64, music)));
        }
        const float kept = parameter->getValue();
        REQUIRE((kept >= 0 && kept <= 1));
        parameter->setValue(parameter->getDefaultValue());
    }
    processor.reset();
    CHECK(loudest(render(processor, 4096, 64, music)) > 0.001f);
    REQUIRE(parseState(saved(processor)));
}

TEST_CASE("No sample is ever so small that it costs a host time") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(rateHz, blockSize);
    processor.changeParameter(ParameterId::tau, parameterInfo(ParameterId::tau).minimum);
    processor.changeParameter(ParameterId::level, parameterInfo(ParameterId::level).minimum);
    juce::MidiBuffer note;
    note.addEvent(juce::MidiMessage::noteOn(1, lowestTestNote, juce::uint8{1}), 0);
    const auto sound = render(processor, 60 * static_cast<int>(rateHz), blockSize, note);
    int subnormal = 0;
    for (const float sample : sound)
        subnormal += std::fpclassify(sample) == FP_SUBNORMAL ? 1 : 0;
    CHECK(subnormal == 0);
    CHECK(loudest(sound) > 0);
    CHECK(sound.back() == 0);
}

TEST_CASE("Two hundred instances play in one process and share what they can") {
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
        instances.back()->prepareToPlay(rateHz, blockSize);
        REQUIRE(loudest(render(*instances.back(), 2 * blockSize, blockSize, chord)) > 0.001f);
    }
    const double each = (residentKibibytes() - before) / (count - measuredFrom);
    WARN("each further instance takes " << each << " KiB");
    if (!IDIOPHONE_SANITIZED)
        CHECK(each < 16 * 1024);
    const auto& first = instances.front()->loadedInstrument()->slots().front().object;
    for (const auto& instance : instances)
        REQUIRE(instance->loadedInstrument()->slots().front().object == first);
}
