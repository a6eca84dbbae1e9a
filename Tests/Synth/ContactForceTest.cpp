#include "Synth/ContactForce.h"

#include "Support/Larger.h"
#include "Support/Level.h"
#include "Support/Periodogram.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr double rateHz = 48000;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<const SurfaceProfile> profileOf(const Surface& surface, std::uint64_t seed = 1) {
    return std::make_shared<const SurfaceProfile>(surface, rateHz, seed);
}

ContactForce contactOn(const Surface& surface, const ContactForceSettings& settings = {}) {
    ContactForce contact(profileOf(surface), 7);
    contact.setSettings(settings);
    return contact;
}

/// Returns the force at constant motion, without its first second.
std::vector<float> steadyForce(ContactForce& contact, const ContactMotion& motion, double seconds) {
    std::vector<float> result;
    std::array<float, cellSamples> cell{};
    const auto cells = static_cast<int>((1 + seconds) * rateHz / cellSamples);
    for (int c = 0; c < cells; ++c) {
        contact.render(motion, cell);
        if (c >= static_cast<int>(rateHz) / cellSamples)
            result.insert(result.end(), cell.begin(), cell.end());
    }
    return result;
}

bool isSilent(std::span<const float> samples) {
    return std::ranges::all_of(samples, [](float sample) { return sample == 0; });
}

/// Returns the profile's period in seconds at a fraction of the reference speed.
double periodSeconds(double speedRatio) {
    return static_cast<double>(SurfaceProfile::periodSamples) / rateHz / speedRatio;
}

const Surface clearReson{
    .spectrumExponent = -1.2, .resonFrequencyHz = 3000, .resonDampingPerSecond = 300};

} // namespace

TEST_CASE("A scrape's reson peak is at the speed ratio times the reson frequency, within 2 %") {
    auto contact = contactOn(clearReson);
    for (const double speed : {0.125, 0.25, 0.5, 1.0}) {
        const Periodogram spectrum(steadyForce(contact, {speed, 1}, 4), rateHz);
        const double expectedHz = clearReson.resonFrequencyHz * speed;
        CHECK_THAT(spectrum.peakHz(expectedHz / 1.8, expectedHz * 1.8),
                   WithinRel(expectedHz, 0.02));
    }
}

TEST_CASE("Spectra at two speeds match when scaled by the speed ratio, within 1 dB up to 12 kHz") {
    auto contact = contactOn(clearReson);
    const Periodogram slow(steadyForce(contact, {0.5, 1}, periodSeconds(0.5) * 4), rateHz);
    const Periodogram fast(steadyForce(contact, {1, 1}, periodSeconds(1) * 4), rateHz);
    // One sound read twice as fast: the power in a band of twice the width is ∝ v.
    for (double lowHz = 100; lowHz < 12000 / 2.52; lowHz *= 1.26) {
        const double decibels = 10 * std::log10(fast.power(2 * lowHz, 2.52 * lowHz) /
                                                (2 * slow.power(lowHz, 1.26 * lowHz)));
        CHECK(std::abs(decibels) < 1);
    }
}

TEST_CASE("A scrape's rms is roughness times the root of v/v_max and F, within 5 %") {
    const auto surface = GENERATE(
        clearReson,
        Surface{.spectrumExponent = -1.66, .resonFrequencyHz = 400, .resonDampingPerSecond = 1000},
        Surface{.spectrumExponent = -1.4,
                .resonFrequencyHz = 9000,
                .resonDampingPerSecond = 4000,
                .referenceSpeedMetresPerSecond = 2,
                .roughness = 3});
    auto contact = contactOn(surface);
    for (const double ratio : {0.11, 0.2, 0.45, 0.7, 1.0})
        for (const double force : {0.1, 1.0, 30.0}) {
            const double speed = ratio * surface.referenceSpeedMetresPerSecond;
            const auto samples = steadyForce(contact, {speed, force}, periodSeconds(ratio));
            CHECK_THAT(rms(samples), WithinRel(surface.roughness * std::sqrt(ratio * force), 0.05));
        }
}

TEST_CASE("A scrape beyond the reference speed gets louder but not higher") {
    auto contact = contactOn(clearReson);
    const auto atReference = steadyForce(contact, {1, 1}, periodSeconds(1));
    const auto beyond = steadyForce(contact, {4, 1}, periodSeconds(1));
    CHECK_THAT(rms(beyond), WithinRel(2 * rms(atReference), 0.01));
    CHECK_THAT(Periodogram(beyond, rateHz).peakHz(1500, 6000),
               WithinRel(Periodogram(atReference, rateHz).peakHz(1500, 6000), 0.02));
}

TEST_CASE("A roll is darker than a scrape by more than an octave of centroid") {
    const Surface surface;
    auto scraping = contactOn(surface);
    auto rolling = contactOn(surface, {.kind = ContactKind::roll});
    const Periodogram scrape(steadyForce(scraping, {1, 1}, 3), rateHz);
    const Periodogram roll(steadyForce(rolling, {1, 1}, 3), rateHz);
    CHECK(roll.centroidHz() < scrape.centroidHz() / 2);
    CHECK(roll.centroidHz() > 20);
}

TEST_CASE("A roll without dry mix equals the scrape through a Butterworth low-pass") {
    const Surface surface{.spectrumExponent = -0.5};
    const double cutoffHz = GENERATE(100.0, 400.0);
    auto scraping = contactOn(surface);
    auto rolling =
        contactOn(surface, {.kind = ContactKind::roll, .rollLowPassHz = cutoffHz, .rollDryMix = 0});
    const Periodogram scrape(steadyForce(scraping, {1, 1}, 8), rateHz);
    const Periodogram roll(steadyForce(rolling, {1, 1}, 8), rateHz);
    for (const double ratio : {0.5, 1.0, 2.0, 4.0, 8.0}) {
        const double lowHz = ratio * cutoffHz / 1.03, highHz = ratio * cutoffHz * 1.03;
        const double decibels =
            10 * std::log10(roll.power(lowHz, highHz) / scrape.power(lowHz, highHz));
        const double butterworth = -10 * std::log10(1 + std::pow(ratio, 4));
        CHECK(std::abs(decibels - butterworth) < 0.5);
    }
}

TEST_CASE("A coupled mode raises the roll around its frequency by d/sqrt((w - r)^2 + d^2)") {
    const double modeHz = 1500, damping = 60;
    const Surface surface{.resonFrequencyHz = 4000, .resonDampingPerSecond = 20000};
    auto scraping = contactOn(surface);
    auto rolling =
        contactOn(surface, {.kind = ContactKind::roll, .rollDryMix = 0, .rollModalCoupling = 1});
    const CoupledMode mode{modeHz, damping};
    rolling.setCoupledModes({&mode, 1});
    const Periodogram scrape(steadyForce(scraping, {1, 1}, 20), rateHz);
    const Periodogram roll(steadyForce(rolling, {1, 1}, 20), rateHz);
    const auto filterPower = [&](double frequencyHz) {
        return roll.power(frequencyHz - 3, frequencyHz + 3) /
               scrape.power(frequencyHz - 3, frequencyHz + 3);
    };
    const double atPeak = filterPower(modeHz);
    CHECK(std::abs(10 * std::log10(atPeak)) < 0.5);
    for (const double awayHz : {10.0, 20.0, 50.0, 100.0})
        for (const double sign : {-1.0, 1.0}) {
            const double detuning = 2 * std::numbers::pi * awayHz;
            const double envelope = damping * damping / (detuning * detuning + damping * damping);
            const double decibels = 10 * std::log10(filterPower(modeHz + sign * awayHz) / atPeak);
            CHECK(std::abs(decibels - 10 * std::log10(envelope)) < 1.5);
        }
}

TEST_CASE("Coupled modes add the level that the coupling sets, for any number and damping") {
    const Surface surface{.resonFrequencyHz = 4000, .resonDampingPerSecond = 20000};
    const CoupledMode modes[] = {{400, 30}, {1000, 60}, {2500, 250}};
    auto scraping = contactOn(surface);
    const Periodogram scrape(steadyForce(scraping, {1, 1}, 20), rateHz);
    for (const double coupling : {0.25, 1.0, 4.0}) {
        auto rolling = contactOn(
            surface, {.kind = ContactKind::roll, .rollDryMix = 0.1, .rollModalCoupling = coupling});
        rolling.setCoupledModes(modes);
        const Periodogram roll(steadyForce(rolling, {1, 1}, 20), rateHz);
        for (const auto& mode : modes) {
            const double lowHz = mode.frequencyHz - 2, highHz = mode.frequencyHz + 2;
            // 0.9 of the low-pass, which turns the phase by nearly half a period far above its
            // cutoff.
            const double uncoupled = 0.1 - 0.9 * std::pow(100 / mode.frequencyHz, 2);
            const double decibels =
                10 * std::log10(roll.power(lowHz, highHz) / scrape.power(lowHz, highHz));
            INFO(mode.frequencyHz << " Hz, coupled by " << coupling);
            CHECK(std::abs(decibels - 20 * std::log10(uncoupled + coupling)) < 1);
        }
    }
}

TEST_CASE("At most eight coupled modes are used, and invalid ones are ignored") {
    const Surface surface;
    const ContactForceSettings settings{.kind = ContactKind::roll, .rollModalCoupling = 1};
    std::vector<CoupledMode> modes;
    for (int i = 0; i < 12; ++i)
        modes.push_back({300.0 + 200 * i, 20});
    auto eight = contactOn(surface, settings), twelve = contactOn(surface, settings);
    eight.setCoupledModes(std::span(modes).first(8));
    twelve.setCoupledModes(modes);
    CHECK(steadyForce(eight, {1, 1}, 0.1) == steadyForce(twelve, {1, 1}, 0.1));

    const CoupledMode senseless[] = {{notANumber, 5}, {500, notANumber}, {-3, 5},      {500, 0},
                                     {infinity, 5},   {500, infinity},   {23000, 0.1}, {0, 0}};
    auto without = contactOn(surface, settings), with = contactOn(surface, settings);
    with.setCoupledModes(senseless);
    CHECK(steadyForce(without, {1, 1}, 0.1) == steadyForce(with, {1, 1}, 0.1));
}

TEST_CASE("A contact without speed, without normal force or below the minimum speed has no force") {
    const Surface surface{.slowestSpeedMetresPerSecond = 0.1};
    auto contact = contactOn(surface);
    std::array<float, cellSamples> cell{};
    for (const ContactMotion still :
         {ContactMotion{0, 1}, ContactMotion{1, 0}, ContactMotion{0.099, 1}, ContactMotion{1, -2},
          ContactMotion{notANumber, 1}, ContactMotion{1, notANumber}, ContactMotion{}}) {
        CHECK(contact.render({0.5, 1}, cell));
        CHECK_FALSE(isSilent(cell));
        CHECK(contact.render(still, cell)); // the motion ends within this cell
        cell.fill(1);
        CHECK_FALSE(contact.render(still, cell));
        CHECK(isSilent(cell));
    }
}

TEST_CASE("A contact begins and ends without a step") {
    auto contact = contactOn(Surface{});
    std::array<float, cellSamples> first{}, steady{}, last{};
    contact.render({1, 1}, first);
    for (int c = 0; c < 100; ++c)
        contact.render({1, 1}, steady);
    contact.render({0, 0}, last);
    const double level = 0.5;
    CHECK(std::abs(first.front()) < level / 16);
    CHECK(std::abs(last.back()) < 1e-12);
    float previous = steady.back();
    for (const float sample : last) {
        CHECK(std::abs(sample - previous) < level / 3);
        previous = sample;
    }
}

TEST_CASE(
    "The same calls give the same bits, and another seed gives another place on the surface") {
    const auto profile = profileOf(Surface{});
    const auto play = [&](std::uint64_t seed, bool resetFirst) {
        ContactForce contact(profile, seed);
        contact.setSettings({.kind = ContactKind::roll, .rollModalCoupling = 0.5});
        const CoupledMode mode{700, 9};
        contact.setCoupledModes({&mode, 1});
        if (resetFirst) {
            steadyForce(contact, {0.6, 2}, 0.3);
            contact.reset();
        }
        std::vector<float> result;
        std::array<float, cellSamples> cell{};
        for (int c = 0; c < 300; ++c) {
            contact.render({0.5 + 0.4 * std::sin(c * 0.1), 1 + 0.5 * std::cos(c * 0.07)}, cell);
            result.insert(result.end(), cell.begin(), cell.end());
        }
        return result;
    };
    const auto once = play(3, false);
    CHECK(once == play(3, false));
    CHECK(once == play(3, true));
    const auto other = play(4, false);
    double product = 0;
    for (std::size_t i = 0; i < once.size(); ++i)
        product += static_cast<double>(once[i]) * other[i];
    product /= static_cast<double>(once.size());
    CHECK(std::abs(product) < 0.3 * rms(once) * rms(other));
}

TEST_CASE("The force stays below ten times its level under random speed, force, kind and modes") {
    // The narrowest reson at the highest frequency is the most critical case.
    const auto surface = GENERATE(
        Surface{.slowestSpeedMetresPerSecond = 0},
        Surface{.resonFrequencyHz = 20000,
                .resonDampingPerSecond = 1,
                .slowestSpeedMetresPerSecond = 0},
        Surface{.spectrumExponent = -4, .resonFrequencyHz = 10, .resonDampingPerSecond = 1e5});
    auto contact = contactOn(surface);
    std::mt19937 random(5);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::array<float, cellSamples> cell{};
    float highest = 0;
    const double loudest = surface.roughness * std::sqrt(2.0 * 5.0);
    for (int c = 0; c < 20000; ++c) {
        contact.setSettings({.kind = uniform() < 0.5 ? ContactKind::scrape : ContactKind::roll,
                             .rollLowPassHz = 20 + 5000 * uniform()});
        contact.render({uniform() < 0.2 ? 0 : 2 * uniform(), 5 * uniform()}, cell);
        for (const float sample : cell)
            highest = larger(highest, std::abs(sample));
    }
    CHECK(highest > loudest / 10);
    CHECK(highest < 10 * loudest);
}

TEST_CASE("The force is finite for any input values") {
    const Surface surface{.spectrumExponent = 1,
                          .resonFrequencyHz = 20000,
                          .resonDampingPerSecond = 1,
                          .referenceSpeedMetresPerSecond = 0.001,
                          .slowestSpeedMetresPerSecond = 0,
                          .roughness = 100};
    auto contact = contactOn(surface);
    const double figures[] = {0,     -0.0,   1,        1e-320,    1e-30,     1e30,
                              1e308, -1e308, infinity, -infinity, notANumber};
    std::array<float, cellSamples> cell{};
    bool finite = true;
    std::mt19937 random(2);
    const auto any = [&] { return figures[random() % std::size(figures)]; };
    for (int c = 0; c < 20000; ++c) {
        contact.setSettings({.kind = random() % 2 == 0 ? ContactKind::scrape : ContactKind::roll,
                             .rollLowPassHz = any(),
                             .rollDryMix = any(),
                             .rollModalCoupling = any()});
        const CoupledMode modes[] = {{any(), any()}, {any(), any()}, {500, any()}, {any(), 5}};
        contact.setCoupledModes(modes);
        contact.render({any(), any()}, cell);
        finite = finite && std::ranges::all_of(cell, [](float s) { return std::isfinite(s); });
    }
    CHECK(finite);
}
