#include "Console/SampleTask.h"

#include "Console/AssignedEffect.h"
#include "Console/ParameterAssignments.h"
#include "Console/PresetChoice.h"
#include "Instrument/ObjectSurface.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Sampling/ObjectPlaces.h"
#include "Scene/SceneStage.h"

#include <array>
#include <cstdio>

namespace idiophone {
namespace {

Result<std::vector<int>> keysToSample(const Instrument& instrument, const SampleOptions& options) {
    std::vector<int> own, chosen;
    for (int key = 0; key < 128; ++key) {
        if (instrument.hasOwn(key))
            own.push_back(key);
        if (!options.keys.empty() && key >= options.keys[0] && key <= options.keys[1] &&
            instrument.key(key).slot >= 0)
            chosen.push_back(key);
    }
    if (options.keys.empty())
        chosen = own;
    if (chosen.empty())
        return failure("--keys: " + inQuotes(options.instrument) + " plays none of these keys");
    return chosen;
}

Result<void> checkVariation(const ParameterValues& values, const SampleOptions& options) {
    if (options.choices.roundRobins > 1 && values[ParameterId::strikeSpread] == 0 &&
        values[ParameterId::chatter] == 0)
        return failure("--round-robins: without spread and chatter all strikes would be equal");
    return {};
}

/// Makes the parameters that were set by name act.
Result<ParameterValues>
valuesFor(const Instrument& instrument, ParameterValues values, const SampleOptions& options) {
    const auto assigned = assignParameters(options.assignments, values);
    if (!assigned)
        return tl::unexpected(assigned.error());
    const auto effect = assignedEffect(
        values, *assigned, {.slots = instrument.slots(), .isOnePoint = options.places.has_value()});
    print(effect.warnings);
    return effect.values;
}

std::string fileNameOf(const SampleOptions& options, const std::string& name) {
    return name + "." + options.ending;
}

Result<SampleTask> planKeys(const SampleOptions& options) {
    if (std::filesystem::path(options.instrument).extension() == ".modal")
        return failure(options.instrument +
                       ": it is an object; --places says at how many places to strike it");
    const auto preset = findOrReadPreset(options.instrument);
    if (!preset)
        return tl::unexpected(preset.error());
    const auto instrument = buildInstrument(preset->keyMap, ObjectLibrary::shared());
    if (!instrument)
        return failure(options.instrument + ": " + instrument.error().message);
    if ((*instrument)->stage() != nullptr)
        return failure(inQuotes(preset->name) +
                       " is a scene: `idiophone scene --stems` renders it");
    const auto values = valuesFor(**instrument, withSetupOf({}, preset->parameters), options);
    if (!values)
        return tl::unexpected(values.error());
    if (static_cast<int>((*values)[ParameterId::contact]) != strikeContact)
        return failure(
            inQuotes(preset->name) +
            " scrapes or rolls, which samples cannot follow; --set contact=Strike strikes");
    if (auto varied = checkVariation(*values, options); !varied)
        return tl::unexpected(varied.error());
    const auto keys = keysToSample(**instrument, options);
    if (!keys)
        return tl::unexpected(keys.error());
    SampleTask task;
    task.sampled = {.instrument = *instrument,
                    .preset = *preset,
                    .values = *values,
                    .sampleRateHz = static_cast<double>(options.sampleRateHz)};
    task.plan = planSamples(*keys, options.choices);
    for (const auto& sample : task.plan) {
        const auto name = fileNameOf(options, sample.name);
        task.jobs.push_back({.strike = {.by = SampledStrike::KeyStrike{.key = sample.key,
                                                                       .velocity = sample.velocity},
                                        .turn = static_cast<std::uint64_t>(sample.roundRobin - 1)},
                             .file = options.folder / name});
        task.names.push_back({{"file", name},
                              {"key", sample.key},
                              {"velocity", sample.velocity},
                              {"round_robin", sample.roundRobin}});
    }
    return task;
}

/// Returns an instrument of one key. Strikes on its surface need no key.
Result<std::shared_ptr<const Instrument>> instrumentOf(const std::string& file) {
    return buildInstrument({.kind = KeyMapKind::zones,
                            .lowestNote = 60,
                            .highestNote = 60,
                            .object = storedNameOf(file)},
                           ObjectLibrary::shared());
}

Result<SampleTask> planPlaces(const SampleOptions& options) {
    const auto instrument = instrumentOf(options.instrument);
    if (!instrument)
        return tl::unexpected(instrument.error());
    const auto& object = *(*instrument)->slots().front().object;
    const auto rows = spreadPlaces(object, static_cast<std::size_t>(*options.places));
    if (!rows)
        return failure(options.instrument + ": " + rows.error().message);
    const auto values = valuesFor(**instrument, {}, options);
    if (!values)
        return tl::unexpected(values.error());
    SampleTask task;
    task.sampled.instrument = *instrument;
    task.sampled.values = *values;
    task.sampled.sampleRateHz = options.sampleRateHz;
    task.sampled.preset.name = object.name;
    task.sampled.preset.keyMap = (*instrument)->keyMap();
    const ObjectSurface surface(object);
    for (std::size_t place = 0; place < rows->size(); ++place)
        for (const int velocity : layerVelocities(options.choices.velocities)) {
            std::array<char, 48> text{};
            std::snprintf(text.data(), text.size(), "p%02zu-v%03d", place + 1, velocity);
            const auto name = fileNameOf(options, text.data());
            const auto point = surface.atVertex(object.shapeVertices[(*rows)[place]]);
            task.jobs.push_back(
                {.strike = {.by = SurfaceStrike{.point = point.value(), .velocity = velocity}},
                 .file = options.folder / name});
            task.names.push_back({{"file", name},
                                  {"place_m", vertexOfRow(object, (*rows)[place])},
                                  {"velocity", velocity}});
        }
    return task;
}

} // namespace

Result<SampleTask> planSampling(const SampleOptions& options) {
    return options.places ? planPlaces(options) : planKeys(options);
}

} // namespace idiophone
