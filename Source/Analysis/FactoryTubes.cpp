#include "Analysis/FactoryTubes.h"

#include "Analysis/FactoryBars.h"
#include "Analysis/TubeTuning.h"

#include <utility>

namespace idiophone {
namespace {

constexpr int lowestTubularBell = 60, highestTubularBell = 77; // MIDI, as written

TubeSpecification tubularBell(int note) {
    return {.name = "tubular-bell-" + std::to_string(note),
            .source = "generated brass tube, 38 x 1.5 mm as symphonic chimes; mode 4 an octave "
                      "above its note",
            .noteFrequencyHz = noteFrequencyHz(note),
            .material = *findMaterial("Brass")};
}

TubeSpecification windChime() {
    return {.name = "wind-chime",
            .source = "generated aluminium tube C6, 25 x 1.5 mm, after wind chimes",
            .noteFrequencyHz = noteFrequencyHz(84),
            .tunedMode = 1,
            .outerDiameterMetres = 0.025,
            .wallMetres = 0.0015,
            .rows = 80,
            .material = *findMaterial("Aluminium"),
            .maxFrequencyHz = 18000};
}

std::vector<TubeSpecification> tubes() {
    std::vector<TubeSpecification> all;
    for (int note = lowestTubularBell; note <= highestTubularBell; ++note)
        all.push_back(tubularBell(note));
    all.push_back(windChime());
    return all;
}

} // namespace

std::vector<std::string> factoryTubeNames() {
    std::vector<std::string> names;
    for (const auto& tube : tubes())
        names.push_back(tube.name);
    return names;
}

std::optional<Result<ModalObject>> makeFactoryTube(std::string_view name,
                                                   const WorkControl& control) {
    for (const auto& tube : tubes())
        if (tube.name == name)
            return tuneTube(tube, control).map([](TunedTube tuned) {
                return std::move(tuned.object);
            });
    return std::nullopt;
}

} // namespace idiophone
