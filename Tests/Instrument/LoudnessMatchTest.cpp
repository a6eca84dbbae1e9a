#include "Instrument/LoudnessMatch.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/PhrasePrediction.h"
#include "LoudnessRig.h"
#include "Object/Mallet.h"
#include "Support/KeyedPresets.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <ranges>
#include <string>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = LoudnessRig::sampleRateHz;

/// Returns one preset of each kind of body: all of them would take minutes.
auto presetsOfBodies() {
    return keyedFactoryPresets() | std::views::filter([](const Preset& preset) {
               constexpr std::array names{"Rosewood Xylophone", "Marimba", "Steel Plate",
                                          "Steel Ring",         "Stones",  "Tubular Bells",
                                          "Handbell",           "Wok",     "Wooden Table"};
               return std::ranges::find(names, preset.name) != names.end();
           });
}

/// Returns the gain in dB for these values with "match loudness" on.
double gainOf(const LoudnessMatch& match, const ParameterValues& now) {
    return match.gainDb(with(now, matchLoudness, 1));
}

/// Materials from plastic to hard ceramic: speeds of sound √(E/ρ) of 1200, 3500 and 6000 m/s, each
/// with three densities and with dampings from a bell's to a soft wood's.
struct MaterialFigures {
    double youngsModulusGpa, densityKgPerM3, fluidPerSecond, viscoelasticMicroseconds, lossFactor;
};
constexpr std::array materialGrid{MaterialFigures{1.008, 700, 0.01, 0.0001, 1e-4},
                                  MaterialFigures{3.744, 2600, 13, 0.3, 0},
                                  MaterialFigures{12.24, 8500, 30, 1, 0},
                                  MaterialFigures{31.85, 2600, 0.01, 0.0001, 1e-4},
                                  MaterialFigures{104.1, 8500, 13, 0.3, 0},
                                  MaterialFigures{8.575, 700, 30, 1, 0},
                                  MaterialFigures{306, 8500, 0.01, 0.0001, 1e-4},
                                  MaterialFigures{25.2, 700, 13, 0.3, 0},
                                  MaterialFigures{93.6, 2600, 30, 1, 0}};

/// Mallets from felt to brass, light and heavy.
struct MalletFigures {
    double hardnessMpa, massGrams, radiusMillimetres;
};
constexpr std::array malletGrid{MalletFigures{1, 10, 10},     MalletFigures{1, 60, 25},
                                MalletFigures{30, 10, 25},    MalletFigures{30, 60, 10},
                                MalletFigures{1000, 10, 10},  MalletFigures{1000, 60, 25},
                                MalletFigures{60000, 10, 25}, MalletFigures{60000, 60, 10}};

ParameterValues of(const MaterialFigures& figures, ParameterValues parameters) {
    parameters.set(material, customMaterial);
    parameters.set(youngsModulus, figures.youngsModulusGpa);
    parameters.set(density, figures.densityKgPerM3);
    parameters.set(fluidDamping, figures.fluidPerSecond);
    parameters.set(viscoelasticDamping, figures.viscoelasticMicroseconds);
    parameters.set(lossFactor, figures.lossFactor);
    return parameters;
}

ParameterValues of(const MalletFigures& figures, ParameterValues parameters) {
    parameters.set(mallet, customMallet);
    parameters.set(malletHardness, figures.hardnessMpa);
    parameters.set(malletMass, figures.massGrams);
    parameters.set(malletRadius, figures.radiusMillimetres);
    return parameters;
}

/// The largest errors over a grid of figures, and the number of figures beyond the gain's bound.
struct Worst {
    double matched = 0, predicted = 0;
    int beyond = 0;
};

template <typename Grid>
Worst worstOf(const Grid& grid, const Preset& preset, int kind, std::uint32_t takes, int velocity) {
    LoudnessRig rig(preset, kind, takes);
    Worst worst;
    for (const auto& figures : grid)
        if (const auto error = rig.error(of(figures, rig.own), velocity)) {
            REQUIRE(std::isfinite(error->matched));
            REQUIRE(std::isfinite(error->predicted));
            worst.matched = std::max(worst.matched, std::abs(error->matched));
            worst.predicted = std::max(worst.predicted, std::abs(error->predicted));
        } else
            ++worst.beyond;
    return worst;
}

} // namespace

TEST_CASE(
    "Matched strikes of another material are within 4.4 LU at velocity 100, 6 at 127, 6.5 at 40") {
    // At low velocities long contacts leave stiff materials fainter.
    constexpr std::array<double, PhrasePrediction::velocities.size()> mostLu{6.5, 4.4, 6};
    for (const auto& preset : presetsOfBodies())
        for (std::size_t level = 0; level < mostLu.size(); ++level) {
            const int velocity = PhrasePrediction::velocities[level];
            INFO(preset.name << ", velocity " << velocity);
            const auto worst = worstOf(materialGrid, preset, strikeContact, 4, velocity);
            CHECK(worst.matched < mostLu[level]);
            CHECK(worst.beyond == 0);
        }
}

TEST_CASE("Matched strikes of another mallet are within 3.1 LU at velocity 100, 7 LU at 127") {
    // At velocity 40 the long contacts of soft mallets leave high keys fainter, as real ones do.
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    constexpr std::array<double, PhrasePrediction::velocities.size()> mostLu{unbounded, 3.1, 7};
    constexpr std::array<double, PhrasePrediction::velocities.size()> mostOffLu{1.5, 1, 1};
    for (const auto& preset : presetsOfBodies())
        for (std::size_t level = 0; level < mostLu.size(); ++level) {
            const int velocity = PhrasePrediction::velocities[level];
            INFO(preset.name << ", velocity " << velocity);
            const auto worst = worstOf(malletGrid, preset, strikeContact, 4, velocity);
            CHECK(worst.matched < mostLu[level]);
            CHECK(worst.predicted < mostOffLu[level]);
            CHECK(worst.beyond <= 2);
        }
}

TEST_CASE("The gain is the mean over velocities, within 1.5 dB of the middle one") {
    std::size_t means = 0, bounded = 0;
    for (const auto& preset : keyedFactoryPresets()) {
        LoudnessRig rig(preset, strikeContact);
        const auto wanted = predictedLoudness(rig.predicted, rig.own);
        for (const auto& figures : malletGrid) {
            const auto now = of(figures, rig.own);
            auto gains = predictedLoudness(rig.predicted, now);
            for (std::size_t level = 0; level < gains.size(); ++level)
                gains[level] = wanted[level] - gains[level];
            const double mean = std::reduce(gains.begin(), gains.end()) / 3;
            const double middle = gains[PhrasePrediction::middleVelocity];
            const double expected = std::clamp(mean, middle - 1.5, middle + 1.5);
            ++(expected == mean ? means : bounded);
            CHECK(rig.match->gainDb(now) == Approx(std::clamp(expected, -40.0, 40.0)));
        }
    }
    CHECK(means > 20);
    CHECK(bounded > 10);
}

TEST_CASE("Matched scrapes of another material are within 2 LU in the mean over the surface",
          "[.weekly]") {
    for (const auto& preset : presetsOfBodies()) {
        INFO(preset.name);
        const auto worst = worstOf(materialGrid, preset, scrapeContact, 16, 100);
        CHECK(worst.matched < 2);
        CHECK(worst.beyond <= 1);
    }
}

TEST_CASE("Matched rolls of another material are within 2.3 LU in the mean over the surface",
          "[.weekly]") {
    for (const auto& preset : presetsOfBodies()) {
        INFO(preset.name);
        const auto worst = worstOf(materialGrid, preset, rollContact, 16, 100);
        CHECK(worst.matched < 2.3);
        CHECK(worst.beyond <= 1);
    }
}

TEST_CASE("Without the gain, mallets on a xylophone are more than 20 LU apart") {
    const auto& preset = factoryPresets().front();
    LoudnessRig rig(preset, strikeContact);
    const double plastic = rig.loudness(preset.parameters, 20);
    const double yarn = rig.loudness(with(preset.parameters, mallet, firstRackMallet), 20);
    CHECK(plastic - yarn > 20);
}

TEST_CASE(
    "The predicted loudness of struck presets matches libebur128's within 0.6 LU at velocity 100") {
    for (const auto& preset : keyedFactoryPresets()) {
        if (static_cast<int>(preset.parameters[contact]) != strikeContact)
            continue;
        // Strikes on a shared object meet the sound that still rings, so measure the mean of four
        // phrases.
        LoudnessRig rig(preset, strikeContact, 4);
        const double bothChannels = 10 * std::log10(2);
        const double measured = rig.loudness(rig.own, 0) - bothChannels;
        INFO(preset.name << ": " << measured);
        CHECK(std::abs(predictedLufs(rig.predicted, rig.own) - measured) < 0.6);
    }
}

TEST_CASE("With the preset's own material and mallet the gain is 0, whatever else changes") {
    const auto& preset = factoryPresets().front();
    LoudnessRig rig(preset, strikeContact);
    auto now = preset.parameters;
    for (const auto parameter : {malletSpeed, size, strikeAlong, tune, radiation, chatter, level})
        now.set(parameter, parameterInfo(parameter).maximum);
    CHECK(gainOf(*rig.match, now) == 0);
}

TEST_CASE("The gain from one mallet to another is the negative of the reverse gain") {
    const auto& preset = factoryPresets().front();
    const auto rubber = with(preset.parameters, mallet, firstRackMallet + 2);
    const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
    const LoudnessMatch there({instrument, {}, sampleRateHz}, preset.parameters);
    const LoudnessMatch back({instrument, {}, sampleRateHz}, rubber);
    const double gain = gainOf(there, rubber);
    CHECK(gain > 3);
    CHECK(std::abs(gain + gainOf(back, preset.parameters)) < 1e-9);
}

TEST_CASE("The gain is finite and at most 40 dB, and 0 if nothing sounds") {
    ObjectLibrary library;
    const auto bar = library.add("bar", syntheticObject({15, 440, 440, 9000}));
    KeyMap map;
    map.object = "bar";
    const auto instrument = Instrument::build(map, library).value();
    const ParameterValues own;
    const LoudnessMatch match({instrument, {}, sampleRateHz}, own);
    for (const int kind : {strikeContact, scrapeContact, rollContact})
        for (const auto parameter :
             {mallet, youngsModulus, density, fluidDamping, viscoelasticDamping, lossFactor,
              malletMass, malletHardness, modalPulse, contactSpeed, rollCoupling})
            for (const double value :
                 {parameterInfo(parameter).minimum, parameterInfo(parameter).maximum}) {
                auto now = with(with(own, material, customMaterial), parameter, value);
                now.set(contact, kind);
                INFO(parameterInfo(parameter).id << " " << value);
                CHECK(std::abs(gainOf(match, now)) <= 40);
            }
    const Phrase silentPhrase(instrument, {}, 30);
    const LoudnessMatch silent(silentPhrase, own);
    CHECK(gainOf(silent, with(own, malletMass, 500)) == 0);
    CHECK(std::isinf(predictedLufs(silentPhrase, own)));
}

// Takes five minutes: run it by its tag after changes of the prediction, contacts or presets.
TEST_CASE("Every struck preset is predicted within 2 LU for other mallets and materials",
          "[.all]") {
    for (const auto& preset : keyedFactoryPresets()) {
        if (static_cast<int>(preset.parameters[contact]) != strikeContact)
            continue;
        LoudnessRig rig(preset, strikeContact, 8);
        std::vector<ParameterValues> settings;
        for (std::size_t racked = 0; racked < malletRack().size(); ++racked)
            settings.push_back(
                with(rig.own, mallet, static_cast<double>(firstRackMallet + racked)));
        for (const auto& figures : malletGrid)
            settings.push_back(of(figures, rig.own));
        for (const auto& figures : materialGrid)
            settings.push_back(of(figures, rig.own));
        for (const int velocity : PhrasePrediction::velocities)
            for (std::size_t k = 0; k < settings.size(); ++k)
                if (const auto error = rig.error(settings[k], velocity)) {
                    INFO(preset.name << ", velocity " << velocity << ", setting " << k);
                    CHECK(std::abs(error->predicted) < 2);
                }
    }
}
