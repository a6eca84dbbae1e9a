// Assigns MIDI controllers to parameters. The audio thread sees the controllers, the message thread
// assigns them; this is the hand-off between them.
#pragma once

#include "Editor/MidiLearnView.h"
#include "Plugin/ControllerAssignments.h"
#include "Plugin/HostParameters.h"

#include <array>
#include <atomic>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {

/// Returns the value for a controller at 0 to 127, spread evenly over the parameter's scale.
/// Neither allocates nor locks.
double controlledValue(const ParameterInfo& info, int controllerValue) noexcept;

/// Each number is an atomic, and neither thread waits for the other.
class MidiLearn final : public MidiLearnView {
public:
    MidiLearn();

    /// [audio thread] Call before reading the parameters of a callback. Uses each controller's last
    /// value among these messages of the block. Neither allocates, locks nor throws.
    void follow(juce::MidiBufferIterator first,
                juce::MidiBufferIterator last,
                const HostParameters& parameters) noexcept;

    /// [message thread] Returns whether a controller was learned or forgotten since the last call.
    bool takeReassigned() noexcept { return reassigned.exchange(false); }

    /// [any thread except the audio thread]
    ControllerAssignments assignments() const noexcept;
    void assign(const ControllerAssignments& assignments) noexcept;

    std::optional<int> controllerOf(ParameterId parameter) const override;
    void learnController(ParameterId parameter) override { learning = static_cast<int>(parameter); }
    std::optional<ParameterId> learningParameter() const override;
    void stopLearning() override { learning = nothing; }
    void forgetController(ParameterId parameter) override;

private:
    static constexpr int nothing = -1;

    std::array<std::atomic<std::int8_t>, parameterCount> numbers;
    std::atomic<int> learning{nothing}; ///< a ParameterId, or `nothing`
    std::atomic<bool> reassigned{false};
    static_assert(std::atomic<std::int8_t>::is_always_lock_free);
    static_assert(std::atomic<int>::is_always_lock_free);
};

} // namespace idiophone
