#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/PresetChoice.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/LoudnessPhrase.h"

#include <algorithm>
#include <cmath>
#include <ebur128.h>
#include <iomanip>
#include <iostream>
#include <memory>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct Options {
    std::string measured; ///< empty: lists the factory's
    bool json = false;
};

ordered_json describeAll() {
    ordered_json list = ordered_json::array();
    for (const auto& preset : factoryPresets()) {
        const auto program = list.size();
        list.push_back(ordered_json::parse(encodePreset(preset)));
        list.back()["program"] = program;
    }
    return list;
}

void printAll() {
    int program = 0;
    for (const auto& preset : factoryPresets())
        std::cout << std::right << std::setw(3) << program++ << "  " << std::left << std::setw(22)
                  << preset.name << std::right << std::setw(3) << preset.keyMap.lowestNote << " to "
                  << std::left << std::setw(5) << preset.keyMap.highestNote << preset.description
                  << '\n';
}

constexpr double sampleRateHz = 48000;

/// Integrated, of one channel at that gain; minus infinity where it is fainter than the gate.
double integratedLufs(std::vector<float> sound, double gainDb) {
    for (float& sample : sound)
        sample *= static_cast<float>(std::pow(10, gainDb / 20));
    const auto release = [](ebur128_state* state) { ebur128_destroy(&state); };
    const std::unique_ptr<ebur128_state, decltype(release)> meter(
        ebur128_init(1, static_cast<unsigned long>(sampleRateHz), EBUR128_MODE_I), release);
    ebur128_add_frames_float(meter.get(), sound.data(), sound.size());
    double lufs = 0;
    ebur128_loudness_global(meter.get(), &lufs);
    return lufs;
}

/// The gain that makes the sound, whose peak is not 0, as loud as the factory's.
double matchingGainDb(const std::vector<float>& sound, float peak) {
    double gainDb = -20 * std::log10(peak);
    // What is left after the first step is what the gate takes.
    for (int step = 0; step < 4; ++step)
        gainDb += factoryLufs - integratedLufs(sound, gainDb);
    return gainDb;
}

/// How loud the preset is, and the `level` at which it would be as loud as the factory's.
Result<void> measure(const Options& options) {
    const auto preset = findOrReadPreset(options.measured);
    if (!preset)
        return tl::unexpected(preset.error());
    if (preset->keyMap.kind == KeyMapKind::scene)
        return failure(options.measured + ": it plays a scene, which is as loud as what falls");
    const auto instrument = Instrument::build(preset->keyMap, ObjectLibrary::shared());
    if (!instrument)
        return tl::unexpected(instrument.error());
    const auto sound = playLoudnessPhrase(*preset, *instrument, sampleRateHz);
    const auto [lowest, highest] = std::ranges::minmax(sound);
    const float peak = std::max(-lowest, highest);
    if (peak == 0)
        return failure(options.measured + ": its keys are silent");
    const double level = preset->parameters[ParameterId::level];
    const double matching = level + matchingGainDb(sound, peak);
    if (options.json)
        std::cout << jsonText(
            {{"name", preset->name}, {"level_db", level}, {"matching_level_db", matching}});
    else
        std::cout << std::fixed << std::setprecision(1) << preset->name
                  << ": as loud as the factory presets at a level of " << matching << " dB; it has "
                  << level << " dB\n";
    return {};
}

Result<void> presets(const Options& options) {
    if (!options.measured.empty())
        return measure(options);
    if (options.json)
        std::cout << jsonText(describeAll());
    else
        printAll();
    return {};
}

} // namespace

void addPresets(CLI::App& program, Action& chosen) {
    auto* command = program.add_subcommand("presets", "Lists the factory presets, or measures one");
    auto options = std::make_shared<Options>();
    command->add_option("--level", options->measured,
                        "The level at which this preset, by its name or file, is as loud as the "
                        "factory's");
    command->add_flag("--json", options->json, "As JSON");
    command->final_callback(
        [options, &chosen] { chosen = [options] { return presets(*options); }; });
}

} // namespace idiophone
