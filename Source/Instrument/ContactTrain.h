// Splits a strike into the contacts that it consists of: hard bodies touch several times before
// they part (van den Doel, Kry & Pai 2001, impacts). MalletStrike.h decides which mallet strikes
// and how hard.
#pragma once

#include "Synth/Strike.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

struct TimedStrike {
    double delaySeconds = 0; ///< after the start of the whole strike
    Strike strike;
};

/// Contacts in the order in which they begin; the first has no delay. Does not allocate.
class ContactTrain {
public:
    static constexpr std::size_t maximumCollisions = 6;
    static constexpr std::size_t maximumModalPulses = 4;

    void add(const TimedStrike& contact) { contacts[used++] = contact; }
    std::size_t size() const { return used; }
    const TimedStrike* begin() const { return contacts.data(); }
    const TimedStrike* end() const { return contacts.data() + used; }

private:
    std::array<TimedStrike, maximumModalPulses + maximumCollisions - 1> contacts;
    std::size_t used = 0;
};

/// Returns a hard strike as a first collision and two to five more. Each one is weaker than the one
/// before and follows sooner. All end within 15 ms of the start (15 s ms for a mallet scaled by s <
/// 1). Their impulses sum to the strike's. At `chatterPercent` 100 and zero contact time, the
/// further collisions get half of this sum. Contacts of 1 ms (s ms) and longer do not chatter: the
/// train is then the strike itself.
///
/// `strikeNumber` seeds the number, times and impulses. Any thread.
ContactTrain contactTrain(const Strike& strike,
                          double malletScale,
                          double chatterPercent,
                          std::uint32_t strikeNumber);

/// Returns the train with the pulse of its first collision split into three overlapping raised
/// cosines. They sum to its impulse and end with it.
/// A single raised cosine has nulls at 2/T, 3/T, ..., which silence a key whose partials lie there.
/// The force of a real strike has no nulls as deep: the head loses energy, and the object's own
/// motion interrupts the pulse.
/// The shares, lengths and delays minimise the deviation from the upper hull of the spectrum of the
/// pulse of Hertz, F ∝ sin^(3/2) (πt/T): 4.6 dB up to 16/T. Any thread.
ContactTrain withFilledNulls(const ContactTrain& train);

/// Returns the train with its first collision split into simultaneous raised-cosine pulses of equal
/// impulse. Each lasts one period of one of the first `maximumModalPulses` frequencies (van den
/// Doel, Kry & Pai 2001, impacts: convincing for a small hard striker on a large resonator).
/// Without frequencies it returns the train unchanged. Any thread.
ContactTrain withModalPulses(const ContactTrain& train, std::span<const double> frequenciesHz);

/// Returns the train as the synthesiser plays it: contacts that are too short for the sample rate
/// are impulses at their start. Any thread.
ContactTrain asPlayed(const ContactTrain& train, double sampleRateHz);

} // namespace idiophone
