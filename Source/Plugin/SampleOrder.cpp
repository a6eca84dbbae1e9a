#include "Plugin/SampleOrder.h"

#include "Object/OneLine.h"

#include <algorithm>

namespace idiophone {
namespace {

Result<void> checkSound(const SampledInstrument& sampled) {
    if (sampled.instrument == nullptr || sampled.instrument->slots().empty())
        return failure("There is no instrument to sample.");
    if (sampled.instrument->stage() != nullptr)
        return failure(
            "This is a scene, whose notes move bodies. Only struck instruments can be sampled.");
    return {};
}

Result<SampleTask> taskOfKeys(const SampleOrder& order) {
    const auto& settings = order.settings;
    const auto& values = order.sampled.values;
    if (static_cast<int>(values[ParameterId::contact]) != strikeContact)
        return failure(
            "This sound scrapes, rolls or bows, which samples cannot follow. On the Contact "
            "page, choose Strike.");
    if (settings.roundRobins > 1 && !strikesVary(values))
        return failure("Without Spread and Chatter all round robins would sound alike.");
    auto keys = playedKeys(*order.sampled.instrument, settings.lowestKey, settings.highestKey);
    if (order.sampled.preset.keyMap.kind != KeyMapKind::zones) // zones play without a pitch
        std::erase_if(keys, [&](int key) {
            return order.sampled.tuning.unmapped[static_cast<std::size_t>(key)];
        });
    if (keys.empty())
        return failure("None of these keys plays.");
    return taskOfKeys(order.sampled, keys,
                      {.every = settings.every,
                       .velocities = settings.velocities,
                       .roundRobins = settings.roundRobins},
                      settings.isFlac ? ".flac" : ".wav");
}

Result<SampleTask> taskOfPlaces(const SampleOrder& order) {
    const auto slots = order.sampled.instrument->slots();
    if (order.slot >= slots.size())
        return failure("This object no longer plays.");
    const auto& settings = order.settings;
    auto task = taskOfPlaces(order.sampled, order.slot, static_cast<std::size_t>(settings.places),
                             settings.velocities, settings.isFlac ? ".flac" : ".wav");
    if (!task)
        return failure(oneLine(slots[order.slot].object->name) + ": " + task.error().message + ".");
    return task;
}

} // namespace

Result<SampleTask> taskOf(const SampleOrder& order) {
    return checkSound(order.sampled).and_then([&] {
        return order.settings.source == SampleSettings::Source::keys ? taskOfKeys(order)
                                                                     : taskOfPlaces(order);
    });
}

SampleExportSettings exportSettingsOf(const SampleOrder& order) {
    return {.folder = order.folder,
            .bitDepth = order.settings.bitDepth,
            .tailDecibels = static_cast<double>(order.settings.tailDecibels),
            .longestSeconds = static_cast<double>(order.settings.longestSeconds)};
}

} // namespace idiophone
