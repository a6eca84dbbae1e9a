// Keys held on contacts that scrape and roll, for the tests of HeldContacts.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <memory>
#include <utility>
#include <vector>

namespace idiophone::test {

constexpr double playRateHz = 48000;
constexpr int speedController = 1, placeController = 74;

/// Keys 40 to 80, each with its own object, which rings for about ten milliseconds.
inline std::shared_ptr<const Instrument> shortBars() {
    auto object = syntheticObject({300, 810, 1600, 2700});
    object.material.damping.fluidPerSecond = 1000;
    return keysOn(std::move(object), KeyMapKind::scaled, 40, 80);
}

/// Parameters for held keys; `choice` is scrapeContact, rollContact or strikeContact.
inline ParameterValues scraping(double choice = scrapeContact) {
    ParameterValues parameters;
    parameters.set(ParameterId::contact, choice);
    parameters.set(ParameterId::tau, 0.001);
    return parameters;
}

/// Returns the mean of both channels of a new player.
inline std::vector<float> play(const std::shared_ptr<const Instrument>& instrument,
                               const std::vector<MidiEvent>& events,
                               std::size_t samples,
                               const ParameterValues& parameters = scraping()) {
    Player player(instrument, playRateHz);
    return render(player, events, samples, 480, parameters);
}

} // namespace idiophone::test
