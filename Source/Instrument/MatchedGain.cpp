#include "Instrument/MatchedGain.h"

namespace idiophone {

double MatchedGain::follow(const ParameterValues& values, int wheel, bool mayPredict) noexcept {
    if (wheel != seenWheel || values != seenValues) {
        seenValues = values;
        seenWheel = wheel;
        const auto next = match.goalOf(values, wheel);
        isPosted = isPosted && next == goal;
        goal = next;
    }
    if (!goal)
        return gainDb = 0;
    if (known.goal != *goal)
        find(mayPredict);
    if (known.goal == *goal)
        gainDb = known.gainDb;
    return gainDb;
}

/// Makes the goal known, if that can be done at once.
void MatchedGain::find(bool mayPredict) noexcept {
    if (mayPredict) {
        known = {.goal = *goal, .gainDb = match.gainDb(*goal)};
    } else if (!isPosted) {
        wanted.next() = *goal;
        wanted.publish();
        isPosted = true;
    } else if (const auto* answer = answers.take(); answer != nullptr && answer->goal == *goal) {
        known = *answer;
    }
}

void MatchedGain::answer() noexcept {
    if (const auto* asked = wanted.take()) {
        answers.next() = {.goal = *asked, .gainDb = match.gainDb(*asked)};
        answers.publish();
    }
}

} // namespace idiophone
