#include "Instrument/StartingLevel.h"

#include "Instrument/ContactLaw.h"
#include "Instrument/LoudestStrike.h"
#include "Instrument/LoudnessPhrase.h"
#include "Instrument/PhrasePrediction.h"
#include "Object/Mallet.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace idiophone {
namespace {

constexpr double hardestStrikeDecibels = -3;

double lufsOf(const Phrase& phrase, const ParameterValues& values) {
    return predictedLoudness(phrase, values)[PhrasePrediction::middleVelocity];
}

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
    return lufsOf(Phrase(instrument, surface, sampleRateHz), values);
}

ParameterValues withAudibleMallet(const std::shared_ptr<const Instrument>& instrument,
                                  const Surface& surface,
                                  double sampleRateHz,
                                  const ParameterValues& values) {
    constexpr double faintestLufs =
        factoryChannelLufs - 12; // below this the level cannot compensate
    const Phrase phrase(instrument, surface, sampleRateHz);
    double loudest = lufsOf(phrase, values);
    auto best = values;
    for (const auto choice : rackFromSoftToHard()) {
        if (loudest >= faintestLufs)
            break;
        auto with = values;
        with.set(ParameterId::mallet, static_cast<double>(choice));
        if (const double lufs = lufsOf(phrase, with); lufs > loudest) {
            loudest = lufs;
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
