// The host's song position: every pass over the same place renders the same samples.
#include "Plugin/HostTransport.h"
#include "Plugin/RealTimeTrap.h"
#include "Support/TestSound.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr int blockSize = 480; // not a whole number of cells
constexpr double beatsPerMinute = 120, beatsPerBlock = blockSize * beatsPerMinute / 60 / testRateHz;
constexpr int samplesPerBeat = 24000;

class Song final : public juce::AudioPlayHead {
public:
    juce::Optional<PositionInfo> getPosition() const override {
        PositionInfo position;
        position.setBpm(tempo);
        position.setIsPlaying(plays);
        if (tellsPlace)
            position.setPpqPosition(beats);
        return position;
    }

    bool plays = false, tellsPlace = true;
    double beats = 0, tempo = beatsPerMinute;
};

enum class Playing { syncedMotor, freeMotor, scraping, inRoom, onStage };

/// A damped vibraphone with spread strikes, or falling dice, and the song that it plays in.
struct PlayedSong {
    explicit PlayedSong(Playing playing = Playing::syncedMotor) {
        constexpr int vibraphone = 9, dice = 18;
        constexpr double eighth = 6; // index of the motor's choice
        processor.setCurrentProgram(playing == Playing::onStage ? dice : vibraphone);
        processor.setNonRealtime(playing == Playing::onStage); // so that no strike comes late
        const auto set = [this](ParameterId id, double value) {
            processor.view().parameters.change(id, value);
        };
        set(ParameterId::letRing, 0);
        set(ParameterId::releaseTime, 0.05);
        set(ParameterId::strikeSpread, 60);
        set(ParameterId::motorDepth, 70);
        set(ParameterId::motorSync, playing == Playing::freeMotor ? 0 : eighth);
        set(ParameterId::room, playing == Playing::inRoom ? 30 : 0);
        set(ParameterId::roomDecay, 0.3);
        set(ParameterId::contact, playing == Playing::scraping ? scrapeContact : strikeContact);
        processor.setPlayHead(&song);
        processor.prepareToPlay(testRateHz, blockSize);
    }

    /// Plays on from the current song position.
    HostSound pass(const juce::MidiBuffer& midi, int samples) {
        song.plays = true;
        return run(midi, samples);
    }

    HostSound passFrom(double beats, const juce::MidiBuffer& midi, int samples = 24000) {
        song.beats = beats;
        return pass(midi, samples);
    }

    /// Renders until nothing sounds, by a length that is not a whole number of blocks.
    void fallSilent(bool plays) {
        song.plays = plays;
        run({}, 96000 - 137);
        REQUIRE(loudest(run({}, blockSize)) == 0);
    }

    Processor processor;
    Song song;

private:
    HostSound run(const juce::MidiBuffer& midi, int samples) {
        HostSound sound;
        for (int start = 0; start < samples; start += blockSize) {
            const int count = std::min(blockSize, samples - start);
            juce::MidiBuffer block;
            block.addEvents(midi, start, count, -start);
            sound.append(render(processor, count, blockSize, block));
            if (song.plays)
                song.beats += beatsPerBlock * count / blockSize;
        }
        return sound;
    }
};

/// Overlapping notes in the vibraphone's range.
juce::MidiBuffer chords(int samples = 24000) {
    juce::MidiBuffer midi;
    int note = 60;
    for (int stamp = 100; stamp + 3000 < samples; stamp += 1700, note = 60 + (note + 5) % 12) {
        midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{90}), stamp);
        midi.addEvent(juce::MidiMessage::noteOff(1, note), stamp + 2500);
    }
    return midi;
}

} // namespace

TEST_CASE("A second pass over a place of the song is bit-identical to the first") {
    const auto playing = GENERATE(Playing::syncedMotor, Playing::freeMotor, Playing::scraping,
                                  Playing::inRoom, Playing::onStage);
    const double from = GENERATE(0.0, 8.0, 9.75);
    CAPTURE(static_cast<int>(playing), from);
    PlayedSong played(playing);
    constexpr int samples = 72000; // the room has faded out by then
    const auto first = played.passFrom(from, chords(), samples);
    REQUIRE(loudest(first) > 1e-4f);
    SECTION("started again") {
        played.fallSilent(false);
    }
    SECTION("looped") {
        played.fallSilent(true);
    }
    CHECK((played.passFrom(from, chords(), samples) == first));
    played.fallSilent(false);
    if (playing != Playing::scraping) // at other beats the strikes spread differently
        CHECK((played.passFrom(from + 1, chords(), samples) != first));
}

TEST_CASE("Offline a second pass repeats the matched loudness of materials that change in it") {
    PlayedSong played(GENERATE(Playing::freeMotor, Playing::scraping));
    played.processor.setNonRealtime(true);
    const auto set = [&](ParameterId id, double value) {
        played.processor.view().parameters.change(id, value);
    };
    set(ParameterId::matchLoudness, 1);
    const auto pass = [&] {
        HostSound sound;
        played.song.beats = 8;
        for (const int choice : {5, 7, 1}) {
            set(ParameterId::material, firstLibraryMaterial + choice);
            sound.append(played.pass(chords(), 24000));
        }
        return sound;
    };
    const auto first = pass();
    REQUIRE(loudest(first) > 1e-4f);
    played.fallSilent(false);
    CHECK((pass() == first));
}

TEST_CASE("A bounce equals the live sound at the same song position") {
    PlayedSong live, bounce;
    live.fallSilent(false); // callbacks come long before the transport starts
    const auto heard = live.passFrom(4, chords());
    bounce.processor.setNonRealtime(true);
    CHECK((bounce.passFrom(4, chords()) == heard));
}

TEST_CASE("Without a song position, or while the host is stopped, the strike counter runs on") {
    const bool tellsPlace = GENERATE(true, false);
    CAPTURE(tellsPlace);
    PlayedSong played, alone;
    played.song.tellsPlace = alone.song.tellsPlace = tellsPlace;
    const auto passOf = [tellsPlace](PlayedSong& one) {
        return tellsPlace ? render(one.processor, 24000, blockSize, chords())
                          : one.passFrom(0, chords());
    };
    const auto first = passOf(played);
    CHECK((first == passOf(alone)));
    played.fallSilent(!tellsPlace);
    CHECK((passOf(played) != first));
}

TEST_CASE("A pass that starts while something rings strikes at the same points as the first") {
    constexpr int length = 9600; // a whole number of cells and of blocks
    juce::MidiBuffer impact;
    impact.addEvent(juce::MidiMessage::noteOn(1, 64, juce::uint8{90}), 10);
    /// Returns how far the second strike's share of the sound is from the first strike's sound.
    const auto farthest = [&](double second) {
        PlayedSong struck, ringing;
        for (auto* each : {&struck, &ringing})
            each->processor.view().parameters.change(ParameterId::motorDepth, 0);
        const auto first = struck.passFrom(16, impact, length);
        REQUIRE((ringing.passFrom(16, impact, length) == first));
        const auto both = struck.passFrom(second, impact, length);
        const auto ring = ringing.passFrom(second, {}, length);
        float most = 0;
        for (std::size_t i = 0; i < first.left.size(); ++i)
            most = std::max(most, std::abs(both.left[i] - ring.left[i] - first.left[i]));
        return most / loudest(first);
    };
    CHECK(farthest(16) < 0.2); // not 0, because ringing sound changes which faint modes are dropped
    CHECK(farthest(17) > 0.4);
}

TEST_CASE("The motor's phase depends on the song position only, not on where playback starts") {
    const auto noteAtNine = [](double from) {
        PlayedSong played;
        const int before = static_cast<int>((9 - from) * samplesPerBeat);
        juce::MidiBuffer impact;
        played.passFrom(from, {}, before);
        // The strike counter depends on where playback started.
        played.processor.view().parameters.change(ParameterId::strikeSpread, 0);
        impact.addEvent(juce::MidiMessage::noteOn(1, 64, juce::uint8{90}), 64);
        return played.pass(impact, 24000);
    };
    const auto expected = noteAtNine(8);
    const auto later = noteAtNine(8.6); // 150 cells earlier
    float farthest = 0;
    for (std::size_t i = 0; i < expected.left.size(); ++i)
        farthest = std::max(farthest, std::abs(expected.left[i] - later.left[i]));
    CHECK(farthest < 1e-5f * loudest(expected));
}

TEST_CASE("The callback stays real-time safe while the song starts, jumps and stops") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    PlayedSong played(GENERATE(Playing::syncedMotor, Playing::onStage));
    played.processor.setNonRealtime(false);
    juce::AudioBuffer<float> buffer(2, blockSize);
    const auto music = chords(4800);
    for (int block = 0; block < 400; ++block) {
        played.song.plays = block % 200 >= 20;
        played.song.beats = block % 30 * beatsPerBlock;
        juce::MidiBuffer midi;
        if (block % 200 < 30)
            midi.addEvents(music, block % 10 * blockSize, blockSize, -(block % 10) * blockSize);
        midi.addEvent(juce::MidiMessage::controllerEvent(1, 101, 0), 0);
        midi.addEvent(juce::MidiMessage::controllerEvent(1, 100, 6), 0);
        midi.addEvent(juce::MidiMessage::controllerEvent(1, 6, block / 3 % 16), 0);
        const auto faults = faultsOf([&] { played.processor.processBlock(buffer, midi); });
        INFO(block << ": " << faults.first);
        CHECK(faults.allocations == 0);
        CHECK(faults.locks == 0);
        if (systemCallTrapWorks())
            CHECK(faults.systemCalls == 0);
    }
}

TEST_CASE("A pass begins where the host starts or goes back, and nowhere else") {
    Song song;
    HostTransport transport;
    const auto beginsAt = [&](double beats) {
        song.beats = beats;
        transport.follow(&song, blockSize, testRateHz);
        return transport.begins();
    };
    CHECK_FALSE(beginsAt(3)); // not playing
    CHECK_FALSE(transport.songPlace());
    song.plays = true;
    CHECK(beginsAt(3));
    CHECK(transport.songPlace() == 3);
    CHECK(transport.tempo() == beatsPerMinute);
    CHECK_FALSE(beginsAt(3 + beatsPerBlock));
    CHECK_FALSE(beginsAt(3 + 2.1 * beatsPerBlock)); // hosts round the position
    CHECK(beginsAt(2.5));
    CHECK_FALSE(beginsAt(8)); // callbacks were left out
    song.plays = false;
    CHECK_FALSE(beginsAt(8));
    song.plays = true;
    CHECK(beginsAt(8));
    transport.forgetPlace();
    CHECK(beginsAt(8 + beatsPerBlock));
    song.tellsPlace = false;
    CHECK_FALSE(beginsAt(8 + 2 * beatsPerBlock));
    CHECK_FALSE(transport.songPlace());
    CHECK(transport.tempo() == beatsPerMinute);
    song.tellsPlace = true;
    for (const double none : {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(), 1e300}) {
        CHECK_FALSE(beginsAt(none));
        CHECK_FALSE(transport.songPlace());
    }
    transport.follow(nullptr, blockSize, testRateHz);
    CHECK(transport.tempo() == 0);
}

TEST_CASE("A host that leaves out silent callbacks changes no strike") {
    PlayedSong called, leftOut;
    for (auto* each : {&called, &leftOut})
        each->processor.view().parameters.change(ParameterId::room, 0);
    constexpr int silence = 96000, cells = 24000; // whole blocks and cells
    for (auto* each : {&called, &leftOut})
        each->passFrom(0, chords(), cells);
    called.pass({}, 2 * silence);
    leftOut.pass({}, silence);
    leftOut.song.beats += static_cast<double>(silence) / samplesPerBeat;
    CHECK((leftOut.pass(chords(), cells) == called.pass(chords(), cells)));
}

TEST_CASE("A pass goes on through changes of tempo and block size and through empty callbacks") {
    Song song;
    HostTransport transport;
    song.plays = true;
    const auto goesOn = [&](double beats, int samples) {
        song.beats = beats;
        transport.follow(&song, samples, testRateHz);
        return !transport.begins();
    };
    REQUIRE_FALSE(goesOn(4, samplesPerBeat));
    song.tempo = 60; // takes effect somewhere within the last block
    CHECK(goesOn(4.7, samplesPerBeat));
    CHECK(goesOn(5.2, samplesPerBeat));
    song.tellsPlace = false;
    CHECK(goesOn(0, 0));
    song.tellsPlace = true;
    CHECK(goesOn(5.7, samplesPerBeat));
    CHECK(goesOn(6.5, samplesPerBeat));
    CHECK_FALSE(goesOn(6.6, samplesPerBeat)); // expected: 7
}

TEST_CASE("A song position that stands still is ignored: strikes count on, and the motor follows "
          "the tempo") {
    Song song;
    HostTransport transport;
    song.plays = true;
    int begins = 0, places = 0;
    for (int block = 0; block < 400; ++block) {
        song.beats = std::floor(block * beatsPerBlock); // some hosts report whole beats only
        transport.follow(&song, blockSize, testRateHz);
        begins += transport.begins();
        places += transport.songPlace().has_value();
    }
    CHECK(begins == 1);
    CHECK(places == 8);
    CHECK(transport.tempo() == beatsPerMinute);
}

TEST_CASE("If a host reports no position for a block, the transport advances by itself") {
    struct Sparing final : juce::AudioPlayHead {
        juce::Optional<PositionInfo> getPosition() const override { return position; }
        juce::Optional<PositionInfo> position;
    } host;
    HostTransport transport;
    host.position.emplace();
    host.position->setBpm(beatsPerMinute);
    host.position->setIsPlaying(true);
    host.position->setPpqPosition(5.0);
    transport.follow(&host, blockSize, testRateHz);
    CHECK(transport.begins());
    host.position = juce::nullopt;
    for (int block = 1; block < 10; ++block) {
        transport.follow(&host, blockSize, testRateHz);
        CHECK_FALSE(transport.begins());
        CHECK(transport.tempo() == beatsPerMinute);
        REQUIRE(transport.songPlace());
        CHECK(*transport.songPlace() == Approx(5 + block * beatsPerBlock));
    }
}
