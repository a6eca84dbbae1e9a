// A host whose callbacks are watched by the real-time trap.
#pragma once

#include "Plugin/RealTimeTrap.h"
#include "Support/TestSound.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <string>

namespace idiophone::test {

class WatchedHost {
public:
    explicit WatchedHost(int blockSize) : buffer(2, blockSize) {
        processor.prepareToPlay(48000, blockSize);
    }

    void block(const juce::MidiBuffer& midi, int samples) {
        juce::MidiBuffer events(midi);
        juce::AudioBuffer<float> view(buffer.getArrayOfWritePointers(), 2, samples);
        const auto faults = faultsOf([&] { processor.processBlock(view, events); });
        INFO(what << ": first " << faults.first);
        CHECK(faults.allocations == 0);
        CHECK(faults.locks == 0);
        if (systemCallTrapWorks()) // system calls have their own test, which is skipped elsewhere
            CHECK(faults.systemCalls == 0);
        if (!hasHadStage)
            CHECK(faults.wakes == 0); // only a stage has a worker
        loudestSample = std::max(loudestSample, view.getMagnitude(0, samples));
    }

    /// Renders a block of a stage whose simulation is in time.
    void stageBlock(const juce::MidiBuffer& midi, int samples) {
        processor.waitForSimulation();
        block(midi, samples);
    }

    void choose(int program) {
        what = processor.getProgramName(program).toStdString();
        hasHadStage = processor.view().stage.hasStage();
        processor.setCurrentProgram(program); // while the former sound rings
        hasHadStage = hasHadStage || processor.view().stage.hasStage();
        loudestSample = 0;
    }

    /// Checks the loudest sample since the preset was chosen.
    void checkHeard(float leastSample) const {
        INFO(what << ": loudest sample " << loudestSample);
        CHECK(loudestSample > leastSample);
    }

    Processor processor;
    std::string what;
    float loudestSample = 0;

private:
    bool hasHadStage = false; ///< now or before the last choice
    juce::AudioBuffer<float> buffer;
};

} // namespace idiophone::test
