#include "Benchmarks/Benchmarks.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/Processor.h"
#include "Support/Sanitizers.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace idiophone {
namespace {

constexpr double rateHz = 48000;
constexpr int blockSamples = 128;
constexpr std::size_t aftermath = 12; // blocks in which a change still costs time: 32 ms
constexpr std::size_t materialBlock = 600, programBlock = 1440, blocks = programBlock + aftermath;
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

/// Plays music with a preset, changes the material while notes ring and then changes to the next
/// preset. The minimum processor time of each block over all replays counts.
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

Result<BenchSection> benchPlugin(const BenchContent& content) {
    const juce::ScopedJuceInitialiser_GUI juce;
    Processor processor;
    BenchSection section{.name = "plugin",
                         .title = "the plugin's callback at 48 kHz in blocks of 128 samples; each "
                                  "block the least of " +
                                  std::to_string(content.pluginReplays) + " replays"};
    double dearest = 0;
    for (int program = 0; program < processor.getNumPrograms(); ++program) {
        Callbacks callbacks(program);
        for (int replay = 0; replay < content.pluginReplays; ++replay)
            callbacks.replay(processor);
        const std::string name = factoryPresets()[static_cast<std::size_t>(program)].name;
        const double mean = callbacks.meanSeconds(), worst = callbacks.worstSeconds();
        const double share = worst * rateHz / blockSamples;
        dearest = std::max(dearest, share);
        section.row(name, "mean " + figure(mean * 1e6) + " us, worst " + figure(worst * 1e6) +
                              " us: " + figure(100 * share) + " % of its own length");
        section.figures["presets"].push_back(
            {{"name", name},
             {"mean_s", mean},
             {"worst_s", worst},
             {"at_another_material_s", callbacks.worstSecondsBehind(materialBlock)},
             {"at_another_preset_s", callbacks.worstSecondsBehind(programBlock)},
             {"worst_share", share}});
    }
    if (isBuiltForSpeed)
        section.goals.push_back(
            {"plugin: dearest block over its own length", dearest, BenchGoal::Kind::atMost, 1});
    return section;
}

} // namespace idiophone
