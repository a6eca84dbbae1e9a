#include "Instrument/StartingLevel.h"

#include "Instrument/ContactLaw.h"
#include "Instrument/LoudnessPhrase.h"
#include "Instrument/PhrasePrediction.h"
#include "Instrument/Player.h"
#include "Instrument/SpreadNotes.h"
#include "Object/Mallet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace idiophone {
namespace {

constexpr double hardestStrikeDecibels = -3;

/// Returns the rack's choices of ParameterId::mallet, from the longest contact to the shortest.
std::vector<std::size_t> rackFromSoftToHard() {
    const auto rack = malletRack();
    std::vector<std::size_t> order(rack.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t k) {
        const auto law =
            contactLaw(rack[k].headRadiusMetres, rack[k].effectiveModulusPa, rack[k].forceExponent);
        return contactSeconds(law, rack[k].massKg, 1);
    });
    for (auto& k : order)
        k += firstRackMallet;
    return order;
}

} // namespace

double predictedLufs(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values) {
    return predictedLufs(Phrase(instrument, surface, sampleRateHz), values);
}

double loudestStrikePeak(const std::shared_ptr<const Instrument>& instrument,
                         const Surface& surface,
                         double sampleRateHz,
                         const ParameterValues& parameters) {
    constexpr int keys = 8;
    constexpr double heardSeconds = 0.05;
    Player player(instrument, sampleRateHz, surface, 1, parameters);
    std::vector<float> left(static_cast<std::size_t>(std::ceil(heardSeconds * sampleRateHz)));
    std::vector<float> right(left.size());
    const auto& map = instrument->keyMap();
    double peak = 0;
    for (int i = 0; i < keys; ++i) {
        const int note = spreadNote(map.lowestNote, map.highestNote, i, keys);
        player.reset();
        player.prepare(parameters);
        player.process({left, right},
                       std::array{MidiEvent{.sampleOffset = 0,
                                            .bytes = {0x90, static_cast<std::uint8_t>(note), 127}}},
                       parameters);
        for (const auto* channel : {&left, &right})
            for (const float sample : *channel)
                peak = std::max(peak, static_cast<double>(std::abs(sample)));
    }
    return peak;
}

ParameterValues withAudibleMallet(const std::shared_ptr<const Instrument>& instrument,
                                  const Surface& surface,
                                  double sampleRateHz,
                                  const ParameterValues& values) {
    // The level can compensate for a loudness down to this.
    constexpr double faintestLufs = factoryChannelLufs - 12;
    const Phrase phrase(instrument, surface, sampleRateHz);
    double loudest = predictedLufs(phrase, values);
    auto best = values;
    for (const auto choice : rackFromSoftToHard()) {
        if (loudest >= faintestLufs)
            break;
        auto with = values;
        with.set(ParameterId::mallet, static_cast<double>(choice));
        if (const double other = predictedLufs(phrase, with); other > loudest) {
            loudest = other;
            best = with;
        }
    }
    return best;
}

double highestLevel(const std::shared_ptr<const Instrument>& instrument,
                    const Surface& surface,
                    double sampleRateHz,
                    const ParameterValues& values) {
    const double peak = loudestStrikePeak(instrument, surface, sampleRateHz, values);
    return hardestStrikeDecibels - 20 * std::log10(peak);
}

double startingLevel(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values) {
    const double asLoud =
        factoryChannelLufs - predictedLufs(instrument, surface, sampleRateHz, values);
    const double level = std::min(asLoud, highestLevel(instrument, surface, sampleRateHz, values));
    return std::isfinite(level) ? level : values[ParameterId::level];
}

} // namespace idiophone
