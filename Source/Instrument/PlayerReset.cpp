// The part of Player that finds whether it is silent, and resets it.
#include "Instrument/Player.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

/// Returns a strike number that is the same for all places near a beat, 0 for the first beat, and
/// far apart between beats. A host reports a loop that ends within a block at a place after its
/// start. The boundary is 0.1 beats before a beat, because songs seldom begin there.
std::uint32_t strikesBefore(double beats) {
    const auto beat = static_cast<std::int64_t>(std::floor(beats + 0.1));
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(beat) * 0x9e3779b97f4a7c15u >> 32);
}

} // namespace

bool Player::beginSong() {
    const bool beginsAnew = silent();
    const auto before = strikesBefore(songPlace.value_or(0));
    if (beginsAnew)
        forgetSound();
    strikeCount = firstStrikeNumber + before;
    if (performance) {
        if (beginsAnew)
            performance->reset();
        performance->countNotesFrom(before);
    }
    loudness.beginSong();
    return beginsAnew;
}

/// Returns the sound and the grid to the start, and keeps keys and controllers.
void Player::forgetSound() {
    synth.reset();
    glide.reset();
    leftCell.fill(0);
    rightCell.fill(0);
    cellPosition = cellSamples;
    cellIndex = -1;
    strikeCount = firstStrikeNumber;
    gainAtCellStart = gainAtCellEnd = 1;
    motor.reset();
    pending.clear();
    held.forgetAll();
    slotTuning.reset();
    isSilenced = hasRemains = false;
}

void Player::reset() {
    forgetSound();
    if (performance)
        performance->reset();
    loudness.reset();
    late.clear();
    surfaceStrikes.clear();
    std::fill(slotTouched.begin(), slotTouched.end(), false);
    held.reset();
    handScrape.reset();
    playedLast.reset();
    keysDown = {};
    forgetPressures();
    liftPedals();
    bend.reset();
    allSoundOffCame = false;
    silencedSamples = 0;
}

bool Player::silent() const {
    const auto played = [this](const auto& samples) {
        return std::all_of(samples.begin() + cellPosition, samples.end(),
                           [](float x) { return x == 0; });
    };
    return !hasRemains && synth.silent() && (!performance || performance->silent()) &&
           pending.empty() && late.empty() && surfaceStrikes.empty() && held.silent() &&
           handScrape.silent() && played(leftCell) && played(rightCell);
}

} // namespace idiophone
