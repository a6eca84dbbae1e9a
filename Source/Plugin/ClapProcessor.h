// The processor in a CLAP host, which also sends expressions of single notes.
#pragma once

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
        return space == CLAP_CORE_EVENT_SPACE_ID && ClapNotes::handles(type);
    }
    /// [audio thread] The next `processBlock` plays the event.
    void handleDirectEvent(const clap_event_header_t* event, int sampleOffset) override;

    void processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override;
    using Processor::processBlock;
    void reset() override;

private:
    ClapNotes notes;
};

} // namespace idiophone
