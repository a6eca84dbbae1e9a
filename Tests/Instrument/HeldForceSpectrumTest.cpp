#include "Instrument/HeldForceSpectrum.h"

#include "Support/Periodogram.h"
#include "Synth/SurfaceProfile.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;
constexpr double fullTurn = 2 * std::numbers::pi;

double decibels(double power) {
    return 10 * std::log10(power);
}

/// Returns the force that ContactForce renders at a constant speed.
Periodogram rendered(const Surface& surface, double speed, const ContactForceSettings& settings) {
    ContactForce force(std::make_shared<const SurfaceProfile>(surface, sampleRateHz, 1), 1);
    force.setSettings(settings);
    std::vector<float> samples;
    std::array<float, cellSamples> cell;
    for (int k = 0; k < 6000; ++k) {
        force.render({.speedMetresPerSecond = speed, .normalForceNewtons = 1}, cell);
        samples.insert(samples.end(), cell.begin(), cell.end());
    }
    return {samples, sampleRateHz};
}

} // namespace

TEST_CASE("The spectra of scrapes and rolls match ContactForce within 1 dB from band to band") {
    for (const auto kind : {ContactKind::scrape, ContactKind::roll})
        for (const double speed : {0.3, 0.6, 1.0}) {
            const Surface surface;
            const ContactForceSettings settings{.kind = kind};
            const auto measured = rendered(surface, speed, settings);
            const HeldForceSpectrum force(surface, speed, settings, {}, sampleRateHz);
            const auto difference = [&](double hz) {
                double predicted = 0;
                for (int k = 0; k < 100; ++k)
                    predicted += force.smoothPower(fullTurn * hz * (0.9 + 0.2 * (k + 0.5) / 100));
                return decibels(measured.power(0.9 * hz, 1.1 * hz) / (predicted * hz));
            };
            const double reference = difference(1000);
            for (const double hz : {60.0, 200.0, 500.0, 2000.0, 4500.0}) {
                INFO(hz << " Hz at " << speed << " m/s");
                CHECK(std::abs(difference(hz) - reference) < 1);
            }
        }
}

TEST_CASE("The spectrum ends at the profile's highest frequency at the contact's speed") {
    const HeldForceSpectrum force({}, 0.25, {}, {}, sampleRateHz);
    CHECK(force.smoothPower(fullTurn * 5900) > 0);
    CHECK(force.smoothPower(fullTurn * 6100) == 0);
}

TEST_CASE("A coupled mode takes h^2 + hc + c^2/2 from a long note, and less from a short one") {
    const CoupledMode mode{.frequencyHz = 1000, .dampingPerSecond = 60};
    const ContactForceSettings settings{
        .kind = ContactKind::roll, .rollDryMix = 1, .rollModalCoupling = 2};
    const auto taken = [&](double damping) {
        const CoupledMode own{.frequencyHz = 1000, .dampingPerSecond = damping};
        const HeldForceSpectrum force({}, 1, settings, {&own, 1}, sampleRateHz);
        const HeldForceSpectrum plain({}, 1, {}, {}, sampleRateHz);
        return force.powerTakenBy(fullTurn * 1000, damping, 0) /
               plain.powerTakenBy(fullTurn * 1000, damping, 0);
    };
    CHECK(std::abs(decibels(taken(mode.dampingPerSecond) / 5)) < 0.3);
    CHECK(taken(0.5) < 2);
    CHECK(taken(0.5) > 1);
}
