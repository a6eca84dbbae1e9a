#include "Instrument/Modulation.h"

#include "Instrument/MidiControllers.h"
#include "Support/RenderNotes.h"
#include "Support/Routes.h"
#include "Support/WithParameter.h"
#include "Synth/SharedSurfaceProfile.h"
#include "TestInstruments.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

namespace {

constexpr double cellSeconds = 0.002;

/// Modulation with its keys and its glide.
struct Rig {
    explicit Rig(const ParameterValues& values, std::uint64_t seed = 1)
        : modulation(glide, keys, cellSeconds, seed) {
        glide.setGoal(values);
    }

    void cells(int count) {
        for (int cell = 0; cell < count; ++cell)
            modulation.beginCell(0, std::nullopt);
    }
    void play(const MidiEvent& event) {
        keys.follow(event);
        if (event.isNoteOn())
            modulation.noteOn(event.first(), event.second());
    }
    /// How far along its range modulation moves the parameter of all notes, or of one.
    double moved(ParameterId target) {
        return place(target, modulation.values()[target]) - base(target);
    }
    double moved(ParameterId target, int note) {
        return place(target, modulation.valueOf(target, note)) - base(target);
    }

    std::shared_ptr<const Instrument> instrument = bars();
    HeldContacts contacts{*instrument, sharedSurfaceProfile({}, 48000), 1};
    KeyState keys{contacts};
    ParameterGlide glide{cellSeconds};
    Modulation modulation;

private:
    static double place(ParameterId target, double value) {
        return parameterInfo(target).toNormalised(value);
    }
    double base(ParameterId target) const { return place(target, glide.values()[target]); }
};

MidiEvent noteOn(int note, int velocity) {
    return test::midi(0, 0x90, note, velocity);
}

MidiEvent noteOff(int note) {
    return test::midi(0, 0x80, note, 0);
}

} // namespace

TEST_CASE("Without routes the values are the glide's own") {
    Rig rig({});
    rig.play(noteOn(60, 100));
    rig.cells(1);
    CHECK(&rig.modulation.values() == &rig.glide.values());
    CHECK(&rig.modulation.valuesOf(60) == &rig.glide.values());
    CHECK(rig.modulation.valueOf(tune, 60) == 0);
}

TEST_CASE("An LFO moves a parameter at its rate, from phase 0 at the first cell") {
    const auto values = with(routed(0, ModulationSource::lfo1, decay, 20), lfo1Rate, 2);
    Rig rig(values);
    for (int cell = 0; cell < 1000; ++cell) {
        rig.modulation.beginCell(0, std::nullopt);
        const double wave = std::sin(2 * std::numbers::pi * 2 * cell * cellSeconds);
        // The rounding of 3 ms moves a wave of 2 Hz by less than 4 %.
        CHECK(rig.moved(decay) == Approx(0.2 * wave).margin(0.008));
        CHECK(rig.moved(decay, 60) == Approx(0.2 * wave).margin(1e-9));
    }
}

TEST_CASE("An LFO in sync stands where the song does") {
    const auto sync = *parseParameter(parameterInfo(lfo1Sync), "1/2");
    Rig rig(with(with(routed(0, ModulationSource::lfo1, decay, 20), lfo1Sync, sync), lfo1Shape,
                 double(LfoShape::rising)));
    for (const double beats : {-0.5, 0.5, 1.0, 7.5, 0.25}) {
        rig.modulation.beginCell(120, beats);
        const double place = beats / 2 - std::floor(beats / 2);
        CHECK(rig.moved(decay, 60) == Approx(0.2 * (2 * place - 1)).margin(1e-9));
    }
}

TEST_CASE("An LFO per note starts with each note") {
    auto values = with(routed(0, ModulationSource::lfo1, tune, 10), lfo1PerNote, 1);
    values = with(with(values, lfo1Shape, double(LfoShape::falling)), lfo1Rate, 1);
    Rig rig(values);
    rig.cells(1);
    rig.play(noteOn(60, 100));
    rig.cells(100);
    rig.play(noteOn(62, 100));
    rig.cells(50);
    CHECK(rig.moved(tune, 60) == Approx(0.1 * (1 - 2 * 0.3)).margin(1e-9));
    CHECK(rig.moved(tune, 62) == Approx(0.1 * (1 - 2 * 0.1)).margin(1e-9));
}

TEST_CASE("Random values of an LFO per note differ from note to note") {
    auto values = with(routed(0, ModulationSource::lfo1, tune, 100), lfo1PerNote, 1);
    Rig rig(with(values, lfo1Shape, double(LfoShape::random)));
    rig.cells(1);
    rig.play(noteOn(60, 100));
    rig.play(noteOn(61, 100));
    CHECK(rig.moved(tune, 60) != rig.moved(tune, 61));
}

TEST_CASE("Velocity and key move each note by itself, and everything by the last note") {
    auto values = routed(0, ModulationSource::velocity, hardness, 50);
    values = routed(1, ModulationSource::key, decay, 40, values);
    Rig rig(values);
    rig.play(noteOn(36, 127));
    rig.play(noteOn(90, 64));
    rig.cells(1);
    CHECK(rig.modulation.valuesOf(36)[hardness] == Approx(100));
    CHECK(rig.modulation.valuesOf(90)[hardness] == Approx(200 * 0.5 * 64 / 127.0));
    CHECK(rig.moved(decay, 36) == Approx(0.4 * -24 / 60));
    CHECK(rig.moved(decay) == Approx(0.4 * 30 / 60));
    rig.play(noteOn(36, 127));
    rig.cells(100);
    CHECK(rig.moved(decay) == Approx(0.4 * -24 / 60));
}

TEST_CASE("A step of a source reaches all notes within some milliseconds, not at once") {
    Rig rig(routed(0, ModulationSource::wheel, decay, -40));
    rig.cells(1);
    CHECK(rig.moved(decay) == 0); // the wheel counts as down until it moves
    rig.play(test::midi(0, 0xb0, midi::modulation, 127));
    rig.cells(1);
    CHECK(rig.moved(decay) == Approx(-0.4 * -std::expm1(-cellSeconds / 0.003)));
    rig.cells(20);
    CHECK(rig.moved(decay) == Approx(-0.4).margin(1e-4));
    rig.play(test::midi(0, 0xb0, midi::resetControllers, 0));
    rig.cells(30);
    CHECK(rig.moved(decay) == Approx(0).margin(1e-4));
}

TEST_CASE("Pressure moves the key that is pressed") {
    Rig rig(routed(0, ModulationSource::pressure, tune, 10));
    rig.play(noteOn(60, 100));
    rig.play(noteOn(61, 100));
    rig.play(test::midi(0, 0xa0, 60, 127));
    rig.cells(1);
    CHECK(rig.moved(tune, 60) == Approx(0.1));
    CHECK(rig.moved(tune, 61) == 0);
}

TEST_CASE("The wheel can set the amount of an LFO") {
    auto values = routed(0, ModulationSource::lfo1, tune, 0);
    values = routed(1, ModulationSource::wheel, modulation1Amount, 10, values);
    Rig rig(with(values, lfo1Shape, double(LfoShape::square)));
    rig.cells(1);
    CHECK(rig.moved(tune, 60) == 0);
    rig.play(test::midi(0, 0xb0, midi::modulation, 127));
    CHECK(rig.moved(tune, 60) == Approx(0.2));
}

TEST_CASE("Random values differ by note and route, and repeat from the number of a note on") {
    auto values = routed(0, ModulationSource::random, hardness, 50);
    values = routed(1, ModulationSource::random, strikeAcross, 50, values);
    Rig rig(values), again(values), other(values, 2);
    std::set<double> seen;
    std::vector<double> first;
    for (auto* each : {&rig, &again, &other})
        each->cells(1);
    for (int i = 0; i < 8; ++i) {
        for (auto* each : {&rig, &again, &other})
            each->play(noteOn(60, 100));
        const double value = rig.moved(hardness, 60);
        CHECK(std::abs(value) <= 0.5);
        CHECK(seen.insert(value).second);
        CHECK(seen.insert(rig.moved(strikeAcross, 60)).second);
        CHECK(value == again.moved(hardness, 60));
        CHECK(value != other.moved(hardness, 60));
        first.push_back(value);
    }
    rig.modulation.countFrom(3);
    rig.play(noteOn(72, 100));
    CHECK(rig.moved(hardness, 72) == first[3]);
}

TEST_CASE("The envelope rises, falls to its sustain, and falls to nothing after the key") {
    auto values = routed(0, ModulationSource::envelope, tune, 50);
    values = with(with(values, envelopeAttack, 0.1), envelopeDecay, 0.2);
    values = with(with(values, envelopeSustain, 40), envelopeRelease, 0.4);
    Rig rig(values);
    rig.play(noteOn(60, 100));
    rig.cells(26); // the first cell begins with the note
    CHECK(rig.moved(tune, 60) == Approx(0.5 * 26 / 50));
    rig.cells(24);
    CHECK(rig.moved(tune, 60) == Approx(0.5));
    rig.cells(100); // 0.2 s
    CHECK(rig.moved(tune, 60) == Approx(0.5 * (0.4 + 0.6 * 0.01)));
    rig.cells(1000);
    rig.play(noteOff(60));
    rig.cells(100); // half of the release
    CHECK(rig.moved(tune, 60) == Approx(0.5 * 0.4 * 0.1));
    CHECK(rig.moved(tune, 61) == 0);
}

TEST_CASE("The envelope of a key that is released at once still rises to the full") {
    Rig rig(with(routed(0, ModulationSource::envelope, tune, 50), envelopeAttack, 0.1));
    rig.play(noteOn(60, 100));
    rig.play(noteOff(60));
    rig.cells(50);
    CHECK(rig.moved(tune, 60) == Approx(0.5));
    rig.cells(1);
    CHECK(rig.moved(tune, 60) < 0.5);
}

TEST_CASE("A reset restarts LFOs, envelopes and random values") {
    auto values = routed(0, ModulationSource::lfo1, decay, 20);
    values = routed(1, ModulationSource::envelope, tune, 20, values);
    values = routed(2, ModulationSource::random, hardness, 20, values);
    Rig rig(values), fresh(values);
    rig.cells(77);
    rig.play(noteOn(60, 100));
    rig.cells(20);
    rig.modulation.reset();
    for (auto* each : {&rig, &fresh}) {
        each->cells(10);
        each->play(noteOn(62, 50));
        each->cells(10);
    }
    CHECK(rig.modulation.values() == fresh.modulation.values());
    CHECK(rig.modulation.valuesOf(62) == fresh.modulation.valuesOf(62));
}

TEST_CASE("A host's shifts move single notes, on top of routes") {
    Rig rig(routed(0, ModulationSource::velocity, hardness, 10));
    NoteShifts shifts;
    rig.modulation.follow(shifts);
    rig.play(noteOn(60, 127));
    rig.play(noteOn(62, 127));
    rig.cells(1);
    NoteShifts::Shares shares{};
    shares[0] = 0.2; // hardness
    shifts.set(60, shares);
    CHECK(noteTargets().front() == hardness);
    CHECK(rig.moved(hardness, 60) == Approx(0.3));
    CHECK(rig.moved(hardness, 62) == Approx(0.1));
    CHECK(rig.modulation.valuesOf(60)[hardness] == rig.modulation.valueOf(hardness, 60));
    CHECK(rig.moved(hardness) == Approx(0.1));
    CHECK(rig.moved(hardness, Modulation::hand) == Approx(0));
    shifts.set(60, {});
    CHECK(rig.moved(hardness, 60) == Approx(0.1));
    CHECK_FALSE(shifts.moves(hardness));
}

TEST_CASE("A host's shift of the pitch glides, and a new note has it at once") {
    Rig rig({});
    NoteShifts shifts;
    rig.modulation.follow(shifts);
    rig.play(noteOn(60, 100));
    rig.cells(1);
    NoteShifts::Shares shares{};
    shares[*noteTargetIndex(tune)] = 0.1;
    shifts.set(60, shares);
    CHECK(rig.modulation.moves(tune));
    CHECK(rig.moved(tune, 60) == 0);
    rig.cells(5); // 10 ms: 63 %
    CHECK(rig.moved(tune, 60) > 0.05);
    CHECK(rig.moved(tune, 60) < 0.09);
    rig.play(noteOn(60, 100));
    CHECK(rig.moved(tune, 60) == Approx(0.1));
    shifts.set(60, {});
    CHECK(rig.modulation.moves(tune));
    rig.cells(100);
    CHECK_FALSE(rig.modulation.moves(tune));
    CHECK(rig.moved(tune, 60) == 0);
}
