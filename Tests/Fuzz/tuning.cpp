// Fuzzes Scala scales, and keyboard mappings behind a zero byte.
#include "Fuzz/FuzzTarget.h"
#include "Instrument/ScalaTuning.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    const auto end = bytes.find('\0');
    ScalaTuning tuning{.scale = {.name = "fuzz.scl", .text = std::string(bytes.substr(0, end))},
                       .mapping = {}};
    if (end != std::string_view::npos)
        tuning.mapping = {.name = "fuzz.kbm", .text = std::string(bytes.substr(end + 1))};
    const auto keys = keyTuning(tuning);
    if (!keys)
        return claimSentence(keys.error());
    claimFinite(keys->semitonesFromEqual, "keys have pitches that are numbers");
    for (std::size_t note = 0; note < KeyTuning::notes; ++note) {
        const double hertz =
            440 * std::exp2((static_cast<double>(note) - 69 + keys->semitonesFromEqual[note]) / 12);
        claim(keys->unmapped[note] || (hertz > 0.99 && hertz < 101000),
              "keys have pitches from 1 Hz to 100 kHz");
    }
    claim(scaleTitle(tuning).size() <= bytes.size() + 20, "a title is no longer than the file");
}
