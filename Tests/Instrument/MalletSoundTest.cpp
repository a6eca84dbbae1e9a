// Tests how mallets, chatter and modal pulses change the rendered sound.
#include "Instrument/FactoryContent.h"
#include "Instrument/LowestModes.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "Instrument/SettingsOfParameters.h"
#include "SameInAllBlocks.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

namespace {

constexpr double sampleRateHz = 48000;

const Preset& xylophonePreset() {
    return factoryPresets().front();
}

std::shared_ptr<const Instrument> xylophone() {
    return Instrument::build(xylophonePreset().keyMap, ObjectLibrary::shared()).value();
}

ParameterValues xylophoneWith(std::size_t rackIndex) {
    auto parameters = xylophonePreset().parameters;
    parameters.set(mallet, static_cast<double>(rackIndex + firstRackMallet));
    parameters.set(strikeSpread, 0);
    return parameters;
}

/// Returns the mean frequency of the power spectrum.
double spectralCentroidHz(const std::vector<float>& sound) {
    std::vector<std::complex<float>> spectrum;
    Eigen::FFT<float>().fwd(spectrum, sound);
    double moment = 0, power = 0;
    for (std::size_t k = 1; k < sound.size() / 2; ++k) {
        const double weight = std::norm(std::complex<double>(spectrum[k]));
        moment += static_cast<double>(k) * weight;
        power += weight;
    }
    return moment / power * sampleRateHz / static_cast<double>(sound.size());
}

/// CHECKs that the centroid never falls by 1 % from one velocity to the next, and that the last is
/// above the first. It hardly moves where a partial passes a dip of the contact's spectrum.
void checkCentroidRises(const std::shared_ptr<const Instrument>& instrument,
                        int note,
                        std::size_t rackIndex,
                        double sizeRatio) {
    auto parameters = xylophoneWith(rackIndex);
    parameters.set(size, sizeRatio);
    parameters.set(keepPitch, 0);
    parameters.set(radiation, 0); // from afar the tube would dominate
    double first = 0, last = 0;
    for (const int velocity : {16, 32, 48, 64, 80, 96, 112, 127}) {
        Player player(instrument, sampleRateHz);
        const auto centroid = spectralCentroidHz(
            render(player, {midi(0, 0x90, note, velocity)}, 32768, 480, parameters));
        INFO(malletRack()[rackIndex].name << " on " << note << " at velocity " << velocity
                                          << ", size " << sizeRatio << ": " << centroid
                                          << " Hz after " << last);
        CHECK(centroid > 0.99 * last); // brass soon excites all modes equally
        last = centroid;
        first = first == 0 ? centroid : first;
    }
    CHECK(last > 0.999 * first);
}

/// Fast notes at odd samples, so that trains overlap.
std::vector<MidiEvent> hurry(int samples) {
    std::vector<MidiEvent> events;
    for (int i = 0, time = 3; time < samples; ++i, time += 61 + 37 * (i % 11)) {
        events.push_back(midi(time, 0x90, 72 + i * 5 % 37, 127 - i * 7 % 90));
        if (i % 13 == 12)
            events.push_back(midi(time + 20, 0xb0, i % 26 == 12 ? 120 : 123, 0));
        if (i % 5 == 4)
            events.push_back(midi(time + 30, 0xe0, 0, 32 + i % 64));
    }
    return events;
}

} // namespace

TEST_CASE("The spectral centroid rises with velocity for every mallet on every key with a short "
          "contact") {
    // Short means up to two periods. Longer contacts leave a faint sound whose partials come and
    // go.
    const auto instrument = xylophone();
    int heard = 0;
    for (const double sizeRatio : {1.0, 2.0, 4.0}) // also plays the C5 bar as C4 and C3
        for (const int note : {72, 84, 96, 108})
            for (std::size_t i = 0; i < malletRack().size(); ++i) {
                const auto& slot =
                    instrument->slots()[static_cast<std::size_t>(instrument->key(note).slot)];
                auto parameters = xylophoneWith(i);
                parameters.set(size, sizeRatio);
                const auto slowest = malletStrike(instrument->key(note).strip->at(0.5, 0), 16,
                                                  instrument->key(note).mallet, parameters, slot);
                const double hz = slot.object->dampedFrequencyHz(0) / sizeRatio;
                if ((sizeRatio > 1 && note != 72) || slowest.durationSeconds * hz >= 2)
                    continue;
                checkCentroidRises(instrument, note, i, sizeRatio);
                ++heard;
            }
    CHECK(heard >= 24);
}

TEST_CASE("Velocity changes the tone of a wound head more than that of a solid one") {
    // At twice its size the steel plate has modes on both sides of these contact times.
    const auto& preset = *findFactoryPreset("Steel Plate");
    const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
    const auto brightening = [&](std::size_t rackIndex) {
        auto parameters = preset.parameters;
        parameters.set(mallet, static_cast<double>(rackIndex + firstRackMallet));
        parameters.set(strikeSpread, 0);
        parameters.set(size, 2);
        parameters.set(radiation, 0);
        const auto centroid = [&](int velocity) {
            Player player(instrument, sampleRateHz);
            return spectralCentroidHz(
                render(player, {midi(0, 0x90, 72, velocity)}, 32768, 480, parameters));
        };
        return centroid(127) / centroid(30);
    };
    CHECK(brightening(0) > 1.3 * brightening(1));
}

TEST_CASE("A harder mallet of the rack makes the same strike on a bar brighter") {
    const auto instrument = xylophone();
    std::vector<double> centroids;
    for (std::size_t i = 0; i < malletRack().size(); ++i) {
        auto parameters = xylophoneWith(i);
        parameters.set(size, 4);
        parameters.set(keepPitch, 0);
        parameters.set(radiation, 0); // from afar the tube would dominate
        Player player(instrument, sampleRateHz);
        centroids.push_back(
            spectralCentroidHz(render(player, {midi(0, 0x90, 72, 100)}, 32768, 480, parameters)));
    }
    const double yarn = centroids[0], soft = centroids[1], medium = centroids[2],
                 hard = centroids[3], wood = centroids[4], plastic = centroids[5],
                 brass = centroids[6];
    CHECK(yarn > soft); // their contact times are equal at 1 m/s, and this strike is faster
    CHECK(medium > yarn);
    CHECK(hard > 1.1 * medium);
    CHECK(wood > 1.5 * hard);
    CHECK(plastic == Approx(wood).epsilon(0.01));
    CHECK(brass > 1.2 * plastic);
}

TEST_CASE("A brass mallet sounds darker on a softer live material of the same frequencies") {
    const auto instrument = xylophone();
    auto parameters = xylophoneWith(6);
    parameters.set(material, customMaterial);
    parameters.set(radiation, 0); // from afar the tube would dominate
    const auto centroid = [&] {
        Player player(instrument, sampleRateHz);
        return spectralCentroidHz(render(player, {midi(0, 0x90, 72, 100)}, 32768, 480, parameters));
    };
    const double firm = centroid();
    // Y/ρ stays the same, and with it every frequency.
    parameters.set(youngsModulus, parameters[youngsModulus] / 50);
    parameters.set(density, parameters[density] / 50);
    CHECK(centroid() < 0.8 * firm);
}

TEST_CASE("With chatter and modal pulses renders are bit-identical for all block sizes") {
    auto parameters = xylophoneWith(GENERATE(5u, 6u));
    parameters.set(chatter, 100);
    parameters.set(modalPulse, GENERATE(0, 1));
    parameters.set(letRing, 0);
    const auto sound = checkSameInBlocksOf({1, 7, 64, 480, 4096}, xylophone(), sampleRateHz,
                                           hurry(20000), 20000, parameters);
    CHECK(peak(sound.left) > 0.01f);
}

TEST_CASE("Chatter adds onsets within 15 ms of the strike and leaves soft mallets unchanged") {
    const auto instrument = xylophone();
    const auto sound = [&](std::size_t rackIndex, double percent) {
        auto parameters = xylophoneWith(rackIndex);
        parameters.set(chatter, percent);
        Player player(instrument, sampleRateHz);
        return render(player, {midi(0, 0x90, 72, 127)}, 9600, 64, parameters);
    };
    for (const std::size_t soft : {0u, 1u, 2u})
        CHECK(sound(soft, 100) == sound(soft, 0));
    CHECK(sound(6, 100) != sound(6, 0));
    // Further collisions start abruptly beside the smooth ringing of the single strike.
    const auto single = sound(6, 0), train = sound(6, 100);
    const float scale = train[4] / single[4];
    CHECK(scale < 1);
    CHECK(scale > 0.5f);
    std::vector<float> later(single.size());
    for (std::size_t k = 0; k < later.size(); ++k)
        later[k] = train[k] - scale * single[k];
    const auto first =
        std::ranges::find_if(later, [&](float x) { return std::abs(x) > 1e-3f * peak(single); });
    REQUIRE(first != later.end());
    const auto milliseconds = 1000 * static_cast<double>(first - later.begin()) / sampleRateHz;
    CHECK(milliseconds > 0.5);
    CHECK(milliseconds < 15);
}

TEST_CASE("All Sound Off ends a strike between its collisions") {
    auto parameters = xylophoneWith(6);
    parameters.set(chatter, 100);
    Player player(xylophone(), sampleRateHz);
    const auto sound =
        render(player, {midi(0, 0x90, 72, 127), midi(20, 0xb0, 120, 0)}, 9600, 64, parameters);
    CHECK(peak(std::span(sound).subspan(4800)) < 1e-5f * peak(sound));
    CHECK(player.silent());
}

TEST_CASE("A strike with modal pulses is four strikes of one period each, with the same impulse") {
    const auto instrument = xylophone();
    auto parameters = xylophoneWith(5);
    parameters.set(modalPulse, 1);
    parameters.set(tune, 250);
    parameters.set(tau, parameterInfo(tau).minimum);
    Player player(instrument, sampleRateHz);
    const auto sound = render(player, {midi(0, 0x90, 84, 90)}, 9600, 64, parameters);

    const auto& key = instrument->key(84);
    const auto& slot = instrument->slots()[static_cast<std::size_t>(key.slot)];
    const auto place = strikePlace(key.along, parameters, 0);
    const auto impact = malletStrike(key.strip->between(place.along, place.across).point, 90,
                                     key.mallet, parameters, slot);
    Synthesiser synthesiser({slot}, sampleRateHz);
    const auto settings = synthesisSettings(parameters);
    const auto modes =
        LowestModes(*slot.object).moved(liveConditions(slot, settings).frequencyRatio());
    std::vector<float> expected(9600);
    for (std::size_t at = 0; at < expected.size(); at += cellSamples) {
        alignas(64) std::array<float, cellSamples> cell{};
        synthesiser.setSettings(settings);
        synthesiser.beginCell(cell);
        if (at == 0)
            for (std::size_t mode = 0; mode < 4; ++mode) {
                Strike pulse = impact;
                for (float& component : pulse.impulseNewtonSeconds)
                    component /= 4;
                pulse.durationSeconds = 1 / modes.frequenciesHz[mode];
                REQUIRE(synthesiser.strike(0, pulse, 0, cell));
            }
        std::ranges::copy(cell, expected.begin() + static_cast<std::ptrdiff_t>(at));
    }
    float largest = 0;
    for (std::size_t k = 0; k < sound.size(); ++k)
        largest = std::max(largest, std::abs(sound[k] - expected[k]));
    CHECK(largest < 1e-5f * peak(expected));
}
