#include "Sampling/SfzText.h"

#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <algorithm>

namespace idiophone {
namespace {

// Only for programs that know no one_shot and convert the file: longer than samples ring.
constexpr double ringingSeconds = 60;

} // namespace

std::string sfzText(const SfzInstrument& instrument, std::span<const PlannedSample> samples) {
    std::string text =
        "// " + oneLine(instrument.name) + ", sampled by Idiophone (AGPL; the sound is yours).\n";
    text += "// The samples have a gain of " + numberText(instrument.gainDecibels) +
            " dB, which `volume` takes back. They end " + numberText(-instrument.tailDecibels) +
            " dB below their peaks.\n\n<global>\n";
    text += "volume=" + numberText(-instrument.gainDecibels) + "\namp_veltrack=0\n";
    if (instrument.releaseSeconds)
        text += "loop_mode=no_loop\nampeg_release=" + numberText(*instrument.releaseSeconds) + "\n";
    else
        text += "loop_mode=one_shot\nampeg_release=" + numberText(ringingSeconds) + "\n";
    if (!instrument.keysHavePitches)
        text += "pitch_keytrack=0\n";
    int turns = 1;
    for (const auto& sample : samples)
        turns = std::max(turns, sample.roundRobin);
    for (const auto& sample : samples) {
        if (sample.roundRobin == 1) {
            text += "\n<group>\nlokey=" + std::to_string(sample.lowestKey) +
                    " hikey=" + std::to_string(sample.highestKey) +
                    " pitch_keycenter=" + std::to_string(sample.key) +
                    " lovel=" + std::to_string(sample.lowestVelocity) +
                    " hivel=" + std::to_string(sample.velocity);
            text += turns > 1 ? " seq_length=" + std::to_string(turns) + "\n" : "\n";
        }
        text += "<region> ";
        if (turns > 1)
            text += "seq_position=" + std::to_string(sample.roundRobin) + " ";
        text += "sample=" + instrument.folder + sample.name + instrument.ending + "\n";
    }
    return text;
}

} // namespace idiophone
