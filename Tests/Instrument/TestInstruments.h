// Instruments to play in tests: synthetic objects under the keys, and the factory's plate.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/ObjectLibrary.h"
#include "Support/SyntheticObject.h"

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace idiophone::test {

/// Puts one object under all keys from `lowestNote` to `highestNote`. Zones share it; with `scaled`
/// each key has its own copy.
inline std::shared_ptr<const Instrument>
keysOn(ModalObject object, KeyMapKind kind, int lowestNote, int highestNote) {
    ObjectLibrary library;
    const auto kept = library.add("object", std::move(object));
    return Instrument::build({.kind = kind,
                              .lowestNote = lowestNote,
                              .highestNote = highestNote,
                              .resizedFrom = 1,
                              .resizedTo = 0, // no other keys sound
                              .object = "object"},
                             library)
        .value();
}

/// Keys 60 to 72: bars of two modes each, with different radiation to the left and right.
inline std::shared_ptr<const Instrument> bars() {
    ObjectLibrary library;
    std::vector<std::shared_ptr<const ModalObject>> kept;
    for (int note = 60; note <= 72; ++note) {
        const double frequencyHz = 440 * std::exp2((note - 69) / 12.0);
        auto bar = syntheticObject({frequencyHz, 3 * frequencyHz});
        bar.radiation = {.directions = {{-0.6f, 0, 0.8f}, {0.6f, 0, 0.8f}},
                         .frequencyRatios = {1},
                         .weights = {0.02f, -0.01f, 0.03f, 0.02f}};
        kept.push_back(library.add("bar-" + std::to_string(note), std::move(bar)));
    }
    return Instrument::build({.kind = KeyMapKind::bars,
                              .lowestNote = 60,
                              .highestNote = 72,
                              .resizedFrom = 1,
                              .resizedTo = 0,
                              .object = "bar-{note}"},
                             library)
        .value();
}

/// A steel plate. Keys 36 to 96 lie along a path over it, which by default begins in a corner.
inline std::shared_ptr<const Instrument> plate(std::vector<std::array<double, 3>> strikePath = {
                                                   {-1, -1, 0}, {0.3, 0.8, 0}}) {
    return Instrument::build({.kind = KeyMapKind::zones,
                              .lowestNote = 36,
                              .highestNote = 96,
                              .object = "plate",
                              .strikePath = std::move(strikePath)},
                             ObjectLibrary::shared())
        .value();
}

} // namespace idiophone::test
