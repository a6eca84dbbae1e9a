// What becomes of objects made in the workshop: how keys play them, and how loud.
#include "Plugin/Processor.h"

#include "Geometry/ObjectMesh.h"
#include "Instrument/LoudnessMatch.h"
#include "Instrument/SingleObjectMap.h"
#include "Plugin/ImportSummary.h"
#include "Plugin/ObjectEmbedding.h"

#include <cmath>

namespace idiophone {
namespace {

/// As PhrasePrediction hears the factory presets, at their levels and velocity 100.
constexpr double wantedLufs = -42;

constexpr KeyMapKind kindOf(KeyLayout layout) {
    return layout == KeyLayout::zones ? KeyMapKind::zones : KeyMapKind::scaled;
}

double predictedLufs(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values) {
    const LoudnessMatch match(instrument, surface, sampleRateHz, values);
    return match.predictedLufs(values)[PhrasePrediction::middleVelocity];
}

} // namespace

bool Processor::canOpen(const std::filesystem::path& file) const {
    return isMeshFile(file) || isModalFile(file);
}

void Processor::openFile(const std::filesystem::path& file) {
    importLoads = loads;
    importFailureShown = false;
    workshop.open(file, importSettings);
}

bool Processor::canAnalyseAgain() const {
    return (importLoads == loads && workshop.hasMesh()) || keyLayout().has_value();
}

void Processor::analyseAgain(const ImportSettings& settings) {
    const auto playing = loadedInstrument();
    const bool ours = importLoads == loads && workshop.hasMesh();
    if (!ours && !keyLayout())
        return;
    importSettings = settings;
    importLoads = loads;
    importFailureShown = false;
    if (ours)
        return workshop.analyseAgain(settings);
    const auto& object = *playing->slots().front().object;
    workshop.analyse(objectMesh(object), object.name, settings);
}

/// A product plays where nothing else was chosen meanwhile.
void Processor::followWorkshop() {
    if (importLoads != loads)
        return workshop.cancel();
    if (const auto product = workshop.takeProduct())
        return playProduct(*product);
    if (const auto status = workshop.status();
        status.stage == ImportStatus::Stage::failed && !std::exchange(importFailureShown, true)) {
        const std::scoped_lock lock(soundMutex);
        lastError = status.error;
    }
}

void Processor::playProduct(const ObjectWorkshop::Product& product) {
    const auto& object = *product.object;
    auto values = parameters.values();
    Preset preset;
    {
        const std::scoped_lock lock(soundMutex);
        preset = loadedPreset;
    }
    auto& map = preset.keyMap;
    const bool isNew = product.isFirst && product.isNewFile;
    if (isNew || map.kind == KeyMapKind::bars) {
        map = singleObjectMap(object, product.objectName, KeyMapKind::scaled);
        preset.mutedModes = {};
    }
    map.object = product.objectName;
    map.referenceNote = -1;
    if (product.isFirst) {
        values.set(ParameterId::material, ownMaterial);
        values.set(ParameterId::thickness, parameterInfo(ParameterId::thickness).defaultValue);
        preset.parameters = values;
    }
    preset.name = object.name;
    preset.author.clear();
    preset.description = object.name + ": " + summaryOf(object);
    preset.tags = {"imported"};
    preset.unknownParameters.clear();
    auto built = buildSingleObject(map, product.object);
    if (!built) {
        const std::scoped_lock lock(soundMutex);
        lastError = object.name + " cannot be played: " + built.error().message;
        return;
    }
    playAsLoud(std::move(preset), std::move(*built), values,
               isNew ? std::optional(wantedLufs) : std::nullopt);
}

/// With the level that a loudness asks for, or else that keeps what plays as loud as it is.
void Processor::playAsLoud(Preset preset,
                           std::shared_ptr<const Instrument> built,
                           ParameterValues values,
                           std::optional<double> lufs) {
    const double rateHz = preparedRateHz > 0 ? preparedRateHz : 48000;
    const auto before = loadedInstrument();
    const auto now = parameters.values();
    const bool isStruck = static_cast<int>(now[ParameterId::contact]) == strikeContact;
    // The loudness of scrapes and rolls is known but for a constant.
    if (before != nullptr && (!lufs || !isStruck))
        lufs = predictedLufs(before, preset.surface, rateHz, now) + now[ParameterId::level];
    const double level = lufs ? *lufs - predictedLufs(built, preset.surface, rateHz, values)
                              : now[ParameterId::level];
    if (std::isfinite(level))
        values.set(ParameterId::level, level);
    {
        const std::scoped_lock lock(soundMutex);
        parameters.load(values);
        play(std::move(preset), std::move(built));
        programIndex = -1;
        importLoads = loads;
    }
    parameters.notifyListeners();
    updateHostDisplay(ChangeDetails().withProgramChanged(true));
}

std::optional<KeyLayout> Processor::keyLayout() const {
    const std::scoped_lock lock(soundMutex);
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

void Processor::setKeyLayout(KeyLayout layout) {
    const auto now = keyLayout();
    if (!now || *now == layout)
        return;
    auto map = loadedInstrument()->keyMap();
    map.kind = kindOf(layout);
    playMapped(map);
}

std::vector<std::array<double, 3>> Processor::strikePath(std::size_t index) const {
    const auto playing = loadedInstrument();
    if (playing == nullptr)
        return {};
    const auto slots = ownSlots(*playing);
    if (index >= slots.size())
        return {};
    return pathMetres(*playing->slots()[slots[index]].object, playing->keyMap());
}

void Processor::setStrikePath(std::size_t index, const std::vector<std::array<double, 3>>& metres) {
    const auto playing = loadedInstrument();
    if (playing == nullptr)
        return;
    const auto slots = ownSlots(*playing);
    if (index >= slots.size())
        return;
    auto map = playing->keyMap();
    map.strikePath = relativePath(*playing->slots()[slots[index]].object, metres);
    if (!map.strikePath.empty())
        playMapped(map);
}

/// The same objects, played by other keys or at other places.
void Processor::playMapped(const KeyMap& map) {
    const bool ours = importLoads == loads;
    auto built = rebuilt(*loadedInstrument(), map);
    if (!built) {
        const std::scoped_lock lock(soundMutex);
        lastError = "The keys cannot be changed: " + built.error().message;
        return;
    }
    Preset preset;
    {
        const std::scoped_lock lock(soundMutex);
        preset = loadedPreset;
    }
    preset.keyMap = map;
    playAsLoud(std::move(preset), std::move(*built), parameters.values(), std::nullopt);
    if (!ours)
        importLoads = -1;
}

} // namespace idiophone
