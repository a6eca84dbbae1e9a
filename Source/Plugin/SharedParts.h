// The parts through which the host, the engine and the sessions meet.
#pragma once

#include "Plugin/EngineMessages.h"
#include "Plugin/EngineReport.h"
#include "Plugin/HostLoads.h"
#include "Plugin/HostReporter.h"
#include "Plugin/ProgramChanges.h"
#include "Plugin/TailLength.h"

namespace idiophone {

/// Each part says its threads.
struct SharedParts {
    /// `programCount` is for the ProgramChanges, `pollSoon` for the HostReporter, `make` for the
    /// HostParameters.
    SharedParts(juce::AudioProcessor& processor,
                int programCount,
                std::function<void()> pollSoon,
                HostParameters::MakeParameter make = HostParameters::makePlain)
        : plugin(processor), parameters(processor, make), programs(programCount),
          reporter(processor, parameters, std::move(pollSoon)) {}

    const juce::AudioProcessor& plugin;
    HostParameters parameters;
    EngineMessages messages;
    EngineReport report;
    ProgramChanges programs;
    TailLength tail;
    HostReporter reporter;
    HostLoads loads;
};

} // namespace idiophone
