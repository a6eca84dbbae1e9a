// Tests how an MTS-ESP master tunes the keys. This program defines the client's functions itself,
// so that it is its own session.
#include "Plugin/RealTimeTrap.h"
#include "Support/PoleFit.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <fstream>
#include <libMTSClient.h>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;

struct MTSClient {};

namespace {

constexpr double sampleRateHz = 48000;
constexpr int blockSize = 24000, struckNote = 69;

struct Session {
    bool hasMaster = false;
    std::array<double, 128> semitones{};
    std::bitset<128> filtered;
    int clients = 0;
} session;

/// The session has a master while this object lives.
struct Master {
    Master() { begin(true); }
    ~Master() { begin(false); }

private:
    static void begin(bool hasMaster) {
        const int clients = session.clients;
        session = Session();
        session.hasMaster = hasMaster;
        session.clients = clients;
    }
};

struct Instance {
    Instance() {
        restore(processor, testState());
        processor.prepareToPlay(sampleRateHz, blockSize);
    }

    /// Renders one block under the trap, with note 69 struck at its start.
    void strike() {
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, struckNote, juce::uint8{100}), 0);
        const auto faults = faultsOf([&] { processor.processBlock(sound, midi); });
        if (realTimeTrapWorks()) {
            CHECK(faults.allocations == 0);
            CHECK(faults.locks == 0);
        }
        if (systemCallTrapWorks())
            CHECK(faults.systemCalls == 0);
    }

    bool soundsAt(double hertz) {
        strike();
        const std::span<const float> left(sound.getReadPointer(0), blockSize);
        return std::abs(cents(fitPole(left, sampleRateHz, hertz, 0.05).frequencyHz, hertz)) < 0.5;
    }

    bool isSilent() {
        processor.reset();
        strike();
        return sound.getMagnitude(0, blockSize) == 0;
    }

    TuningStatus::Source source() { return processor.view().tuning.tuningStatus().source; }

    Processor processor;
    juce::AudioBuffer<float> sound{2, blockSize};
};

const double raisedHz = 440 * std::exp2(1.5 / 12);

} // namespace

extern "C" {
MTSClient* MTS_RegisterClient() {
    ++session.clients;
    return new MTSClient;
}
void MTS_DeregisterClient(MTSClient* client) {
    --session.clients;
    delete client;
}
bool MTS_HasMaster(MTSClient*) {
    return session.hasMaster;
}
bool MTS_ShouldFilterNote(MTSClient*, char note, char) {
    return session.filtered[static_cast<std::size_t>(note)];
}
double MTS_RetuningInSemitones(MTSClient*, char note, char) {
    return session.semitones[static_cast<std::size_t>(note)];
}
const char* MTS_GetScaleName(MTSClient*) {
    return "Of the session";
}
}

TEST_CASE("Every instance is a client of the session while it lives") {
    const int before = session.clients;
    {
        const Instance first, second;
        CHECK(session.clients == before + 2);
    }
    CHECK(session.clients == before);
}

TEST_CASE("A master's table tunes the keys from the next callback on and ends with the master") {
    Instance instance;
    CHECK(instance.soundsAt(440));
    {
        const Master master;
        CHECK(instance.soundsAt(440));
        session.semitones[struckNote] = 1.5;
        CHECK(instance.soundsAt(raisedHz));
        session.semitones[struckNote] = -3;
        CHECK(instance.soundsAt(440 * std::exp2(-3 / 12.0)));
        CHECK(instance.source() == TuningStatus::Source::session);
        CHECK(instance.processor.view().tuning.tuningStatus().scale == "Of the session");
    }
    session.semitones[struckNote] = 1.5; // ignored without a master
    CHECK(instance.soundsAt(440));
    CHECK(instance.source() == TuningStatus::Source::equal);
}

TEST_CASE("A key filtered by the master is silent until the filter ends") {
    const Master master;
    Instance instance;
    session.filtered.set(struckNote);
    CHECK(instance.isSilent());
    session.filtered.reset(struckNote);
    CHECK_FALSE(instance.isSilent());
}

TEST_CASE("A key whose pitch is not a number or out of range is silent") {
    const Master master;
    Instance instance;
    using Double = std::numeric_limits<double>;
    for (const double semitones : {Double::quiet_NaN(), Double::infinity(), -Double::infinity(),
                                   129.0, -129.0, Double::max()}) {
        session.semitones[struckNote] = semitones;
        CHECK(instance.isSilent());
    }
    session.semitones[struckNote] = 0;
    CHECK(instance.soundsAt(440));
}

TEST_CASE("An instance's own tuning precedes the master's until it is forgotten") {
    const Master master;
    Instance instance;
    session.semitones[struckNote] = 1.5;
    session.filtered.set(60);
    const auto file = testFolder() / "from432.kbm";
    std::ofstream(file) << "0\n0\n127\n60\n69\n432\n0\n";
    instance.processor.view().tuning.openTuning(file);
    CHECK(instance.source() == TuningStatus::Source::files);
    CHECK(instance.soundsAt(432));
    instance.processor.view().tuning.forgetTuning();
    CHECK(instance.source() == TuningStatus::Source::session);
    CHECK(instance.soundsAt(raisedHz));
}

TEST_CASE("A new player has the session's tuning from its first note on") {
    const Master master;
    Instance instance;
    session.semitones[struckNote] = 1.5;
    restore(instance.processor, testState("other"));
    CHECK(instance.soundsAt(raisedHz));
}
