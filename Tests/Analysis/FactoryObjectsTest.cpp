// Tests of the stored factory bars: all of them as stored, and one of each instrument analysed
// again.
#include "Analysis/FactoryObjects.h"
#include "Analysis/FactoryBars.h"
#include "StoredObject.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <set>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("The factory makes exactly the stored objects, under 13 MB in total") {
    std::set<std::string> made, found;
    for (const auto& name : factoryObjectNames())
        CHECK(made.insert(name + ".modal").second);
    std::uintmax_t bytes = 0;
    for (const auto& file : std::filesystem::directory_iterator(storedObjects())) {
        found.insert(file.path().filename().string());
        bytes += file.file_size();
    }
    CHECK(made == found);
    CHECK(bytes < 13'000'000);
}

namespace {

/// Returns the audible frequency: the mean of two modes shared by bar and tube, weighted by power.
double heardHz(const ModalObject& bar, std::size_t mode) {
    double powers = 0, sum = 0;
    const double lambda = bar.eigenvalues[mode];
    for (std::size_t other = 0; other < bar.modeCount(); ++other) {
        const bool isPaired = !bar.gains.empty() && bar.gains[other] != 1.0f &&
                              std::abs(bar.eigenvalues[other] / lambda - 1) < 0.02;
        if (!isPaired && other != mode)
            continue;
        const double power =
            bar.gains.empty() ? 1 : static_cast<double>(std::norm(bar.gains[other]));
        powers += power;
        sum += power * bar.dampedFrequencyHz(other);
    }
    return sum / powers;
}

} // namespace

TEST_CASE("Every stored bar is in tune: fundamental within 1 cent, tuned partials within 2") {
    for (const auto& instrument : barInstruments())
        for (int note = instrument.lowestNote; note <= instrument.highestNote; ++note) {
            const auto asked = instrument.barAt(note, noteFrequencyHz(note));
            const auto bar = stored(asked.name);
            INFO(asked.name);
            const auto modes = verticalBendingModes(bar);
            const auto missCents = [&](std::size_t partial, double ratio) {
                return cents(heardHz(bar, static_cast<std::size_t>(modes.at(partial))),
                             ratio * noteFrequencyHz(note));
            };
            CHECK_THAT(missCents(0, 1), WithinAbs(0, 1)); // 0.5 from tuning, the rest from the tube
            if (asked.targets.secondRatio > 0)
                CHECK_THAT(missCents(1, asked.targets.secondRatio), WithinAbs(0, 2));
            if (asked.targets.thirdRatio > 0)
                CHECK_THAT(missCents(2, asked.targets.thirdRatio), WithinAbs(0, 2));
        }
}

TEST_CASE("A marimba bar's second partial decays by the loss factor of its wood") {
    {
        const auto* instrument = findBarInstrument("marimba");
        REQUIRE(instrument != nullptr);
        for (int note = instrument->lowestNote; note <= instrument->highestNote; ++note) {
            const auto bar = stored(instrument->barName(note));
            // The second bending mode has a node above the middle of the tube.
            const auto modes = verticalBendingModes(bar);
            if (modes.size() < 2)
                continue;
            const auto mode = static_cast<std::size_t>(modes[1]);
            INFO(instrument->barName(note));
            CHECK_THAT(2 * bar.decayPerSecond(mode) / std::sqrt(bar.eigenvalues[mode]),
                       WithinRel(bar.material.damping.lossFactor, 0.05));
        }
    }
}

TEST_CASE("Cords damp a metal bar's overtones more than its fundamental") {
    for (const char* name : {"vibraphone-65", "glockenspiel-91"}) {
        const auto bar = stored(name);
        const auto modes = verticalBendingModes(bar);
        const auto cordsPerSecond = [&](std::size_t partial) {
            const auto mode = static_cast<std::size_t>(modes.at(partial));
            return bar.decayPerSecond(mode) -
                   bar.material.damping.perSecond(bar.eigenvalues[mode]) / 2;
        };
        INFO(name);
        CHECK(cordsPerSecond(1) > 2);
        CHECK(cordsPerSecond(0) < cordsPerSecond(1) / 2);
    }
}

namespace {

/// A bar's fundamental on the left channel after an impulse on its middle.
struct HeardFundamental {
    double t60Seconds = 0; ///< three times the time from 5 to 25 dB below the maximum
    double levelDb = 0;    ///< energy of the first quarter of a second
};

HeardFundamental heardFundamental(const ModalObject& bar) {
    std::vector<std::complex<float>> weights(bar.modeCount());
    bar.radiation.weightsAt(0, 1, weights);
    const auto lowest = static_cast<std::size_t>(verticalBendingModes(bar).front());
    const double hz = bar.dampedFrequencyHz(lowest);
    constexpr double stepSeconds = 1e-3;
    std::vector<double> envelope;
    double energy = 0;
    for (int step = 0; step < 8000; ++step) {
        std::complex<double> sum = 0;
        for (std::size_t mode = 0; mode < bar.modeCount(); ++mode)
            if (std::abs(bar.dampedFrequencyHz(mode) / hz - 1) < 0.02) {
                const std::complex<double> pole(-bar.decayPerSecond(mode),
                                                2 * std::numbers::pi * bar.dampedFrequencyHz(mode));
                sum += std::complex<double>(weights[mode]) * std::exp(pole * (step * stepSeconds));
            }
        envelope.push_back(std::abs(sum));
        if (step * stepSeconds < 0.25)
            energy += std::norm(sum);
    }
    const auto loudest = std::ranges::max_element(envelope);
    const auto fallenBy = [&](double db) {
        return std::find_if(loudest, envelope.end(), [&](double level) {
            return level < *loudest * std::pow(10, -db / 20);
        });
    };
    return {3 * stepSeconds * static_cast<double>(fallenBy(25) - fallenBy(5)),
            10 * std::log10(energy)};
}

} // namespace

TEST_CASE("A tube makes a marimba's A3 decay clearly faster and 15 to 25 dB louder") {
    const auto* marimba = findBarInstrument("marimba");
    REQUIRE(marimba != nullptr);
    auto without = marimba->barAt(57, noteFrequencyHz(57));
    without.tube.reset();
    const auto alone = tuneBar(without);
    REQUIRE(alone);
    const auto bare = heardFundamental(alone->object),
               tubed = heardFundamental(stored("marimba-57"));
    CAPTURE(bare.t60Seconds, tubed.t60Seconds, tubed.levelDb - bare.levelDb);
    // Fletcher & Rossing 1998, section 19.5: about 3 s without and 1.5 s with the tube.
    CHECK(bare.t60Seconds > 2);
    CHECK(bare.t60Seconds < 4);
    CHECK(tubed.t60Seconds > 1);
    CHECK(tubed.t60Seconds < 0.75 * bare.t60Seconds);
    CHECK(tubed.levelDb - bare.levelDb > 15);
    CHECK(tubed.levelDb - bare.levelDb < 25);
}

TEST_CASE("One bar of each instrument and one shape, analysed again, equal the stored ones",
          "[.weekly]") {
    // Low bars take minutes, and any tubular bell takes half of one.
    std::vector<std::string> names{"small-ring"};
    for (const auto& instrument : barInstruments())
        if (const auto highest = instrument.barName(instrument.highestNote);
            !highest.starts_with("tubular"))
            names.push_back(highest);
    for (const auto& name : names) {
        INFO(name);
        const auto anew = makeFactoryObject(name);
        REQUIRE(anew);
        const auto object = stored(name);
        REQUIRE(anew->modeCount() == object.modeCount());
        for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
            CHECK_THAT(object.eigenvalues[mode], WithinRel(anew->eigenvalues[mode], 1e-6));
        CHECK(object.faces == anew->faces);
        CHECK(object.provenance.analysedVertices == anew->provenance.analysedVertices);
    }
}
