#include "Plugin/ImportedSound.h"

#include "Instrument/PhrasePrediction.h"
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
        preset.description += ". A preview of few elements, until the whole analysis is done.";
    preset.tags = {"imported"};
    preset.mutedModes = {};
    return preset;
}

} // namespace

std::optional<std::size_t> slotOf(const std::shared_ptr<const Instrument>& instrument,
                                  const ModalObject& object) {
    if (instrument != nullptr)
        for (std::size_t slot = 0; slot < instrument->slots().size(); ++slot)
            if (instrument->slots()[slot].object.get() == &object)
                return slot;
    return std::nullopt;
}

bool plays(const std::shared_ptr<const Instrument>& instrument, const ModalObject& object) {
    return slotOf(instrument, object).has_value();
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
    Sound sound{.preset = presetOf(product, before.preset),
                .parameters = before.parameters,
                .stored = before.parameters};
    const auto built = buildSingleObject(sound.preset.keyMap, product.object);
    if (!built)
        return failure(product.object->name + " cannot be played: " + built.error().message);
    sound.instrument = *built;
    auto& values = sound.parameters;
    const auto& surface = sound.preset.surface;
    const bool isNew = product.isFirst && product.isNewFile;
    if (product.isFirst) {
        values.set(ParameterId::material, ownMaterial);
        values.set(ParameterId::thickness, parameterInfo(ParameterId::thickness).defaultValue);
        if (isNew && isStruck(values))
            values = withAudibleMallet({*built, surface, sampleRateHz}, values);
        sound.preset.parameters = values;
    }
    sound.stored = sound.preset.parameters;
    // The loudness of scrapes and rolls is predicted only up to a constant.
    if (!isNew || !isStruck(values))
        return asLoudAs(before, std::move(sound), sampleRateHz);
    values.set(ParameterId::level, startingLevel({*built, surface, sampleRateHz}, values));
    return sound;
}

Sound asLoudAs(const Sound& before, Sound sound, double sampleRateHz) {
    if (before.instrument == nullptr)
        return sound;
    const auto& now = before.parameters;
    auto& values = sound.parameters;
    const Phrase former(before.instrument, sound.preset.surface, sampleRateHz);
    const Phrase next(sound.instrument, sound.preset.surface, sampleRateHz);
    double level =
        now[ParameterId::level] + predictedLufs(former, now) - predictedLufs(next, values);
    if (isStruck(now) && now[ParameterId::level] <= highestLevel(former, now) + 0.1)
        level = std::min(level, highestLevel(next, values));
    if (std::isfinite(level))
        values.set(ParameterId::level, level);
    return sound;
}

} // namespace idiophone
