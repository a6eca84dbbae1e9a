// Times the plugin's callback as a host drives it. Plays music with every factory preset, changes
// the material while notes ring and then changes to the next preset. Replays the same blocks
// several times and counts the minimum processor time of each block.
//
//     plugin_callbacks [REPLAYS]
//
// prints the table of docs/benchmarks.md. An optimised build fails if a block took longer than it
// lasts.
#include "Instrument/FactoryContent.h"
#include "Plugin/Processor.h"
#include "Support/Sanitizers.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <vector>

using namespace idiophone;

namespace {

constexpr double rateHz = 48000;
constexpr int blockSamples = 128;
constexpr std::size_t aftermath = 12; // blocks in which a change still costs time: 32 ms
constexpr std::size_t materialBlock = 600, programBlock = 1440, blocks = programBlock + aftermath;
constexpr int defaultReplays = 10;
#ifdef NDEBUG
constexpr bool isBuiltForSpeed = !IDIOPHONE_SANITIZED;
#else
constexpr bool isBuiltForSpeed = false;
#endif
constexpr auto blockTime =
    std::chrono::nanoseconds(std::int64_t{1'000'000'000} * blockSamples / 48000);

/// [s] Returns the processor time of this thread only.
double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns notes and chords over all keys, held for a tenth of a second, with moving pressure and
/// wheels.
std::vector<juce::MidiBuffer> musicOn(const InstrumentView::KeyRange& keys) {
    std::mt19937 random(3);
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    constexpr std::size_t held = 38;
    std::vector<juce::MidiBuffer> music(blocks + held);
    for (std::size_t block = 0; block < blocks; ++block) {
        const int notes = block % 300 == 100 ? 10 : block % 15 == 0 ? between(1, 3) : 0;
        for (int i = 0; i < notes; ++i) {
            const int note = between(keys.lowest, keys.highest);
            const auto velocity = static_cast<juce::uint8>(between(30, 127));
            music[block].addEvent(juce::MidiMessage::noteOn(1, note, velocity),
                                  between(0, blockSamples - 1));
            music[block + held].addEvent(juce::MidiMessage::noteOff(1, note), 0);
        }
        if (block % 4 == 0) {
            const auto sweep = static_cast<int>(block / 4 % 128);
            music[block].addEvent(juce::MidiMessage::channelPressureChange(1, sweep), 0);
            music[block].addEvent(juce::MidiMessage::controllerEvent(1, 1, sweep), 0);
            music[block].addEvent(juce::MidiMessage::pitchWheel(1, 8192 + 16 * sweep), 0);
        }
    }
    return music;
}

class Callbacks {
public:
    explicit Callbacks(int ofProgram) : program(ofProgram) {
        least.fill(std::numeric_limits<double>::infinity());
    }

    void replay(Processor& processor) {
        processor.setCurrentProgram(program);
        processor.prepareToPlay(rateHz, blockSamples); // a new player
        const auto music = musicOn(processor.view().instrument.keyRange());
        juce::AudioBuffer<float> sound(2, blockSamples);
        const bool hasStage = processor.view().stage.hasStage();
        auto next = std::chrono::steady_clock::now();
        for (std::size_t block = 0; block < blocks; ++block) {
            if (block == materialBlock)
                jumpToAnotherMaterial(processor);
            if (block == programBlock)
                processor.setCurrentProgram((program + 1) % processor.getNumPrograms());
            juce::MidiBuffer midi(music[block]);
            const double start = processorSeconds();
            processor.processBlock(sound, midi);
            least[block] = std::min(least[block], processorSeconds() - start);
            if (hasStage) // a worker thread moves its bodies meanwhile
                std::this_thread::sleep_until(next += blockTime);
        }
    }

    double meanSeconds() const {
        return std::accumulate(least.begin(), least.end(), 0.0) / static_cast<double>(blocks);
    }
    double worstSeconds() const { return *std::max_element(least.begin(), least.end()); }
    /// Returns the maximum of the blocks right after a change at `block`.
    double worstSecondsBehind(std::size_t block) const {
        const auto from = least.begin() + static_cast<std::ptrdiff_t>(block);
        return *std::max_element(from, from + aftermath);
    }

private:
    static void jumpToAnotherMaterial(Processor& processor) {
        constexpr double one = firstLibraryMaterial, another = one + 1;
        const double other =
            processor.view().parameters.value(ParameterId::material) == one ? another : one;
        processor.getParameters()[static_cast<int>(ParameterId::material)]->setValue(
            static_cast<float>(parameterInfo(ParameterId::material).toNormalised(other)));
    }

    int program;
    std::array<double, blocks> least;
};

} // namespace

int main(int count, char** arguments) {
    const int replays = count > 1 ? std::max(1, std::atoi(arguments[1])) : defaultReplays;
    const juce::ScopedJuceInitialiser_GUI juce;
    Processor processor;
    std::cout
        << "| preset | mean, µs | worst | worst / mean | at another material | at another preset "
           "| worst of its time, % |\n|---|---|---|---|---|---|---|\n"
        << std::fixed;
    double dearest = 0;
    for (int program = 0; program < processor.getNumPrograms(); ++program) {
        Callbacks callbacks(program);
        for (int replay = 0; replay < replays; ++replay)
            callbacks.replay(processor);
        const double mean = callbacks.meanSeconds(), worst = callbacks.worstSeconds();
        const double share = worst * rateHz / blockSamples;
        dearest = std::max(dearest, share);
        std::cout << std::setprecision(1) << "| "
                  << factoryPresets()[static_cast<std::size_t>(program)].name << " | " << mean * 1e6
                  << " | " << worst * 1e6 << " | " << worst / mean << " | "
                  << callbacks.worstSecondsBehind(materialBlock) * 1e6 << " | "
                  << callbacks.worstSecondsBehind(programBlock) * 1e6 << " | " << 100 * share
                  << " |" << std::endl;
    }
    if (isBuiltForSpeed && dearest >= 1) {
        std::cerr << "A block takes longer than it lasts." << std::endl;
        return 1;
    }
    return 0;
}
