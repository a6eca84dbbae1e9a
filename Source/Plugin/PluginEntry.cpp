// Creates the processor for the plugin formats and the standalone.
#include "Plugin/Processor.h"

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter();

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter() {
    return new idiophone::Processor();
}
