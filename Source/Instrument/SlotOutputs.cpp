#include "Instrument/SlotOutputs.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr int outputCount = static_cast<int>(maximumOutputs);

/// Octaves from C1 on, in the numbering in which C4 is middle C; the outermost take those beyond.
int outputOfOctave(int note) {
    return std::clamp(note / 12 - 2, 0, outputCount - 1);
}

/// Keys go round the outputs. C2, the bass drum of General MIDI, is on the main one.
int outputOfKey(int note) {
    return (note + 4) % outputCount;
}

/// Parts go round the outputs, except those that name one.
int outputOfPart(const KitParts& parts, const KitPart* part) {
    if (part == nullptr)
        return 0;
    return part->output > 0 ? part->output - 1
                            : static_cast<int>(part - parts.begin()) % outputCount;
}

} // namespace

SlotOutputs::SlotOutputs(const Instrument& instrument)
    : inEffect(instrument.slots().size()), found(instrument.slots().size()) {
    for (auto& slots : wanted)
        slots.resize(inEffect.size());
    if (instrument.stage())
        return;
    for (int note = 127; note >= 0; --note) // the lowest key of a slot comes last
        for (const Key& key : instrument.keysOf(note)) {
            if (key.slot < 0)
                continue;
            const auto slot = static_cast<std::size_t>(key.slot);
            const auto put = [&](int choice, int output) {
                wanted[static_cast<std::size_t>(choice)][slot] = static_cast<std::uint8_t>(output);
            };
            put(outputsByPart, outputOfPart(instrument.keyMap().parts, key.part));
            put(outputsByOctave, outputOfOctave(note));
            put(outputsByKey, outputOfKey(note));
        }
}

bool SlotOutputs::find(int choice, OutputSet connected) {
    if (choice == foundFor && connected == foundAmong)
        return differs;
    foundFor = choice;
    foundAmong = connected;
    const auto& slots = wanted[static_cast<std::size_t>(std::clamp(choice, 0, outputChoices - 1))];
    std::ranges::transform(slots, found.begin(), [connected](std::uint8_t output) {
        return connected[output] ? output : std::uint8_t{0};
    });
    differs = found != inEffect;
    return differs;
}

} // namespace idiophone
