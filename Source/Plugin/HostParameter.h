// One row of the parameter table as the host sees it: normalised, named, with text and unit. Keeps
// the exact value in its unit. Hands the moves of a learned controller from the audio thread to the
// message thread, which reports them to the host.
#pragma once

#include "Parameters/ParameterTable.h"

#include <atomic>
#include <cstdint>
#include <juce_audio_processors/juce_audio_processors.h>

namespace idiophone {

class HostParameter : public juce::AudioProcessorParameterWithID {
public:
    explicit HostParameter(const ParameterInfo& info);

    /// [any thread] Returns the value in the unit of the table.
    double exactValue() const noexcept { return exact.load(); }
    void setExactValue(double value) noexcept;

    /// [audio thread] Moves the heard value by a share of the range on the parameter's own scale,
    /// −1 to 1. Only the engine reads it: value, window and state do not change.
    void setModulation(double share) noexcept { modulationShare = share; }
    /// [any thread] Returns the heard value in the unit of the table.
    double modulatedValue() const noexcept;
    /// [any thread] Returns it normalised.
    double modulatedNormalised() const noexcept { return normalisedWith(modulationShare); }
    /// [any thread] Returns the normalised value that another share would give.
    double normalisedWith(double share) const noexcept;

    /// [any thread] Returns how often the value was set, also to the same value.
    std::uint32_t moves() const noexcept { return timesSet; }

    /// [audio thread] Sets the value from a controller; `sendControllerMove` reports it to the
    /// host.
    void moveByController(double value) noexcept;
    /// [message thread] Reports the value to the host if a controller was the last to set it and it
    /// is still unreported. Makes a gesture of its own unless one is open.
    void sendControllerMove();
    /// [message thread] Begins and ends a gesture by hand. Gestures nest; the host gets only the
    /// outermost. `endGesture` returns whether it was the outermost.
    void beginGesture();
    bool endGesture();
    bool isInGesture() const noexcept { return openGestures > 0; }
    /// [message thread] Ends all open gestures.
    void endAllGestures();
    /// [message thread] Sets the value and reports it to the host, within a gesture; `changeByHand`
    /// makes one of its own unless one is open.
    void setByHand(double value);
    void changeByHand(double value);
    /// [any thread] Reports the value to the host and other listeners.
    void sendValue();
    /// [message thread] Reports the value if it differs from the last sent one and that one is not
    /// forgotten.
    void sendValueIfMoved();
    /// [any thread] Forgets the last sent value, so that nothing counts as its echo.
    void forgetLastSent() noexcept { lastSent = -1; }

    const ParameterInfo& info() const noexcept { return row; }

    float getValue() const override;
    /// Ignores a value equal to `getValue`, so that a host echo does not round the exact value.
    /// Also ignores an echo of the last sent value while a newer controller value is unreported.
    void setValue(float normalised) override;
    float getDefaultValue() const override;
    juce::String getText(float normalised, int maximumLength) const override;
    float getValueForText(const juce::String& text) const override;
    bool isDiscrete() const override;
    bool isBoolean() const override;
    int getNumSteps() const override;

private:
    const ParameterInfo& row;
    std::atomic<double> exact;
    std::atomic<double> modulationShare{0};
    std::atomic<bool> movedByController{
        false};                      ///< was the last to set it, and the host does not know yet
    std::atomic<float> lastSent{-1}; ///< last value sent to the host, normalised; −1: none
    std::atomic<std::uint32_t> timesSet{0};
    int openGestures = 0; ///< the message thread's
    static_assert(std::atomic<bool>::is_always_lock_free);
    static_assert(std::atomic<float>::is_always_lock_free);
    static_assert(std::atomic<double>::is_always_lock_free);
};

} // namespace idiophone
