#include "Plugin/ImportedSound.h"

#include "Instrument/SingleObjectMap.h"
#include "Instrument/StartingLevel.h"
#include "Plugin/ImportSummary.h"
#include "Plugin/ObjectEmbedding.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

bool isStruck(const ParameterValues& values) {
    return static_cast<int>(values[ParameterId::contact]) == strikeContact;
}

Preset presetOf(const ObjectWorkshop::Product& product, Preset preset) {
    const auto& object = *product.object;
    auto& map = preset.keyMap;
    if ((product.isFirst && product.isNewFile) || map.kind == KeyMapKind::bars)
        map = singleObjectMap(object, product.objectName, KeyMapKind::scaled);
    map.object = product.objectName;
    map.referenceNote = -1;
    preset.name = object.name;
    preset.author.clear();
    preset.description = object.name + ": " + summaryOf(object);
    if (product.isPreview) // a project saved now keeps the preview
        preset.description += ". A preview of few elements: analyse it again for all modes.";
    preset.tags = {"imported"};
    preset.mutedModes = {};
    return preset;
}

} // namespace

bool plays(const std::shared_ptr<const Instrument>& instrument, const ModalObject& object) {
    return instrument != nullptr && !instrument->slots().empty() &&
           instrument->slots().front().object.get() == &object;
}

std::optional<KeyLayout> layoutOf(const std::shared_ptr<const Instrument>& instrument) {
    if (instrument == nullptr || instrument->slots().empty())
        return std::nullopt;
    switch (instrument->keyMap().kind) {
    case KeyMapKind::scaled:
        return KeyLayout::scaled;
    case KeyMapKind::zones:
        return KeyLayout::zones;
    default:
        return std::nullopt;
    }
}

Result<Sound>
soundOf(const ObjectWorkshop::Product& product, const Sound& before, double sampleRateHz) {
    auto preset = presetOf(product, before.preset);
    auto values = before.parameters;
    const auto built = buildSingleObject(preset.keyMap, product.object);
    if (!built)
        return failure(product.object->name + " cannot be played: " + built.error().message);
    const bool isNew = product.isFirst && product.isNewFile;
    if (product.isFirst) {
        values.set(ParameterId::material, ownMaterial);
        values.set(ParameterId::thickness, parameterInfo(ParameterId::thickness).defaultValue);
        if (isNew && isStruck(values))
            values = withAudibleMallet(*built, preset.surface, sampleRateHz, values);
        preset.parameters = values;
    }
    // The loudness of scrapes and rolls is predicted only up to a constant.
    if (isNew && isStruck(values))
        values.set(ParameterId::level, startingLevel(*built, preset.surface, sampleRateHz, values));
    else
        values = asLoudAs(before, preset, *built, values, sampleRateHz);
    const auto stored = preset.parameters;
    return Sound{.preset = std::move(preset),
                 .instrument = *built,
                 .parameters = values,
                 .missing = nullptr,
                 .presetId = {},
                 .stored = stored};
}

ParameterValues asLoudAs(const Sound& before,
                         const Preset& preset,
                         const std::shared_ptr<const Instrument>& built,
                         ParameterValues values,
                         double sampleRateHz) {
    const auto& now = before.parameters;
    if (before.instrument == nullptr)
        return values;
    const auto& surface = preset.surface;
    double level = now[ParameterId::level] +
                   predictedLufs(before.instrument, surface, sampleRateHz, now) -
                   predictedLufs(built, surface, sampleRateHz, values);
    if (isStruck(now) && now[ParameterId::level] <=
                             highestLevel(before.instrument, surface, sampleRateHz, now) + 0.1)
        level = std::min(level, highestLevel(built, surface, sampleRateHz, values));
    if (std::isfinite(level))
        values.set(ParameterId::level, level);
    return values;
}

} // namespace idiophone
