// Changes parameters for the window, as gestures that the host records and the history undoes.
#pragma once

#include "Editor/ParameterView.h"
#include "Plugin/HostParameters.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundSession.h"

#include <span>

namespace idiophone {

/// For the message thread.
class ParameterEdits final : public ParameterView {
public:
    ParameterEdits(const juce::AudioProcessor& processor,
                   HostParameters& hostParameters,
                   const SoundSession& soundSession,
                   SoundHistory& soundHistory)
        : plugin(processor), parameters(hostParameters), session(soundSession),
          history(soundHistory) {}

    double value(ParameterId parameter) const override {
        return parameters[parameter].exactValue();
    }
    double effectiveValue(ParameterId parameter) const override;
    double presetValue(ParameterId parameter) const override;
    void makeCustom(ParameterId figure) override;
    bool isLive(ParameterId parameter) const override;
    bool isOffered(ParameterId parameter) const override;
    void beginChange(ParameterId parameter) override;
    void change(ParameterId parameter, double value) override;
    void endChange(ParameterId parameter) override;
    void endAllChanges() override;

    /// Sets these parameters to the wanted values, each in a gesture.
    void changeTo(const ParameterValues& wanted, std::span<const ParameterId> changed);

private:
    const juce::AudioProcessor& plugin;
    HostParameters& parameters;
    const SoundSession& session;
    SoundHistory& history;
};

} // namespace idiophone
