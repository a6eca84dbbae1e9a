#include "Instrument/LoudnessPhrase.h"

#include "Instrument/Phrase.h"

namespace idiophone {
namespace {

MidiEvent event(int sample, int status, int note, int velocity) {
    return {.sampleOffset = sample,
            .bytes = {static_cast<std::uint8_t>(status), static_cast<std::uint8_t>(note),
                      static_cast<std::uint8_t>(velocity)}};
}

} // namespace

std::vector<MidiEvent> loudnessPhrase(const KeyMap& keyMap, int velocity, double sampleRateHz) {
    constexpr int noteOn = 0x90, noteOff = 0x80;
    const double noteSamples = PhraseMeter::noteSeconds * sampleRateHz;
    std::vector<MidiEvent> events;
    for (std::size_t i = 0; i < PhraseMeter::notes; ++i) {
        const int note = phraseNote(keyMap, i);
        const int time = static_cast<int>(static_cast<double>(i) * noteSamples);
        events.push_back(event(time, noteOn, note, velocity));
        events.push_back(event(time + static_cast<int>(noteSamples) - 100, noteOff, note, 0));
    }
    return events;
}

PlayedPhrase playLoudnessPhrase(const Preset& preset,
                                const std::shared_ptr<const Instrument>& instrument,
                                double sampleRateHz) {
    Player player(instrument, sampleRateHz, preset.surface, preset.seed, preset.matched());
    player.setOffline(true);
    player.setSilencedModes(silencedModes(*instrument, preset.mutedModes, {}));
    const auto samples = static_cast<std::size_t>(loudnessPhraseSeconds * sampleRateHz);
    PlayedPhrase phrase{.left = std::vector<float>(samples), .right = std::vector<float>(samples)};
    player.process({phrase.left, phrase.right},
                   loudnessPhrase(preset.keyMap, loudnessPhraseVelocity, sampleRateHz),
                   preset.parameters);
    return phrase;
}

} // namespace idiophone
