// A small instrument to sample.
#pragma once

#include "Instrument/ObjectLibrary.h"
#include "Sampling/StrikeSampler.h"
#include "Support/SyntheticObject.h"

namespace idiophone::test {

/// Returns one key, 60, that strikes an object with these modes.
inline SampledInstrument sampledBar(const std::vector<double>& frequenciesHz = {440, 1210},
                                    KeyMapKind kind = KeyMapKind::zones) {
    ObjectLibrary library;
    const auto object = library.add("bar", syntheticObject(frequenciesHz));
    Preset preset;
    preset.keyMap = {.kind = kind, .lowestNote = 60, .highestNote = 60, .object = "bar"};
    auto instrument = Instrument::build(preset.keyMap, library).value();
    return {.instrument = std::move(instrument),
            .preset = preset,
            .values = preset.parameters,
            .sampleRateHz = 48000};
}

} // namespace idiophone::test
