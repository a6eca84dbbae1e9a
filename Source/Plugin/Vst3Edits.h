// Sends values to a VST3 host at once, without a message loop.
#pragma once

#include "Plugin/HostParameters.h"

#include <juce_audio_processors/juce_audio_processors.h>
#include <memory>

namespace idiophone {

/// JUCE's wrapper sends values to the host only from the message thread. On Linux this is a thread
/// of the plugin until the host offers its own run loop, which offline hosts such as pedalboard
/// never do.
class Vst3Edits final : public juce::VST3ClientExtensions {
public:
    /// [thread of the host's window] Keeps the host's handler; null means none.
    void setIComponentHandler(Steinberg::FUnknown* handler) override;
    /// [thread of the host's window] Sends all values. Returns false without a handler, as in other
    /// formats.
    bool send(const HostParameters& parameters) const;

    bool getPluginHasMainInput() const override { return hasMainInput; }
    bool hasMainInput = false; ///< false: its first input is a side chain; set before the host asks

private:
    std::shared_ptr<Steinberg::FUnknown> host; ///< an IComponentHandler, or null
};

} // namespace idiophone
