// The instrument as a VST3 host loads it, with a side chain and further outputs.
#pragma once

#include "Plugin/Processor.h"

#include <memory>
#include <utility>

namespace idiophone::test {

struct Vst3Instrument {
    Vst3Instrument() {
        using Host = juce::PluginHostType;
        const auto before = std::exchange(Host::jucePlugInClientCurrentWrapperType,
                                          juce::AudioProcessor::wrapperType_VST3);
        processor = std::make_unique<Processor>();
        Host::jucePlugInClientCurrentWrapperType = before;
    }
    std::unique_ptr<Processor> processor;
};

} // namespace idiophone::test
