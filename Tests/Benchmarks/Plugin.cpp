#include "Benchmarks/Benchmarks.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/Processor.h"
#include "Support/Sanitizers.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace idiophone {
namespace {

constexpr double rateHz = 48000;
constexpr int blockSamples = 32;
constexpr std::size_t blocks = 5808;
constexpr std::size_t chordBlock = 400, chordPeriod = 1200; // ten keys at once
constexpr std::size_t materialBlock = 2400;
constexpr std::size_t automationBlock = 3000, automationBlocks = 1200; // with one of the chords
constexpr std::size_t programBlock = blocks - 48;
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

/// The callbacks in which something dear may happen. Each row is a column of the table.
struct Event {
    const char* name;
    const char* figure;
    bool (*isAt)(std::size_t block);
};
constexpr bool isWithin(std::size_t count, std::size_t block, std::size_t from) {
    return block >= from && block < from + count;
}
constexpr std::array events{
    // From a change on, its cost may be spread over some cells.
    Event{"another preset", "at_another_preset_s",
          [](std::size_t block) { return block >= programBlock; }},
    Event{"another material", "at_another_material_s",
          [](std::size_t block) { return isWithin(48, block, materialBlock); }},
    Event{"ten keys", "at_ten_keys_s",
          [](std::size_t block) { return isWithin(8, block % chordPeriod, chordBlock); }},
    Event{"automated material", "at_automated_material_s",
          [](std::size_t block) { return isWithin(automationBlocks, block, automationBlock); }},
    Event{"notes", "at_notes_s", [](std::size_t) { return true; }}};

const Event& eventAt(std::size_t block) {
    return *std::ranges::find_if(events, [block](const Event& event) { return event.isAt(block); });
}

/// Returns notes and chords over all keys, held for a tenth of a second, with moving pressure and
/// wheels.
std::vector<juce::MidiBuffer> musicOn(const InstrumentView::KeyRange& keys) {
    std::mt19937 random(3);
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    constexpr std::size_t held = 150;
    std::vector<juce::MidiBuffer> music(blocks + held);
    for (std::size_t block = 0; block < blocks; ++block) {
        const bool isChord = block % chordPeriod == chordBlock;
        const int notes = isChord ? 10 : block % 60 == 0 ? between(1, 3) : 0;
        for (int i = 0; i < notes; ++i) {
            const int note = between(keys.lowest, keys.highest);
            const auto velocity = static_cast<juce::uint8>(between(30, 127));
            music[block].addEvent(juce::MidiMessage::noteOn(1, note, velocity),
                                  between(0, blockSamples - 1));
            music[block + held].addEvent(juce::MidiMessage::noteOff(1, note), 0);
        }
        if (block % 16 == 0) {
            const auto sweep = static_cast<int>(block / 16 % 128);
            music[block].addEvent(juce::MidiMessage::channelPressureChange(1, sweep), 0);
            music[block].addEvent(juce::MidiMessage::controllerEvent(1, 1, sweep), 0);
            music[block].addEvent(juce::MidiMessage::pitchWheel(1, 8192 + 16 * sweep), 0);
        }
    }
    return music;
}

/// Plays music with a preset, changes and automates the material while notes ring and then changes
/// to the next preset. The minimum processor time of each block over all replays counts.
class Callbacks {
public:
    explicit Callbacks(int ofProgram)
        : program(ofProgram), least(blocks, std::numeric_limits<double>::infinity()) {}

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
            if (isWithin(automationBlocks, block, automationBlock))
                automateMaterial(processor, block - automationBlock);
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
    std::size_t worstBlock() const {
        return static_cast<std::size_t>(std::ranges::max_element(least) - least.begin());
    }
    double seconds(std::size_t block) const { return least[block]; }
    double worstSecondsAt(const Event& event) const {
        double worst = 0;
        for (std::size_t block = 0; block < blocks; ++block)
            if (&eventAt(block) == &event)
                worst = std::max(worst, least[block]);
        return worst;
    }

private:
    static void set(Processor& processor, ParameterId id, double normalised) {
        processor.getParameters()[static_cast<int>(id)]->setValue(static_cast<float>(normalised));
    }
    static void jumpToAnotherMaterial(Processor& processor) {
        constexpr double one = firstLibraryMaterial, another = one + 1;
        const double other =
            processor.view().parameters.value(ParameterId::material) == one ? another : one;
        set(processor, ParameterId::material,
            parameterInfo(ParameterId::material).toNormalised(other));
    }
    /// Moves stiffness and damping up and down, as the automation of a host does in every block.
    static void automateMaterial(Processor& processor, std::size_t block) {
        using enum ParameterId;
        if (block == 0)
            set(processor, material, parameterInfo(material).toNormalised(customMaterial));
        const double turns = static_cast<double>(block) / automationBlocks;
        const double up = (1 - std::cos(2 * std::numbers::pi * turns)) / 2;
        set(processor, youngsModulus, 0.5 + 0.2 * up);
        set(processor, lossFactor, 0.3 - 0.2 * up);
    }

    int program;
    std::vector<double> least;
};

} // namespace

Result<BenchSection> benchPlugin(const BenchContent& content) {
    const juce::ScopedJuceInitialiser_GUI juce;
    Processor processor;
    BenchSection section{.name = "plugin",
                         .title = "the plugin's callback at 48 kHz in blocks of 32 samples; each "
                                  "block the least of " +
                                  std::to_string(content.pluginReplays) + " replays"};
    double worstShare = 0;
    for (int program = 0; program < processor.getNumPrograms(); ++program) {
        Callbacks callbacks(program);
        for (int replay = 0; replay < content.pluginReplays; ++replay)
            callbacks.replay(processor);
        const std::string name = factoryPresets()[static_cast<std::size_t>(program)].name;
        const std::size_t block = callbacks.worstBlock();
        const double mean = callbacks.meanSeconds(), worst = callbacks.seconds(block);
        const double share = worst * rateHz / blockSamples;
        worstShare = std::max(worstShare, share);
        section.row(name, "mean " + figure(mean * 1e6) + " us, worst " + figure(worst * 1e6) +
                              " us (" + eventAt(block).name + ", block " + std::to_string(block) +
                              "): " + figure(100 * share) + " % of its time");
        nlohmann::ordered_json figures{{"name", name},
                                       {"mean_s", mean},
                                       {"worst_s", worst},
                                       {"worst_event", eventAt(block).name},
                                       {"worst_share", share}};
        for (const Event& event : events)
            figures[event.figure] = callbacks.worstSecondsAt(event);
        section.figures["presets"].push_back(std::move(figures));
    }
    if (isBuiltForSpeed)
        section.goals.push_back({"plugin: worst callback over its time, 32 samples, all presets",
                                 worstShare, BenchGoal::Kind::atMost, 0.33});
    return section;
}

} // namespace idiophone
