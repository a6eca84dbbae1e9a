// A blow as the contacts it is made of: hard things touch several times before they part (van den
// Doel, Kry & Pai 2001, impacts). Which mallet strikes and how hard stands in MalletStrike.h.
#pragma once

#include "Synth/Strike.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

struct TimedStrike {
    double delaySeconds = 0; ///< after the start of the blow
    Strike strike;
};

/// Contacts in the order in which they begin; the first begins with the blow. Does not allocate.
class ContactTrain {
public:
    static constexpr std::size_t mostCollisions = 6;
    static constexpr std::size_t mostModalPulses = 4;

    void add(const TimedStrike& contact) { contacts[used++] = contact; }
    std::size_t size() const { return used; }
    const TimedStrike* begin() const { return contacts.data(); }
    const TimedStrike* end() const { return contacts.data() + used; }

private:
    std::array<TimedStrike, mostModalPulses + mostCollisions - 1> contacts;
    std::size_t used = 0;
};

/// A hard blow as a first collision and two to five more, weaker and weaker and closer and closer,
/// that all end within 15 ms (of a mallet scaled by s < 1: 15 s ms) of its start. Their impulses
/// sum to the blow's; up to half of it, at `chatterPercent` 100 and no contact time, goes to the
/// further collisions. Contacts of 1 ms (s ms) and longer do not chatter, and a blow that does not
/// is the strike itself. Number, times and impulses are drawn from `strikeNumber`. Any thread.
ContactTrain contactTrain(const Strike& strike,
                          double malletScale,
                          double chatterPercent,
                          std::uint32_t strikeNumber);

/// The train with the pulse of its first collision as three overlapping raised cosines, which end
/// with it and sum to its impulse. A single one has nulls at 2/T, 3/T, ..., which silence a key
/// whose partials lie there. The force of a real blow has none so deep: the head loses energy and
/// the object's own motion interrupts it. Shares, lengths and delays are those whose spectrum
/// deviates least, 4.6 dB up to 16/T, from the upper hull of the spectrum of the pulse of Hertz, F
/// ∝ sin^(3/2) (πt/T). Any thread.
ContactTrain withFilledNulls(const ContactTrain& train);

/// The train with its first collision as simultaneous raised-cosine pulses of equal impulse, one as
/// long as the period of each of the first `mostModalPulses` of these frequencies (van den Doel,
/// Kry & Pai 2001, impacts: convincing for a small hard striker on a large resonator). Without
/// frequencies the train itself. Any thread.
ContactTrain withModalPulses(const ContactTrain& train, std::span<const double> frequenciesHz);

} // namespace idiophone
