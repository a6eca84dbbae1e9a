// One row of the parameter table as the host sees it: normalised, named, with text and unit. The
// value is kept in its unit, exactly.
#pragma once

#include "Parameters/ParameterTable.h"

#include <atomic>
#include <juce_audio_processors/juce_audio_processors.h>

namespace idiophone {

class HostParameter final : public juce::AudioProcessorParameterWithID {
public:
    explicit HostParameter(const ParameterInfo& info);

    /// [any thread] In the unit of the table.
    double exactValue() const noexcept { return exact.load(); }
    void setExactValue(double value) noexcept { exact.store(row.clamped(value)); }

    /// [audio thread] As a controller has it; `tellHost` tells the host.
    void moveByController(double value) noexcept;
    /// [message thread] Tells the host where a controller moved it since this was called last,
    /// unless it was moved otherwise since.
    void tellHost();

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
    std::atomic<bool> movedByController{false};  ///< since the host was told
    std::atomic<float> controlled{-1}, told{-1}; ///< normalised, by a controller and to the host
    static_assert(std::atomic<bool>::is_always_lock_free);
    static_assert(std::atomic<float>::is_always_lock_free);
    static_assert(std::atomic<double>::is_always_lock_free);
};

} // namespace idiophone
