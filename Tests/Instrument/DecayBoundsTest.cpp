#include "Instrument/DecayBounds.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/SettingsOfParameters.h"
#include "Support/SyntheticObject.h"
#include "Synth/LiveConditions.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

/// Returns the slowest decay of all sounding modes, visited one by one; infinite if none sounds.
double slowestOfAll(const Instrument& instrument,
                    const SynthesisSettings& settings,
                    double semitonesBelow) {
    double slowest = std::numeric_limits<double>::infinity();
    for (const auto& slot : instrument.slots()) {
        const auto& object = *slot.object;
        const auto conditions = liveConditions(slot, settings, std::exp2(-semitonesBelow / 12));
        for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
            const auto pole = conditions.law.pole(
                object.eigenvalueAt(mode, settings.thicknessRatio), object.damping(mode));
            if (naturalFrequencyHz(pole) >= lowestSoundingHz)
                slowest = std::min(slowest, decayBound(pole));
        }
    }
    return slowest;
}

/// One object with far more candidates for the slowest mode than the bounds keep. The higher a
/// mode, the smaller is its share of the damping law or its extra decay.
std::shared_ptr<const Instrument> manySlowModes() {
    std::vector<double> frequenciesHz, decays, extras;
    std::mt19937 random(5);
    for (int mode = 0; mode < 300; ++mode) {
        frequenciesHz.push_back(100 + 10 * mode);
        const double share = std::uniform_real_distribution<double>(0, 1)(random);
        decays.push_back(std::exp2(-4 * share) * std::sqrt(100 / frequenciesHz.back()));
        extras.push_back(std::exp2(4 * share) * std::sqrt(100 / frequenciesHz.back()));
    }
    auto object = syntheticObject(frequenciesHz);
    object.decaysPerSecond = decays;
    object.extraDecaysPerSecond = extras;
    ObjectLibrary library;
    const auto kept = library.add("many", object);
    return Instrument::build(
               {.kind = KeyMapKind::scaled, .lowestNote = 60, .highestNote = 63, .object = "many"},
               library)
        .value();
}

std::vector<std::shared_ptr<const Instrument>> instruments() {
    std::vector<std::shared_ptr<const Instrument>> all;
    for (const auto& preset : factoryPresets())
        if (preset.keyMap.kind != KeyMapKind::scene)
            all.push_back(Instrument::build(preset.keyMap, ObjectLibrary::shared()).value());
    all.push_back(manySlowModes());
    // An instrument with measured decays, a live thickness, and materials that differ from key to
    // key.
    ObjectLibrary library;
    std::vector<std::shared_ptr<const ModalObject>> kept;
    for (int note = 60; note < 64; ++note) {
        auto object = syntheticObject({60.0 + note, 500, 3000});
        object.decaysPerSecond = {1.0 * (note - 55), 0.5, 40};
        object.bending = object.eigenvalues;
        object.bending[0] /= 2;
        object.material.damping.fluidPerSecond = note - 58;
        object.material.youngsModulusPa *= note;
        kept.push_back(library.add("own/" + std::to_string(note), object));
    }
    all.push_back(
        Instrument::build(
            {.kind = KeyMapKind::bars, .lowestNote = 60, .highestNote = 63, .object = "own/{note}"},
            library)
            .value());
    return all;
}

} // namespace

TEST_CASE("No mode decays more slowly than the bound under any settings") {
    std::mt19937 random(3);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (const auto& instrument : instruments()) {
        INFO(instrument->keyMap().object);
        const auto bounds = decayBounds(*instrument);
        for (int time = 0; time < 40; ++time) {
            SynthesisSettings settings{.sizeRatio = std::exp2(between(-3, 3)),
                                       .thicknessRatio = std::exp2(between(-2, 2)),
                                       .frequencyRatio = std::exp2(between(-2, 2)),
                                       .decayRatio = std::exp2(between(-4, 3)),
                                       .keepPitch = time % 4 >= 2};
            if (time % 8 < 4)
                settings.thicknessRatio = 1;
            if (time % 2 == 1) // light, and so heavy that modes hardly oscillate
                settings.material =
                    LiveMaterial{.youngsModulusPa = std::pow(10, between(7, 12)),
                                 .densityKgPerM3 = between(100, 10000),
                                 .damping = {.fluidPerSecond = std::pow(10, between(-2, 5)),
                                             .viscoelasticSeconds = std::pow(10, between(-9, -3)),
                                             .lossFactor = between(0, 0.5)}};
            const double below = between(0, 14);
            REQUIRE(slowestDecay(bounds, settings, below) <=
                    slowestOfAll(*instrument, settings, below) * (1 + 1e-9));
        }
    }
}

TEST_CASE("The bound is at least half the decay of a factory keyboard's slowest mode") {
    const LiveMaterial steel{
        .youngsModulusPa = 2e11, .densityKgPerM3 = 7850, .damping = {.lossFactor = 2e-4}};
    for (const auto& preset : factoryPresets()) {
        if (preset.keyMap.kind == KeyMapKind::scene)
            continue;
        CAPTURE(preset.name);
        const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
        const auto bounds = decayBounds(*instrument);
        for (const SynthesisSettings& settings :
             {SynthesisSettings{}, synthesisSettings(preset.parameters),
              SynthesisSettings{.sizeRatio = 2, .keepPitch = true},
              SynthesisSettings{.sizeRatio = 0.5, .material = steel}}) {
            const double bound = slowestDecay(bounds, settings, 0);
            const double slowest = slowestOfAll(*instrument, settings, 0);
            CAPTURE(bound, slowest);
            CHECK(bound <= slowest * (1 + 1e-9));
            CHECK(bound >= slowest / 2);
        }
    }
}

TEST_CASE("With more candidates than kept bounds, the bound is at least half the slowest decay") {
    const auto instrument = manySlowModes();
    const auto bounds = decayBounds(*instrument);
    for (const SynthesisSettings& settings :
         {SynthesisSettings{}, SynthesisSettings{.sizeRatio = 2},
          SynthesisSettings{.frequencyRatio = 2, .keepPitch = true}})
        CHECK(slowestDecay(bounds, settings, 0) >= slowestOfAll(*instrument, settings, 0) / 2);
}

TEST_CASE("For one lightly damped material the bound is the lowest mode's decay") {
    ObjectLibrary library;
    const auto kept = library.add("plate", syntheticObject({300, 440, 2000}));
    const auto instrument =
        Instrument::build(
            {.kind = KeyMapKind::zones, .lowestNote = 60, .highestNote = 72, .object = "plate"},
            library)
            .value();
    const auto bounds = decayBounds(*instrument);
    for (const double size : {0.5, 1.0, 3.0})
        CHECK_THAT(slowestDecay(bounds, {.sizeRatio = size}, 2),
                   WithinRel(slowestOfAll(*instrument, {.sizeRatio = size}, 2), 1e-9));
}

TEST_CASE(
    "If keys keep their pitch, the bound is the decay of the lowest key's pitch at any size") {
    ObjectLibrary library;
    const auto kept = library.add("bell", syntheticObject({300, 440, 2000}));
    const auto instrument =
        Instrument::build(
            {.kind = KeyMapKind::scaled, .lowestNote = 60, .highestNote = 72, .object = "bell"},
            library)
            .value();
    const auto bounds = decayBounds(*instrument);
    for (const double size : {0.5, 3.0}) {
        const SynthesisSettings settings{.sizeRatio = size, .keepPitch = true};
        CHECK_THAT(slowestDecay(bounds, settings, 0),
                   WithinRel(slowestOfAll(*instrument, settings, 0), 1e-6));
    }
}

TEST_CASE("The lowest tuning counts only keys that have objects of their own") {
    ObjectLibrary library;
    std::vector<std::shared_ptr<const ModalObject>> kept;
    for (int note = 60; note < 64; ++note)
        kept.push_back(library.add("own/" + std::to_string(note), syntheticObject({300})));
    KeyMap map{.kind = KeyMapKind::bars,
               .lowestNote = 60,
               .highestNote = 63,
               .resizedFrom = 1,
               .resizedTo = 0,
               .object = "own/{note}"};
    const auto bars = Instrument::build(map, library).value();
    map.kind = KeyMapKind::zones;
    map.object = "own/60";
    const auto zones = Instrument::build(map, library).value();
    KeyTuning tuning;
    CHECK(semitonesBelowEqual(*bars, tuning) == 0);
    tuning.semitonesFromEqual[60] = 3;
    tuning.semitonesFromEqual[61] = -1.5;
    tuning.semitonesFromEqual[62] = -7; // has no pitch
    tuning.unmapped.set(62);
    tuning.semitonesFromEqual[80] = -20; // no key
    CHECK(semitonesBelowEqual(*bars, tuning) == 1.5);
    CHECK(semitonesBelowEqual(*zones, tuning) == 0);
}
