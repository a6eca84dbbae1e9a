// Which MIDI controllers move which parameters: the hand-off between the audio thread, which sees
// the controllers, and the message thread, which assigns them.
#pragma once

#include "Editor/MidiLearnView.h"
#include "Plugin/ControllerAssignments.h"
#include "Plugin/HostParameters.h"

#include <array>
#include <atomic>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {

/// Each number is an atomic of its own: a thread sees another's change at its next look. Nobody
/// waits for anybody.
class MidiLearn final : public MidiLearnView {
public:
    MidiLearn();

    /// [audio thread] Before the parameters of a callback are read: each controller's last value
    /// among these messages of its block counts. Neither allocates, locks nor throws.
    void follow(juce::MidiBufferIterator first,
                juce::MidiBufferIterator last,
                const HostParameters& parameters) noexcept;

    /// [message thread] Tells the host of what controllers moved since it was told last. Not during
    /// an offline render: a host that echoes late would make the render depend on time.
    /// `openGestures` has how many by hand each parameter is in.
    void tellHost(const HostParameters& parameters,
                  const std::array<int, parameterCount>& openGestures);
    /// [message thread] Whether a controller was learned or forgotten since this was asked last.
    bool takeReassigned() noexcept { return reassigned.exchange(false); }

    /// [any thread but audio]
    ControllerAssignments assignments() const noexcept;
    void assign(const ControllerAssignments& assignments) noexcept;

    std::optional<int> controllerOf(ParameterId parameter) const override;
    void learnController(ParameterId parameter) override;
    std::optional<ParameterId> learningParameter() const override;
    void stopLearning() override;
    void forgetController(ParameterId parameter) override;

private:
    static constexpr int nothing = -1;

    std::array<std::atomic<std::int8_t>, parameterCount> numbers;
    std::atomic<int> learning{nothing}; ///< a ParameterId
    std::atomic<bool> reassigned{false};
    static_assert(std::atomic<std::int8_t>::is_always_lock_free);
    static_assert(std::atomic<int>::is_always_lock_free);
};

} // namespace idiophone
