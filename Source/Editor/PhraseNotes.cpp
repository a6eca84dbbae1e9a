#include "Editor/PhraseNotes.h"

#include <algorithm>
#include <array>
#include <span>

namespace idiophone {
namespace {

constexpr int phraseMilliseconds = 2000;

std::vector<int> ownKeys(const InstrumentView& instrument) {
    std::vector<int> keys;
    const auto sounds = instrument.keySounds();
    for (int note = 0; note < 128; ++note)
        if (sounds[static_cast<std::size_t>(note)] == InstrumentView::KeySound::own)
            keys.push_back(note);
    return keys;
}

/// Whether each key has a pitch of its own. Then other keys can be resized from it.
bool isTuned(const InstrumentView& instrument) {
    return instrument.playedObjects().size() > 1 ||
           std::ranges::count(instrument.keySounds(), InstrumentView::KeySound::resized) > 0;
}

/// The widest broken chord that the keys hold, over their middle.
std::vector<int> brokenChord(const std::vector<int>& keys) {
    constexpr std::array steps{0, 4, 7, 12, 16};
    const int range = keys.back() - keys.front();
    const auto count = static_cast<std::size_t>(
        std::ranges::count_if(steps, [&](int semitones) { return semitones <= range; }));
    const int root = keys.front() + (range - steps[count - 1]) / 2;
    std::vector<int> notes;
    for (const int semitones : std::span(steps).first(count))
        notes.push_back(*std::ranges::min_element( // not all keys may have a bar
            keys, {}, [&](int key) { return std::abs(key - root - semitones); }));
    return notes;
}

std::vector<int> spreadKeys(const std::vector<int>& keys) {
    const auto last = keys.size() - 1;
    return {keys[last / 4], keys[last / 2], keys[last * 3 / 4]};
}

} // namespace

std::vector<PhraseNote> phraseNotes(const InstrumentView& instrument, bool isStage) {
    const auto keys = ownKeys(instrument);
    if (keys.empty())
        return {};
    if (isStage)
        return {{0, phraseMilliseconds, keys[keys.size() / 2], 90}};
    const bool tuned = isTuned(instrument);
    const auto notes = tuned ? brokenChord(keys) : spreadKeys(keys);
    constexpr std::array velocities{78, 66, 84, 72, 100};
    const int apart = tuned ? 240 : 560;
    std::vector<PhraseNote> phrase;
    for (std::size_t i = 0; i < notes.size(); ++i) {
        const int start = static_cast<int>(i) * apart;
        const bool isLast = i + 1 == notes.size();
        phrase.push_back({start, tuned || isLast ? phraseMilliseconds : start + apart, notes[i],
                          isLast ? velocities.back() : velocities[i]});
    }
    return phrase;
}

} // namespace idiophone
