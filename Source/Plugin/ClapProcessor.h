// The processor in a CLAP host, which also sends expressions of single notes, modulates parameters,
// and wants to know when notes end.
#pragma once

#include "Plugin/ClapModulation.h"
#include "Plugin/ClapNotes.h"
#include "Plugin/Processor.h"

#include <clap-juce-extensions/clap-juce-extensions.h>

namespace idiophone {

/// MPE is on until a state or the user switches it off, because note expressions need it.
class ClapProcessor final : public Processor,
                            public clap_juce_extensions::clap_juce_audio_processor_capabilities {
public:
    explicit ClapProcessor(PluginKind kind);

    bool supportsNoteExpressions() override { return true; }
    bool supportsDirectEvent(std::uint16_t space, std::uint16_t type) override {
        return space == CLAP_CORE_EVENT_SPACE_ID &&
               (ClapNotes::handles(type) || type == CLAP_EVENT_PARAM_MOD);
    }
    /// [audio thread] The next `processBlock` plays the event.
    void handleDirectEvent(const clap_event_header_t* event, int sampleOffset) override;

    bool supportsOutboundEvents() override { return true; }
    /// [audio thread] Sends the ends of notes.
    void addOutboundEventsToQueue(const clap_output_events* events,
                                  const juce::MidiBuffer& midi,
                                  int sampleOffset) override;

    /// Each key is a voice.
    bool supportsVoiceInfo() override { return true; }
    bool voiceInfoGet(clap_voice_info* info) override;

    void prepareToPlay(double sampleRateHz, int maximumBlockSize) override;
    void processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override;
    using Processor::processBlock;
    void reset() override;

private:
    void modulate(const clap_event_param_mod& event);
    void forgetNotes();

    ClapNotes notes;
    ClapModulation modulation;
};

} // namespace idiophone
