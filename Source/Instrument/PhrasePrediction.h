// Predicts how loud an instrument plays a phrase, from its modes only. LoudnessMatch.h uses it.
#pragma once

#include "Instrument/HeardModes.h"
#include "Instrument/HeldContacts.h"
#include "Instrument/HeldForceSpectrum.h"
#include "Instrument/NearModes.h"
#include "Instrument/Phrase.h"
#include "Instrument/PhraseMeter.h"
#include "Instrument/StiffMotion.h"
#include "Instrument/StrikeSpectrum.h"
#include "Parameters/ParameterTable.h"

#include <array>
#include <complex>
#include <cstddef>

namespace idiophone {

/// Nothing allocates, locks or throws. Results depend on the arguments only.
class PhrasePrediction {
public:
    /// The velocities of the phrase; factory levels are set at the middle one.
    static constexpr std::array velocities{40, 100, 127};
    static constexpr std::size_t middleVelocity = 1;
    /// LUFS for each velocity (PhraseMeter.h; the mean of both channels, before `level`).
    using Loudness = std::array<double, velocities.size()>;

    /// Predicts, for a modulation wheel at 0 to 127.
    PhrasePrediction(const Phrase& phrase, const ParameterValues& parameters, int wheel) noexcept;

    /// Returns the loudness; −infinity if nothing sounds. The prediction leaves out `spread`,
    /// `imperfection`, and modes that τ and the mode budget drop. For keys that scrape or roll it
    /// lacks a constant that depends on speed, force and roughness, and is the same for all
    /// velocities.
    Loudness lufs() const noexcept;

private:
    static constexpr std::size_t levels = velocities.size();

    bool beginObject() noexcept;
    void beginStrikes() noexcept;
    RigidClick clickOf(const Strike& strike) const noexcept;
    void addClick(const RingingMode<levels>& mode, double weighting) noexcept;
    void beginForce(const SynthesisSettings& settings) noexcept;
    void endObject() noexcept;
    void addModes() noexcept;
    void addMode(RingingMode<levels>& mode, const ModalPole& pole) noexcept;
    /// Returns what meters the powers of `nearModes`.
    auto meterOf() noexcept {
        return [this](auto decay, const auto& powers) {
            const auto kind = held ? PhraseMeter::Note::sustained : PhraseMeter::Note::struck;
            for (std::size_t level = 0; level < levels; ++level)
                meters[level].addMode(kind, powers[level], decay, release);
        };
    }
    const SynthesiserSlot& slot() const noexcept;
    const LowestModes& lowestModes() const noexcept;

    const Phrase& phrase;
    ParameterValues presetValues;
    ParameterValues parameters; ///< with the material and mallet of the object's part
    int wheel = 0;
    std::array<PhraseMeter, levels> meters;

    // The object being processed.
    std::size_t firstNote = 0, endNote = 0; ///< the notes that play this object
    SlotHearing hearing;
    double release = 0; ///< [1/s]
    bool held = false;  ///< scraped or rolled
    std::array<PushedPoint, PhraseMeter::notes> points;
    /// A value for each velocity and note of a strike.
    template <class Value>
    using OfStrikes = std::array<std::array<Value, PhraseMeter::notes>, levels>;
    OfStrikes<ContactTrain> trains;
    OfStrikes<PressedMotion> pressed;
    OfStrikes<std::complex<double>> pressedVelocities{}; ///< complex, mean of the channels
    OfStrikes<RigidClick> clicks;
    OfStrikes<double> impulsesDuringClick{}; ///< [N s], 0 if the contact is shorter than the click
    /// K-weighted, mean of the channels; includes the interference with the modes.
    OfStrikes<double> clickEnergies{};
    HeldForceSpectrum force;
    StiffMotion stiff;
    NearModes<levels> nearModes;
};

/// As above, in one call. Takes about a millisecond: not for the audio thread.
PhrasePrediction::Loudness predictedLoudness(const Phrase& phrase,
                                             const ParameterValues& values,
                                             int wheel = HeldContacts::controllerAtRest) noexcept;

/// Returns the loudness at the middle velocity, with the wheel at rest.
inline double predictedLufs(const Phrase& phrase, const ParameterValues& values) noexcept {
    return predictedLoudness(phrase, values)[PhrasePrediction::middleVelocity];
}

} // namespace idiophone
