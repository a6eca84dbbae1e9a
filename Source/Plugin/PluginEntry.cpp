// Where plugin formats and the standalone find the processor.
#include "Plugin/Processor.h"

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter();

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter() {
    return new idiophone::Processor();
}
