#include "Plugin/ClapProcessor.h"

namespace idiophone {

ClapProcessor::ClapProcessor(PluginKind kindOfPlugin) : Processor(kindOfPlugin) {
    parameters()[ParameterId::mpe].setExactValue(1);
}

void ClapProcessor::handleDirectEvent(const clap_event_header_t* event, int sampleOffset) {
    notes.follow(*event, sampleOffset,
                 {.isOn = parameters()[ParameterId::mpe].exactValue() >= 0.5,
                  .bendRangeSemitones = parameters()[ParameterId::mpeBendRange].exactValue()});
}

void ClapProcessor::processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) {
    Processor::processBlock(buffer, notes.takeWith(midi));
}

void ClapProcessor::reset() {
    notes.reset();
    Processor::reset();
}

} // namespace idiophone
