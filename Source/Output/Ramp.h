// A value that moves to each new target over a fixed time and ends at exactly that target.
#pragma once

#include <cmath>

namespace idiophone {

/// How a ramp gets from one sample to the next: by equal differences, or by equal ratios. Ratios
/// need positive values.
enum class RampSteps { differences, ratios };

/// `prepare` is for any thread while nothing else uses the ramp, the rest for the audio thread.
template <RampSteps steps = RampSteps::differences>
class Ramp {
public:
    /// Sets the length of all later ramps and ends the present one.
    void prepare(double sampleRateHz, double seconds) noexcept {
        length = static_cast<int>(std::floor(seconds * sampleRateHz));
        jumpTo(goal);
    }

    /// Starts a ramp from the present value, unless the target is the same as before.
    void moveTo(float target) noexcept {
        if (target == goal)
            return;
        if (length <= 0)
            return jumpTo(target);
        goal = target;
        samplesLeft = length;
        const auto count = static_cast<float>(length);
        step = steps == RampSteps::ratios ? std::exp((std::log(goal) - std::log(value)) / count)
                                          : (goal - value) / count;
    }

    void jumpTo(float target) noexcept {
        value = goal = target;
        samplesLeft = 0;
    }
    void jumpToTarget() noexcept { jumpTo(goal); }

    /// Moves on by a sample and returns its value.
    float next() noexcept {
        if (samplesLeft == 0)
            return goal;
        if (--samplesLeft == 0)
            value = goal;
        else
            value = steps == RampSteps::ratios ? value * step : value + step;
        return value;
    }

    bool isMoving() const noexcept { return samplesLeft > 0; }
    float current() const noexcept { return value; }
    float target() const noexcept { return goal; }

private:
    static constexpr float neutral = steps == RampSteps::ratios ? 1 : 0;
    float value = neutral, goal = neutral;
    float step = 0;
    int length = 0; ///< in samples, as `samplesLeft`
    int samplesLeft = 0;
};

} // namespace idiophone
