#include "Plugin/PresetSound.h"

#include "Instrument/LoudnessMatch.h"
#include "Plugin/FactoryPrograms.h"

#include <utility>

namespace idiophone {
namespace {

constexpr double anyRateHz = 48000; // both sides of a match use the same rate

} // namespace

Sound soundWith(Preset preset,
                std::shared_ptr<const Instrument> instrument,
                std::string id,
                std::uint64_t content) {
    const auto values = preset.parameters;
    preset.parameters = preset.matched();
    preset.matchedTo.reset();
    return {.preset = std::move(preset),
            .instrument = std::move(instrument),
            .parameters = values,
            .presetId = std::move(id),
            .presetContent = content,
            .stored = values};
}

Result<Sound> factorySound(const Preset& preset) {
    auto built = buildInstrument(preset.keyMap, {});
    if (!built)
        return failure(preset.name + " cannot be played: " + built.error().message);
    return soundWith(preset, std::move(*built), factoryPresetId(preset.name));
}

void storeValues(const Sound& sound, Preset& preset) {
    preset.parameters = withSetupOf({}, sound.parameters);
    const LoudnessMatch match({sound.instrument, sound.preset.surface, anyRateHz},
                              sound.preset.parameters);
    const auto& level = parameterInfo(ParameterId::level);
    const double wanted = preset.parameters[level.parameter] + match.gainDb(preset.parameters);
    if (level.minimum <= wanted && wanted <= level.maximum) {
        preset.parameters.set(level.parameter, wanted);
        preset.matchedTo.reset();
    } else {
        preset.matchedTo = withSetupOf({}, sound.preset.parameters);
    }
}

} // namespace idiophone
