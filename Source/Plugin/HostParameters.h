// Makes all parameters of the table the host's parameters. Presets and states load them all at
// once; the audio thread reads them as one snapshot.
#pragma once

#include "Plugin/HostParameter.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

namespace idiophone {

class HostParameters {
public:
    using MakeParameter = std::unique_ptr<HostParameter> (*)(const ParameterInfo& info);
    static std::unique_ptr<HostParameter> makePlain(const ParameterInfo& info) {
        return std::make_unique<HostParameter>(info);
    }

    /// Makes a parameter for every row and adds it to the processor, which then owns it.
    explicit HostParameters(juce::AudioProcessor& processor, MakeParameter make = makePlain);

    HostParameter& operator[](ParameterId parameter) const {
        return *parameters[static_cast<std::size_t>(parameter)];
    }

    /// [any thread]
    ParameterValues values() const noexcept;
    /// [any thread] Returns what is heard; see HostParameter::modulatedValue.
    ParameterValues modulatedValues() const noexcept;

    /// [message side, one at a time] Sets all values; a snapshot sees all of them or none.
    void load(const ParameterValues& values) noexcept;

    /// [message side, one at a time] Sets the values that differ between `before` and `after`, all
    /// at once as `load` does. Keeps the others.
    void loadChanges(const ParameterValues& before, const ParameterValues& after) noexcept;

    /// [any thread] Returns the values that `loadChanges` would leave.
    ParameterValues valuesAfter(const ParameterValues& before,
                                const ParameterValues& after) const noexcept;

    /// [any thread] Returns how often each parameter was set.
    using Moves = std::array<std::uint32_t, parameterCount>;
    Moves moves() const noexcept;

    /// [any thread] Returns `values`, with the current value of every parameter set since.
    ParameterValues withMoved(const Moves& since, ParameterValues values) const noexcept;

    /// [message side] Reports all values to the host and other listeners, after `load`.
    void sendValues() const;
    /// [message thread] Reports only the values that changed since they were last sent.
    void sendMovedValues() const;

    /// [any thread] Calls `forgetLastSent` on every parameter.
    void forgetLastSent() const noexcept;

    /// [audio thread] Brings the modulated values up to date, or leaves them unchanged during a
    /// `load`.
    void read(ParameterValues& values) const noexcept;

private:
    std::array<HostParameter*, parameterCount> parameters{};
    std::atomic<std::uint32_t> loads{0}; ///< odd while a load is under way
};

} // namespace idiophone
