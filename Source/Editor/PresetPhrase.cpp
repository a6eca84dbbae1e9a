#include "Editor/PresetPhrase.h"

#include <algorithm>

namespace idiophone {

void PresetPhrase::play() {
    stop();
    if (!instrument.isFreeToPlay())
        return;
    notes = phraseNotes(instrument, stage.hasStage());
    instrumentNumber = instrument.instrumentNumber();
    startMilliseconds = juce::Time::getMillisecondCounter();
    if (!notes.empty())
        startTimer(tickMilliseconds);
}

void PresetPhrase::stop() {
    stopTimer();
    for (std::size_t i = 0; i < started; ++i)
        instrument.playNote(notes[i].note, 0);
    notes.clear();
    started = 0;
    lateMilliseconds = 0;
}

void PresetPhrase::tick(int millisecondsSincePlay) {
    if (!instrument.isFreeToPlay() || instrument.instrumentNumber() != instrumentNumber)
        return stop();
    int now = millisecondsSincePlay - pauseMilliseconds - lateMilliseconds;
    if (started < notes.size() && notes[started].startMilliseconds <= now) {
        // While a sound is shown for the first time, ticks come late: keep the rhythm from here on.
        const int late = now - notes[started].startMilliseconds;
        lateMilliseconds += late;
        now -= late;
        instrument.playNote(notes[started].note, notes[started].velocity);
        ++started;
    }
    // Notes end in the order in which they start.
    while (started > 0 && notes.front().endMilliseconds <= now) {
        instrument.playNote(notes.front().note, 0);
        notes.erase(notes.begin());
        --started;
    }
    if (notes.empty())
        stop();
}

void PresetPhrase::timerCallback() {
    tick(static_cast<int>(juce::Time::getMillisecondCounter() - startMilliseconds));
}

} // namespace idiophone
