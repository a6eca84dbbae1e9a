// A parameter as a CLAP host sees it: it says what the host may modulate.
#pragma once

#include "Parameters/ModulationTable.h"
#include "Plugin/HostParameter.h"

#include <clap-juce-extensions/clap-juce-extensions.h>

namespace idiophone {

/// ClapModulation follows the events themselves.
class ClapParameter final : public HostParameter,
                            public clap_juce_extensions::clap_juce_parameter_capabilities {
public:
    using HostParameter::HostParameter;

    bool supportsMonophonicModulation() override { return !isDiscrete(); }
    bool supportsPolyphonicModulation() override {
        return noteTargetIndex(info().parameter).has_value();
    }
};

} // namespace idiophone
