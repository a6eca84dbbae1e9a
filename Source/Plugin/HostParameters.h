// All parameters of the table as the host's parameters, loaded all at once from presets and states,
// and read by the audio thread as one snapshot.
#pragma once

#include "Plugin/HostParameter.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace idiophone {

class HostParameters {
public:
    /// Adds a parameter for every row to the processor, which owns them from then on.
    explicit HostParameters(juce::AudioProcessor& processor);

    HostParameter& operator[](ParameterId parameter) const {
        return *parameters[static_cast<std::size_t>(parameter)];
    }

    /// [any thread]
    ParameterValues values() const noexcept;

    /// [message side, one at a time] Sets all of them; a snapshot sees all or none.
    void load(const ParameterValues& values) noexcept;

    /// [message side, one at a time] Sets those in which the two differ, as `load` does, and leaves
    /// others to whoever moves them.
    void loadChanges(const ParameterValues& before, const ParameterValues& after) noexcept;

    /// [any thread] What `loadChanges` would leave.
    ParameterValues valuesAfter(const ParameterValues& before,
                                const ParameterValues& after) const noexcept;

    /// [any thread] How often each was set.
    using Moves = std::array<std::uint32_t, parameterCount>;
    Moves moves() const noexcept;

    /// [any thread] The values, but those that were set since are as they are.
    ParameterValues withMoved(const Moves& since, ParameterValues values) const noexcept;

    /// [message side] Tells the host and other listeners of all values, after `load`.
    void notifyListeners() const;
    /// [message thread] Of those that have moved since they were told.
    void notifyListenersOfMoved() const;

    /// [any thread] As each parameter does.
    void forgetTold() const noexcept;

    /// [audio thread] What holds for this callback. While a `load` is under way, what held before.
    const ParameterValues& snapshot() noexcept;

private:
    std::array<HostParameter*, parameterCount> parameters{};
    std::atomic<std::uint32_t> loads{0}; ///< odd while a load is under way
    ParameterValues lastSnapshot;        ///< the audio thread's
};

} // namespace idiophone
