#include "Instrument/HandStrengths.h"

#include "Instrument/HeldContacts.h"
#include "Instrument/KeysBetween.h"
#include "Instrument/PhrasePrediction.h"

#include <cmath>

namespace idiophone {
namespace {

/// Corrects the predicted loudness of scrapes and sets their level below a strike. Measured over
/// the factory presets.
constexpr double scrapeConstantDb = 31;

ParameterValues scraping(ParameterValues values) {
    values.set(ParameterId::contact, scrapeContact);
    for (const auto figure :
         {ParameterId::contactForce, ParameterId::contactSpeed, ParameterId::roughness})
        values.set(figure, parameterInfo(figure).defaultValue);
    return values;
}

} // namespace

std::vector<double> handStrengths(const Phrase& phrase, const ParameterValues& own) {
    const auto& instrument = *phrase.instrument;
    std::vector<double> strengths(instrument.slots().size(), 1);
    if (!strikes(own) && !bows(own))
        return strengths;
    auto struck = own; // a bowed object has about the level of a struck one
    struck.set(ParameterId::contact, strikeContact);
    const auto scraped = scraping(own);
    std::map<int, double> weakerDb; // by key
    auto repeated = phrase;
    for (const auto& note : phrase.supports()) {
        if (note.key.slot < 0 || weakerDb.contains(note.midiNote))
            continue;
        repeated.notes.fill(note);
        if (const double weaker =
                predictedLufs(repeated, struck) - predictedLufs(repeated, scraped);
            std::isfinite(weaker))
            weakerDb[note.midiNote] = weaker;
    }
    if (weakerDb.empty())
        return strengths;
    // An object that several keys play has the mean over them.
    std::vector<double> sums(strengths.size(), 0), keys(strengths.size(), 0);
    for (int note = 0; note < 128; ++note)
        for (const Key& key : instrument.keysOf(note))
            if (key.slot >= 0) {
                sums[static_cast<std::size_t>(key.slot)] += valueBetweenKeys(weakerDb, note);
                keys[static_cast<std::size_t>(key.slot)] += 1;
            }
    for (std::size_t slot = 0; slot < strengths.size(); ++slot)
        if (keys[slot] > 0)
            strengths[slot] = std::pow(10, (sums[slot] / keys[slot] + scrapeConstantDb) / 20);
    return strengths;
}

} // namespace idiophone
