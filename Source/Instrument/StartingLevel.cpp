#include "Instrument/StartingLevel.h"

#include "Instrument/ContactLaw.h"
#include "Instrument/LoudnessPhrase.h"
#include "Instrument/PhrasePrediction.h"
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

double loudestStrikePeak(const Phrase& phrase, const ParameterValues& parameters) {
    constexpr double heardSeconds = 0.05;
    Player player(phrase.instrument, phrase.sampleRateHz, phrase.surface, 1, parameters);
    std::vector<float> left(
        static_cast<std::size_t>(std::ceil(heardSeconds * phrase.sampleRateHz)));
    std::vector<float> right(left.size());
    double peak = 0;
    for (const auto& note : phrase.notes) {
        player.reset();
        player.prepare(parameters);
        player.process(
            {left, right},
            std::array{MidiEvent{.sampleOffset = 0,
                                 .bytes = {0x90, static_cast<std::uint8_t>(note.midiNote), 127}}},
            parameters);
        for (const auto* channel : {&left, &right})
            for (const float sample : *channel)
                peak = std::max(peak, static_cast<double>(std::abs(sample)));
    }
    return peak;
}

ParameterValues withAudibleMallet(const Phrase& phrase, const ParameterValues& values) {
    constexpr double faintestLufs =
        factoryChannelLufs - 12; // below this the level cannot compensate
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

double highestLevel(const Phrase& phrase, const ParameterValues& values) {
    const double peak = loudestStrikePeak(phrase, values);
    return hardestStrikeDecibels - 20 * std::log10(peak);
}

double startingLevel(const Phrase& phrase, const ParameterValues& values) {
    const double asLoud = factoryChannelLufs - predictedLufs(phrase, values);
    const double level = std::min(asLoud, highestLevel(phrase, values));
    return std::isfinite(level) ? level : values[ParameterId::level];
}

} // namespace idiophone
