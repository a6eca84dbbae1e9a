#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/PresetChoice.h"
#include "Console/TextColumns.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/LoudnessPhrase.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "Output/OutputStage.h"
#include "Sampling/LoudnessMeter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct PresetsOptions {
    std::string preset; ///< empty: lists the factory presets
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
    for (const auto& preset : factoryPresets()) {
        const auto& keys = preset.keyMap;
        std::cout << rightColumn(std::to_string(program++), 3) << "  "
                  << leftColumn(preset.name, 20) << rightColumn(std::to_string(keys.lowestNote), 4)
                  << leftColumn(" to " + std::to_string(keys.highestNote), 9)
                  << paragraph(preset.description, 38);
    }
}

/// Renders the loudness phrase through the output stage, interleaved. The limiter is off, so that
/// loudness follows the level.
Result<std::vector<float>> heardPhrase(const Preset& preset,
                                       const std::shared_ptr<const Instrument>& instrument) {
    const auto [left, right] = playLoudnessPhrase(preset, instrument, measuredRateHz);
    std::array<std::vector<float>, 2> heard{left, right};
    OutputStage output;
    output.prepare(measuredRateHz, static_cast<int>(left.size()));
    std::array<float*, 2> channels{heard[0].data(), heard[1].data()};
    auto parameters = preset.parameters;
    parameters.set(ParameterId::limiter, 0);
    if (!output.process(left, right, channels, parameters))
        return failure(preset.name + ": its sound is not finite");
    std::vector<float> interleaved;
    for (std::size_t i = 0; i < left.size(); ++i)
        interleaved.insert(interleaved.end(), {heard[0][i], heard[1][i]});
    return interleaved;
}

std::optional<double> integratedLufs(std::vector<float> sound, double gainDb) {
    for (float& sample : sound)
        sample *= static_cast<float>(std::pow(10, gainDb / 20));
    LoudnessMeter meter(2, measuredRateHz);
    meter.add(sound);
    return meter.integratedLufs();
}

/// Returns the gain that matches the loudness of the factory presets, or nothing for silence.
std::optional<double> matchingGainDb(const std::vector<float>& sound) {
    const auto [lowest, highest] = std::ranges::minmax(sound);
    if (lowest == 0 && highest == 0)
        return std::nullopt;
    double gainDb = -20 * std::log10(std::max(-lowest, highest));
    // Iterate, because the gain changes the sound that the meter's gate excludes.
    for (int step = 0; step < 4; ++step) {
        const auto lufs = integratedLufs(sound, gainDb);
        if (!lufs)
            return std::nullopt;
        gainDb += factoryLufs - *lufs;
    }
    return gainDb;
}

constexpr double maximumGainDb = 40;

constexpr std::size_t noteSamples = measuredRateHz;
constexpr std::array velocities{40, 100};

/// Plays a key for a second and measures its loudest 400 ms. A silent key has -infinity.
double loudestLufs(const Preset& preset,
                   const std::shared_ptr<const Instrument>& instrument,
                   int note,
                   int velocity) {
    Player player(instrument, measuredRateHz, preset.surface, preset.seed, preset.matched());
    std::vector<float> left(noteSamples), right(noteSamples);
    const MidiEvent struck{
        .sampleOffset = 0,
        .bytes = {0x90, static_cast<std::uint8_t>(note), static_cast<std::uint8_t>(velocity)}};
    player.process({left, right}, std::array{struck}, preset.parameters);
    std::vector<float> interleaved;
    for (std::size_t i = 0; i < noteSamples; ++i)
        interleaved.insert(interleaved.end(), {left[i], right[i]});
    return loudestMomentLufs(interleaved, 2, measuredRateHz);
}

/// The mean of the keys that are heard.
double meanLufs(const std::vector<double>& loudness) {
    double sum = 0, count = 0;
    for (const double key : loudness)
        if (std::isfinite(key)) {
            sum += key;
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

/// Returns the `voicingDb` that makes a preset's keys equally loud, as a maker voices bars. The
/// loudness of a key is that of the loudest 400 ms of its note, the mean over a soft and a loud
/// velocity, without level and room. The preset's own voicing is ignored. A silent key has 0 dB.
Result<std::vector<double>> evenVoicingDb(Preset preset) {
    preset.keyMap.voicingDb.clear();
    const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared());
    if (!instrument)
        return tl::unexpected(instrument.error());
    std::vector<double> loudness;
    for (int note = preset.keyMap.lowestNote; note <= preset.keyMap.highestNote; ++note) {
        double sum = 0;
        for (const int velocity : velocities)
            sum += loudestLufs(preset, *instrument, note, velocity);
        loudness.push_back(sum / static_cast<double>(velocities.size()));
    }
    const double mean = meanLufs(loudness);
    std::vector<double> gains;
    for (const double key : loudness)
        gains.push_back(std::isfinite(key) ? std::clamp(mean - key, -maximumGainDb, maximumGainDb)
                                           : 0);
    return gains;
}

/// Prints the `level` at which the preset is as loud as the factory presets.
Result<void> measure(const PresetsOptions& options) {
    const auto preset = findOrReadPreset(options.preset);
    if (!preset)
        return tl::unexpected(preset.error());
    if (preset->keyMap.kind == KeyMapKind::scene)
        return failure(options.preset +
                       ": it plays a scene, whose loudness depends on the falling bodies");
    const auto instrument = Instrument::build(preset->keyMap, ObjectLibrary::shared());
    if (!instrument)
        return failure(options.preset + ": " + instrument.error().message);
    const auto phrase = heardPhrase(*preset, *instrument);
    if (!phrase)
        return tl::unexpected(phrase.error());
    const auto gainDb = matchingGainDb(*phrase);
    if (!gainDb)
        return failure(options.preset + ": its keys are silent");
    const double level = preset->parameters[ParameterId::level];
    const double matching = level + *gainDb;
    if (options.json) {
        auto voicing = evenVoicingDb(*preset);
        if (!voicing)
            return tl::unexpected(voicing.error());
        for (double& db : *voicing)
            db = std::round(10 * db) / 10;
        std::cout << jsonText({{"name", preset->name},
                               {"level_db", level},
                               {"matching_level_db", matching},
                               {"even_voicing_db", *voicing}});
    } else
        std::cout << std::fixed << std::setprecision(1) << preset->name
                  << ": as loud as the factory presets at a level of " << matching << " dB; it has "
                  << level << " dB\n";
    return {};
}

Result<void> presets(const PresetsOptions& options) {
    if (!options.preset.empty())
        return measure(options);
    if (options.json)
        std::cout << jsonText(describeAll());
    else
        printAll();
    return {};
}

} // namespace

void addPresets(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<PresetsOptions>(
        program, chosen, "presets", "Lists the factory presets, or measures one", presets);
    command->add_option(
        "PRESET", options->preset,
        "Name of a factory preset, or a preset file; shows the level at which it is "
        "as loud as the factory presets");
    command->add_flag(
        "--json", options->json,
        "Writes JSON; for one preset with the voicing that makes its keys equally loud");
}

} // namespace idiophone
