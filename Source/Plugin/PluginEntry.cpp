// Creates the processor for the plugin formats and the standalone.
#include "Plugin/Processor.h"

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter();

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter() {
    using enum idiophone::PluginKind;
    return new idiophone::Processor(JucePlugin_IsSynth ? instrument : resonator);
}
