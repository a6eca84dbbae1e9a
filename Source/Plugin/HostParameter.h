// One row of the parameter table as the host sees it: normalised, named, with text and unit. The
// value is kept in its unit, exactly. It is also the hand-off of what a learned controller sets on
// the audio thread to the host, which is told on the message thread.
#pragma once

#include "Parameters/ParameterTable.h"

#include <atomic>
#include <cstdint>
#include <juce_audio_processors/juce_audio_processors.h>

namespace idiophone {

class HostParameter final : public juce::AudioProcessorParameterWithID {
public:
    explicit HostParameter(const ParameterInfo& info);

    /// [any thread] In the unit of the table.
    double exactValue() const noexcept { return exact.load(); }
    void setExactValue(double value) noexcept;

    /// [any thread] Grows with every value that is set, also where it stays.
    std::uint32_t moves() const noexcept { return timesSet; }

    /// [audio thread] As a controller has it; `tellHost` tells the host.
    void moveByController(double value) noexcept;
    /// [message thread] Tells the host where it is, if a controller moved it since this was called
    /// last and nothing else did since; as a gesture of its own, or within one by hand.
    void tellHost(bool isInGesture);
    /// [any thread] Tells the host and other listeners the value.
    void tellListeners();
    /// [message thread] The same where it is not what was told last, if that is not forgotten.
    void tellListenersIfMoved();
    /// [any thread] From now on nothing is an echo of what the host was told before.
    void forgetTold() noexcept { told = -1; }

    const ParameterInfo& info() const noexcept { return row; }

    float getValue() const override;
    /// A host that echoes what `getValue` said changes nothing: the exact value stays. Nor does one
    /// that echoes late what it was told, while it is to be told where the controller went since.
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
    std::atomic<bool> movedByController{false}; ///< last, and the host is still to be told
    std::atomic<float> told{-1};                ///< to the host last; normalised
    std::atomic<std::uint32_t> timesSet{0};
    static_assert(std::atomic<bool>::is_always_lock_free);
    static_assert(std::atomic<float>::is_always_lock_free);
    static_assert(std::atomic<double>::is_always_lock_free);
};

} // namespace idiophone
