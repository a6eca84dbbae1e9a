#include "Instrument/HandStrength.h"

#include "Instrument/HeldContacts.h"

#include <cmath>

namespace idiophone {
namespace {

/// What the prediction of scrapes leaves out, by measurement over the factory presets.
constexpr double scrapeConstantDb = 0;

} // namespace

double handStrength(const LoudnessMatch& loudness, const ParameterValues& own) {
    if (!strikes(own))
        return 1;
    auto scraped = own;
    scraped.set(ParameterId::contact, scrapeContact);
    for (const auto figure :
         {ParameterId::contactForce, ParameterId::contactSpeed, ParameterId::roughness})
        scraped.set(figure, parameterInfo(figure).defaultValue);
    const double weaker = loudness.predictedLufs(own)[PhrasePrediction::middleVelocity] -
                          loudness.predictedLufs(scraped)[PhrasePrediction::middleVelocity];
    return std::isfinite(weaker) ? std::pow(10, (weaker + scrapeConstantDb) / 20) : 1;
}

} // namespace idiophone
