// Tests how evenly mallets drive a keyboard, by the spectrum of the force at each fundamental.
#include "Instrument/ContactTrain.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/HeldContacts.h"
#include "Instrument/Instrument.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/SettingsOfParameters.h"
#include "Instrument/StrikeSpectrum.h"
#include "Object/Mallet.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using enum ParameterId;

namespace {

/// The contact of one key and the lowest frequency of its object.
struct KeyContact {
    ContactTrain train;
    double fundamentalHz = 0;

    /// Returns 20 lg of the motion that the contact leaves at a frequency, for a residue of 1.
    double levelDb(double hz) const {
        return 20 * std::log10(std::abs(ringingVelocity(train, 1e-3, 2 * std::numbers::pi * hz)));
    }
};

std::vector<KeyContact>
contactsOf(const Instrument& instrument, const ParameterValues& parameters, int velocity) {
    std::vector<KeyContact> contacts;
    const auto& map = instrument.keyMap();
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        const auto& key = instrument.key(note);
        if (key.slot < 0)
            continue;
        const auto& slot = instrument.slots()[static_cast<std::size_t>(key.slot)];
        const auto place = aimedPlace(key.along, parameters);
        const auto point = key.strip->between(place.along, place.across).point;
        ContactTrain impact;
        impact.add({.delaySeconds = 0,
                    .strike = malletStrike(point, velocity, key.mallet, parameters, slot)});
        contacts.push_back(
            {withFilledNulls(impact), slot.object->dampedFrequencyHz(0) / slot.sizeRatio});
    }
    return contacts;
}

struct Played {
    Preset preset;
    std::shared_ptr<const Instrument> instrument;
};

std::vector<Played> struckPresets() {
    std::vector<Played> played;
    for (Preset preset : factoryPresets())
        if (preset.keyMap.kind != KeyMapKind::scene && strikes(preset.parameters)) {
            preset.keyMap.voicingDb.clear(); // voicing evens the radiation of bars, not contacts
            auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
            played.push_back({std::move(preset), std::move(instrument)});
        }
    return played;
}

/// The largest distance from the median of the keys within half an octave.
double unevennessDb(const std::vector<double>& levelsDb) {
    double worst = 0;
    for (std::size_t i = 0; i < levelsDb.size(); ++i) {
        const auto first = i < 6 ? 0 : i - 6, last = std::min(i + 7, levelsDb.size());
        std::vector<double> near(levelsDb.begin() + static_cast<std::ptrdiff_t>(first),
                                 levelsDb.begin() + static_cast<std::ptrdiff_t>(last));
        std::ranges::sort(near);
        worst = std::max(worst, std::abs(levelsDb[i] - near[near.size() / 2]));
    }
    return worst;
}

} // namespace

TEST_CASE("Contacts of up to 16 periods excite fundamentals within 6 dB of an octave's mean") {
    for (const auto& [preset, instrument] : struckPresets())
        for (std::size_t i = 0; i < malletRack().size(); ++i)
            for (const int velocity : {20, 100}) {
                auto parameters = preset.parameters;
                parameters.set(mallet, static_cast<double>(i + firstRackMallet));
                INFO(preset.name << " under " << malletRack()[i].name << " at " << velocity);
                for (const auto& contact : contactsOf(*instrument, parameters, velocity)) {
                    if (contact.train.begin()->strike.durationSeconds * contact.fundamentalHz > 16)
                        continue;
                    double sum = 0;
                    int count = 0;
                    for (double octave = -0.5; octave <= 0.5; octave += 0.02, ++count)
                        sum += contact.levelDb(contact.fundamentalHz * std::exp2(octave));
                    INFO(contact.fundamentalHz << " Hz");
                    CHECK(contact.levelDb(contact.fundamentalHz) > sum / count - 6);
                }
            }
}

TEST_CASE("A preset's own mallet drives neighbouring keys evenly, also when it is soft") {
    for (const auto& [preset, instrument] : struckPresets()) {
        const auto spanDb = [&](int velocity) {
            std::vector<double> levels;
            for (const auto& contact : contactsOf(*instrument, preset.parameters, velocity))
                levels.push_back(contact.levelDb(contact.fundamentalHz));
            INFO(preset.name << " at " << velocity);
            if (preset.keyMap.kind == KeyMapKind::bars)
                CHECK(unevennessDb(levels) < 4);
            const auto [least, most] = std::ranges::minmax(levels);
            return most - least;
        };
        const double usualDb = spanDb(100);
        INFO(preset.name);
        CHECK(spanDb(40) < usualDb + 3);
        CHECK(spanDb(20) < usualDb + 9);
        CHECK(spanDb(127) < usualDb + 3);
    }
}
