#include "Console/SampleOptions.h"

#include "Console/AssignedEffect.h"
#include "Console/ParameterAssignments.h"
#include "Console/PresetChoice.h"
#include "Instrument/ObjectLibrary.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Scene/SceneStage.h"

namespace idiophone {
namespace {

Result<std::vector<int>> keysToSample(const Instrument& instrument, const SampleOptions& options) {
    auto keys = options.keys.empty() ? ownKeys(instrument)
                                     : playedKeys(instrument, options.keys[0], options.keys[1]);
    if (keys.empty())
        return failure("--keys: " + inQuotes(options.instrument) + " plays none of these keys");
    return keys;
}

Result<void> checkVariation(const ParameterValues& values, const SampleOptions& options) {
    if (options.choices.roundRobins > 1 && !strikesVary(values))
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

Result<SampleTask> planKeys(const SampleOptions& options) {
    if (pathNamed(options.instrument).extension() == ".modal")
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
            " scrapes, rolls or bows, which samples cannot follow; --set contact=Strike strikes");
    if (auto varied = checkVariation(*values, options); !varied)
        return tl::unexpected(varied.error());
    const auto keys = keysToSample(**instrument, options);
    if (!keys)
        return tl::unexpected(keys.error());
    return taskOfKeys({.instrument = *instrument,
                       .preset = *preset,
                       .values = *values,
                       .sampleRateHz = static_cast<double>(options.sampleRateHz)},
                      *keys, options.choices, "." + options.ending);
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
    const auto values = valuesFor(**instrument, {}, options);
    if (!values)
        return tl::unexpected(values.error());
    Preset preset;
    preset.name = (*instrument)->slots().front().object->name;
    preset.keyMap = (*instrument)->keyMap();
    auto task = taskOfPlaces({.instrument = *instrument,
                              .preset = preset,
                              .values = *values,
                              .sampleRateHz = static_cast<double>(options.sampleRateHz)},
                             0, static_cast<std::size_t>(*options.places),
                             options.choices.velocities, "." + options.ending);
    if (!task)
        return failure(options.instrument + ": " + task.error().message);
    return task;
}

} // namespace

Result<SampleTask> planSampling(const SampleOptions& options) {
    return options.places ? planPlaces(options) : planKeys(options);
}

} // namespace idiophone
