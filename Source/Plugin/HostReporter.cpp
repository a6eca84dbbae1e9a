#include "Plugin/HostReporter.h"

#include <utility>

namespace idiophone {

using Details = juce::AudioProcessorListener::ChangeDetails;

HostReporter::HostReporter(juce::AudioProcessor& ofHost,
                           HostParameters& hostParameters,
                           std::function<void()> callsPoll)
    : processor(ofHost), parameters(hostParameters), pollSoon(std::move(callsPoll)) {}

/// Off the message thread, JUCE's VST3 keeps the values for the next callback's output, but asks
/// the host on the message thread to read all values again. If the host reads first, it finds the
/// former values in the controller, and Ardour sends them back as changes. So the message thread
/// reports them again, before the program. A host that reads the values while another of its
/// threads moves them may keep the values read, as JUCE's does. So the next polls report the values
/// that moved.
void HostReporter::reportSound() {
    const bool isOffline = processor.isNonRealtime();
    const bool isMessageThread = juce::MessageManager::existsAndIsCurrentThread();
    parameters.sendValues();
    if (isOffline || !isMessageThread)
        parameters.forgetLastSent(); // offline, no value from the host is an echo
    if (isMessageThread) {
        reportProgram();
        movesToReport = isOffline ? 0 : 2; // polls; the first may follow at once
        return;
    }
    if (processor.wrapperType == juce::AudioProcessor::wrapperType_LV2)
        return; // LV2 reports values only this way, and no program
    // Report twice, because the wrapper reports nothing until some time after a state is restored.
    soundsToReport = 2;
    pollSoon();
}

void HostReporter::reportChosenProgram() {
    const bool isMessageThread = juce::MessageManager::existsAndIsCurrentThread();
    if (isMessageThread || !processor.isNonRealtime() || !edits.send(parameters))
        return reportSound();
    parameters.forgetLastSent(); // offline, no value from the host is an echo
}

void HostReporter::reportProgram() {
    processor.updateHostDisplay(Details().withProgramChanged(true));
}

void HostReporter::reportState() {
    processor.updateHostDisplay(Details().withNonParameterStateChanged(true));
}

void HostReporter::poll(MidiLearn& controllers) {
    for (const auto& info : parameterTable())
        parameters[info.parameter].sendControllerMove();
    if (controllers.takeReassigned())
        reportState();
    if (restorings > 0)
        return;
    if (soundsToReport > 0) {
        --soundsToReport; // before the report, because another sound may arrive meanwhile
        reportSound();
    } else if (movesToReport > 0) {
        --movesToReport;
        parameters.sendMovedValues();
    }
}

} // namespace idiophone
