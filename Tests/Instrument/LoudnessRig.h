// Plays and measures a preset, beside what LoudnessMatch predicts.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/LoudnessMatch.h"
#include "Instrument/LoudnessPhrase.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/PhrasePrediction.h"
#include "Instrument/Player.h"
#include "Instrument/Scatter.h"
#include "IntegratedLufs.h"
#include "Parameters/ModulationTable.h"
#include "Support/RenderNotes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace idiophone::test {

/// Plays and measures a preset whose keys have the contact `kind`. Several takes average out
/// chance. Strikes come a little early or late, so that they meet the ringing sound in different
/// phases. Scrapes and rolls start all over the surface's profile, because narrow modes hear only a
/// few of its harmonics.
class LoudnessRig {
public:
    static constexpr double sampleRateHz = 48000;

    explicit LoudnessRig(const Preset& preset, int kind, std::uint32_t takes = 1)
        : map(preset.keyMap), instrument(Instrument::build(map, ObjectLibrary::shared()).value()),
          predicted(instrument, preset.surface, sampleRateHz), own(preset.parameters) {
        own.set(ParameterId::contact, kind);
        own.set(ParameterId::matchLoudness, 1);
        // Random, or slow, so no prediction includes them.
        for (const auto parameter :
             {ParameterId::imperfection, ParameterId::strikeSpread, ParameterId::motorDepth})
            own.set(parameter, 0);
        for (const auto& route : modulationRoutes) // nor modulation
            own.set(route.source, 0);
        match.emplace(predicted, own);
        for (std::uint32_t take = 0; take < takes; ++take)
            voices.push_back(std::make_unique<Player>(
                instrument, sampleRateHz, preset.surface,
                strikes(own) ? preset.seed : preset.seed + seedsToNextPlace * take));
    }

    /// Returns the mean power of all takes, without matching.
    double loudness(ParameterValues parameters, double gainDb, int velocity = 100) {
        parameters.set(ParameterId::matchLoudness, 0);
        double power = 0;
        for (std::uint32_t take = 0; take < voices.size(); ++take) {
            voices[take]->reset();
            const auto sound = renderStereo(
                *voices[take], phraseOf(take, velocity),
                static_cast<std::size_t>(loudnessPhraseSeconds * sampleRateHz), 4800, parameters);
            power += std::pow(10, measuredLufs(sound, gainDb) / 10);
        }
        return 10 * std::log10(power / static_cast<double>(voices.size()));
    }

    struct Error {
        double matched;   ///< LU above the preset's own, with the gain applied
        double predicted; ///< LU above the prediction for that velocity
    };

    /// Returns nothing if the gain is at its bound. Measures near −23 LUFS, far from the absolute
    /// gate.
    std::optional<Error> error(const ParameterValues& now, int velocity = 100) {
        if (velocity != ownVelocity)
            measureOwn(velocity);
        const double gain = match->gainDb(now);
        if (std::abs(gain) >= 40)
            return {};
        const auto level =
            static_cast<std::size_t>(std::ranges::find(PhrasePrediction::velocities, velocity) -
                                     PhrasePrediction::velocities.begin());
        const double matched = loudness(now, ownLevel + gain, velocity) - ownLoudness;
        const double louder =
            predictedLoudness(predicted, now)[level] - predictedLoudness(predicted, own)[level];
        return Error{.matched = matched, .predicted = matched - gain - louder};
    }

    KeyMap map;
    std::shared_ptr<const Instrument> instrument;
    Phrase predicted;
    ParameterValues own;
    std::optional<LoudnessMatch> match;

private:
    /// Seed step that spreads 16 starts of contacts evenly over the profile.
    static constexpr std::uint32_t seedsToNextPlace = 60;

    static double measuredLufs(const StereoSound& sound, double gainDb) {
        const auto gain = static_cast<float>(std::pow(10, gainDb / 20));
        std::vector<float> interleaved;
        for (std::size_t i = 0; i < sound.left.size(); ++i) {
            interleaved.push_back(gain * sound.left[i]);
            interleaved.push_back(gain * sound.right[i]);
        }
        return integratedLufs(interleaved, 2, sampleRateHz);
    }

    void measureOwn(int velocity) {
        ownVelocity = velocity;
        ownLevel = 0;
        double lufs = loudness(own, 0, velocity);
        while (!std::isfinite(lufs))
            lufs = loudness(own, ownLevel += 40, velocity);
        ownLevel -= 23 + lufs;
        ownLoudness = loudness(own, ownLevel, velocity);
    }

    /// Shifts strikes by up to 30 ms, except in the first take.
    std::vector<MidiEvent> phraseOf(std::uint32_t take, int velocity) const {
        auto events = loudnessPhrase(map, velocity, sampleRateHz);
        const bool strays = take > 0 && strikes(own);
        for (std::size_t note = 1; strays && note < PhraseMeter::notes; ++note) {
            const double chance =
                scatter(PhraseMeter::notes * take + static_cast<std::uint32_t>(note));
            const int late = static_cast<int>(0.015 * (1 + chance) * sampleRateHz);
            events[2 * note - 1].sampleOffset += late; // the previous note's note-off
            events[2 * note].sampleOffset += late;
        }
        return events;
    }

    int ownVelocity = 0;
    double ownLevel = 0, ownLoudness = 0;
    std::vector<std::unique_ptr<Player>> voices;
};

} // namespace idiophone::test
