#include "Instrument/InputStrengths.h"

#include "Instrument/HeardModes.h"
#include "Instrument/KeysBetween.h"
#include "Instrument/MalletStrike.h"

#include <cmath>

namespace idiophone {
namespace {

constexpr double slowestDecay = 1e-3; // [1/s] as the engine's own bound

/// Returns the K-weighted energy [Pa² s] after an impulse of 1 N s at a key's place, mean of the
/// channels. The modes of such a broad excitation interfere little.
double energyOfImpulse(const Phrase& phrase, const Phrase::Note& note, ParameterValues values) {
    const auto& slot = phrase.instrument->slots()[static_cast<std::size_t>(note.key.slot)];
    if (note.key.part != nullptr)
        values = withPart(values, *note.key.part);
    const auto place = aimedPlace(note.key.along, values);
    PushedPoint pushed{.point = note.key.strip->between(place.along, place.across).point};
    pushed.push = listeningDirection(pushed.point);
    double energy = 0;
    forEachHeardMode<1>(*slot.object, SlotHearing(slot, synthesisSettings(values)), {&pushed, 1},
                        phrase.sampleRateHz, [&](const ModalPole& pole, const auto& residues) {
                            const double power =
                                (std::norm(residues[0][0]) + std::norm(residues[0][1])) / 2;
                            energy += kWeightingPower(naturalFrequencyHz(pole)) * power /
                                      (2 * std::max(pole.damping, slowestDecay));
                        });
    return energy;
}

/// Returns the mean power gain of K-weighting over the band of the sample rate.
double noiseWeighting(double sampleRateHz) {
    constexpr int bands = 256;
    double sum = 0;
    for (int band = 0; band < bands; ++band)
        sum += kWeightingPower((band + 0.5) / bands * sampleRateHz / 2);
    return sum / bands;
}

} // namespace

std::array<double, 128> inputStrengths(const Phrase& phrase, const ParameterValues& own) {
    std::array<double, 128> newtons{};
    std::map<int, double> known; // in dB, by key
    for (const auto& note : phrase.supports())
        if (note.key.slot >= 0 && !known.contains(note.midiNote))
            if (const double db = 10 * std::log10(energyOfImpulse(phrase, note, own));
                std::isfinite(db))
                known[note.midiNote] = db;
    if (known.empty())
        return newtons;
    // A sample of x newtons is an impulse of x / rate, so noise of the power σ² comes out at
    // σ² E / rate.
    const double rateHz = phrase.sampleRateHz;
    const double goalDb =
        10 * std::log10(noiseWeighting(rateHz) * rateHz) - own[ParameterId::level];
    for (int note = 0; note < 128; ++note)
        newtons[static_cast<std::size_t>(note)] =
            std::pow(10, (goalDb - valueBetweenKeys(known, note)) / 20);
    return newtons;
}

} // namespace idiophone
