// Creates the processor for the plugin formats and the standalone.
#include "Plugin/Processor.h"
#if HAS_CLAP_JUCE_EXTENSIONS
#include "Plugin/ClapProcessor.h"
#endif

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter();

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter() {
    using enum idiophone::PluginKind;
    constexpr auto kind = JucePlugin_IsSynth ? instrument : resonator;
#if HAS_CLAP_JUCE_EXTENSIONS
    if (clap_juce_extensions::clap_properties().is_clap)
        return new idiophone::ClapProcessor(kind);
#endif
    return new idiophone::Processor(kind);
}
