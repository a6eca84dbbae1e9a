#include "Plugin/ClapProcessor.h"

#include "Plugin/ClapParameter.h"

namespace idiophone {

ClapProcessor::ClapProcessor(PluginKind kindOfPlugin)
    : Processor(kindOfPlugin,
                [](const ParameterInfo& info) -> std::unique_ptr<HostParameter> {
                    return std::make_unique<ClapParameter>(info);
                }),
      modulation(parameters()) {
    parameters()[ParameterId::mpe].setExactValue(1);
}

void ClapProcessor::handleDirectEvent(const clap_event_header_t* event, int sampleOffset) {
    if (event->type == CLAP_EVENT_PARAM_MOD)
        return modulate(*reinterpret_cast<const clap_event_param_mod*>(event));
    const auto begun =
        notes.follow(*event, sampleOffset,
                     {.isOn = parameters()[ParameterId::mpe].exactValue() >= 0.5,
                      .bendRangeSemitones = parameters()[ParameterId::mpeBendRange].exactValue()});
    if (begun)
        modulation.beginNote(*begun);
}

void ClapProcessor::modulate(const clap_event_param_mod& event) {
    const auto* given = static_cast<const JUCEParameterVariant*>(event.cookie);
    if (given == nullptr) // a host may leave it out
        given = findParameterByParameterId(event.param_id);
    auto* const parameter =
        given != nullptr ? dynamic_cast<ClapParameter*>(given->processorParam) : nullptr;
    if (parameter != nullptr && parameter->supportsMonophonicModulation())
        modulation.follow(event, *parameter, notes);
}

void ClapProcessor::addOutboundEventsToQueue(const clap_output_events* events,
                                             const juce::MidiBuffer&,
                                             int sampleOffset) {
    notes.sendEnds(*events, sampleOffset);
}

bool ClapProcessor::voiceInfoGet(clap_voice_info* info) {
    *info = {.voice_count = 128, .voice_capacity = 128, .flags = 0};
    return true;
}

void ClapProcessor::processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) {
    modulation.apply(notes, audioEngine().noteShifts());
    Processor::processBlock(buffer, notes.takeWith(midi));
    notes.endSilent([this](int key) { return audioEngine().sounds(key); },
                    buffer.getNumSamples() - 1);
}

void ClapProcessor::prepareToPlay(double sampleRateHz, int maximumBlockSize) {
    forgetNotes(); // the new player has none
    Processor::prepareToPlay(sampleRateHz, maximumBlockSize);
}

void ClapProcessor::reset() {
    forgetNotes();
    Processor::reset();
}

void ClapProcessor::forgetNotes() {
    notes.reset();
    modulation.reset();
}

} // namespace idiophone
