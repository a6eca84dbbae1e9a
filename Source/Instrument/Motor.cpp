#include "Instrument/Motor.h"

#include <cmath>
#include <numbers>

namespace idiophone {

float Motor::advance(double turnsPerSecond, double depth) {
    constexpr double smoothingSeconds = 0.01;
    turn += turnsPerSecond * cellSeconds;
    turn -= std::floor(turn);
    depthNow += (depth - depthNow) * (1 - std::exp(-cellSeconds / smoothingSeconds));
    if (std::abs(depth - depthNow) < 1e-6)
        depthNow = depth;
    gainNow = static_cast<float>(1 - depthNow * (1 - std::cos(4 * std::numbers::pi * turn)) / 2);
    return gainNow;
}

void Motor::keepTo(double turns, bool isAtOnce) {
    constexpr double keepingSeconds = 0.1; // short, but too slow to be heard as a step
    const double wanted = turns - std::floor(turns);
    if (isAtOnce) {
        turn = wanted;
        return;
    }
    double distance = wanted - turn;
    distance -= std::round(2 * distance) / 2; // the discs are open twice a turn
    turn += (1 - std::exp(-cellSeconds / keepingSeconds)) * distance;
}

void Motor::reset() {
    turn = depthNow = 0;
    gainNow = 1;
}

} // namespace idiophone
