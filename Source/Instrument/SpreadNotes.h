// Picks a few keys that represent all: spread evenly from the lowest to the highest.
#pragma once

namespace idiophone {

/// Returns the note at `index`, 0 to `count` − 1, of `count` ≥ 2.
constexpr int spreadNote(int lowestNote, int highestNote, int index, int count) noexcept {
    return lowestNote + (highestNote - lowestNote) * index / (count - 1);
}

} // namespace idiophone
