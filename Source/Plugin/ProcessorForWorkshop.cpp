// Plays objects made in the workshop: maps them to keys and matches their loudness.
#include "Plugin/Processor.h"

#include "Geometry/ObjectMesh.h"
#include "Instrument/SingleObjectMap.h"
#include "Instrument/StartingLevel.h"
#include "Object/Material.h"
#include "Object/OneLine.h"
#include "Plugin/FileKinds.h"
#include "Plugin/ImportSummary.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/OwnSlots.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace idiophone {
namespace {

constexpr KeyMapKind kindOf(KeyLayout layout) {
    return layout == KeyLayout::zones ? KeyMapKind::zones : KeyMapKind::scaled;
}

bool plays(const std::shared_ptr<const Instrument>& instrument, const ModalObject& object) {
    return instrument != nullptr && !instrument->slots().empty() &&
           instrument->slots().front().object.get() == &object;
}

/// Returns nothing if each key has an object of its own.
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

bool isStruck(const ParameterValues& values) {
    return static_cast<int>(values[ParameterId::contact]) == strikeContact;
}

} // namespace

bool Processor::canOpen(const std::filesystem::path& file) const {
    return isMeshFile(file) || isModalFile(file);
}

std::string Processor::openPatterns() const {
    return objectFilePatterns();
}

void Processor::beginImport(int number) {
    shelf.keepAudition(); // the user wants the sound: it is analysed again
    importLoads = number;
    importFailureShown = false;
}

void Processor::openFile(const std::filesystem::path& file) {
    beginImport(loads);
    workshop.open(file, importSettings);
}

bool Processor::canAnalyseAgain() const {
    return followsImportSettings() || keyLayout().has_value();
}

/// Returns the playing single object if it was not made from the workshop's mesh.
std::shared_ptr<const ModalObject> Processor::foreignObject() const {
    if (followsImportSettings())
        return nullptr;
    const auto playing = loadedInstrument();
    return layoutOf(playing) ? playing->slots().front().object : nullptr;
}

/// Returns the settings for the next analysis. A foreign object keeps its own material and
/// thickness until the user gives settings for it. A custom material has no name here; then uses
/// the material that the object was analysed with.
ImportSettings Processor::settingsInForce() const {
    auto settings = importSettings;
    const auto object = foreignObject();
    if (object == nullptr || object == settingsGivenFor.lock())
        return settings;
    const auto values = parameters.values();
    const auto chosen = static_cast<std::size_t>(values[ParameterId::material]);
    const auto names = choiceNames(ParameterId::material);
    const std::string name = chosen >= firstLibraryMaterial && chosen < names.size()
                                 ? std::string(names[chosen])
                                 : object->material.name;
    if (findMaterial(name) != nullptr ||
        std::ranges::find(userMaterials, name, &Material::name) != userMaterials.end())
        settings.material = name;
    if (object->thicknessMetres > 0)
        settings.thicknessMetres = object->thicknessMetres * values[ParameterId::thickness] / 100;
    return settings;
}

void Processor::setImportSettings(const ImportSettings& settings) {
    settingsGivenFor = foreignObject();
    importSettings = settings;
    if (followsImportSettings())
        analyseAgain();
}

void Processor::analyseAgain() {
    const auto now = loaded();
    const bool isOurs = importLoads == now.number && workshop.hasMesh();
    if (!isOurs && !layoutOf(now.sound.instrument))
        return;
    importSettings = settingsInForce(); // the mesh is the workshop's from now on
    beginImport(now.number);
    if (isOurs)
        return workshop.analyseAgain(importSettings);
    const auto& object = *now.sound.instrument->slots().front().object;
    workshop.analyse(objectMesh(object), object.name, importSettings);
}

ImportStatus Processor::importStatus() const {
    const auto object = imported.lock();
    const bool isOfWhatPlays =
        importLoads == loads || (object != nullptr && plays(loadedInstrument(), *object));
    auto status = isOfWhatPlays ? workshop.status() : ImportStatus{};
    status.followsSettings = followsImportSettings();
    status.settings = status.isWorking() ? importSettings : settingsInForce();
    return status;
}

bool Processor::playsPreview() const {
    const auto object = imported.lock();
    if (!importedIsPreview || object == nullptr || !plays(loadedInstrument(), *object))
        return false;
    const auto stage = workshop.status().stage; // if it is done, the whole object follows
    return stage == ImportStatus::Stage::previewed || stage == ImportStatus::Stage::done;
}

/// Plays a product unless another sound was chosen meanwhile.
void Processor::followWorkshop() {
    if (importLoads != loads)
        return workshop.cancel();
    if (const auto product = workshop.takeProduct()) {
        const auto played = withinMemory(
            [&]() -> Result<void> {
                playProduct(*product);
                return {};
            },
            oneLine(product->object->name));
        if (!played)
            reportError(played.error().message);
        return;
    }
    if (const auto status = workshop.status();
        status.stage == ImportStatus::Stage::failed && !std::exchange(importFailureShown, true))
        reportError(status.error);
}

void Processor::playProduct(const ObjectWorkshop::Product& product) {
    if (product.isFirst)
        shelf.keepAudition(); // recording would end the audition, and so load
    const auto now = loaded();
    if (now.number != importLoads)
        return;
    const auto& object = *product.object;
    auto values = now.sound.parameters;
    auto preset = now.sound.preset;
    auto& map = preset.keyMap;
    const bool isNew = product.isFirst && product.isNewFile;
    if (isNew || map.kind == KeyMapKind::bars)
        map = singleObjectMap(object, product.objectName, KeyMapKind::scaled);
    map.object = product.objectName;
    map.referenceNote = -1;
    preset.name = object.name;
    preset.author.clear();
    preset.description = object.name + ": " + summaryOf(object);
    if (product.isPreview) // a project saved now keeps it
        preset.description += ". A preview of few elements: analyse it again for all modes.";
    preset.tags = {"imported"};
    preset.mutedModes = {};
    const auto built = buildSingleObject(map, product.object);
    if (!built)
        return reportError(object.name + " cannot be played: " + built.error().message);
    if (product.isFirst) {
        values.set(ParameterId::material, ownMaterial);
        values.set(ParameterId::thickness, parameterInfo(ParameterId::thickness).defaultValue);
        if (isNew && isStruck(values))
            values = withAudibleMallet(*built, preset.surface, rateHz(), values);
        preset.parameters = values;
    }
    // The loudness of scrapes and rolls is predicted only up to a constant.
    if (isNew && isStruck(values))
        values.set(ParameterId::level, startingLevel(*built, preset.surface, rateHz(), values));
    else
        values = asLoudAs(now.sound, preset, *built, values);

    std::optional<int> number;
    const auto play = [&] { number = playInstead(now, preset, *built, values); };
    if (product.isFirst)
        history.record((product.isNewFile ? "Open " : "Analyse ") + object.name, play);
    else
        play();
    if (!number)
        return;
    importLoads = *number;
    imported = product.object;
    importedIsPreview = product.isPreview;
    if (!product.isFirst && now.sound.instrument != nullptr)
        renewHistory(*now.sound.instrument->slots().front().object, map, *built);
}

/// Replaces the preview by the whole object in all undo steps, with their own key maps.
void Processor::renewHistory(const ModalObject& preview,
                             const KeyMap& wholeMap,
                             const std::shared_ptr<const Instrument>& whole) {
    const auto& object = whole->slots().front().object;
    std::map<const Instrument*, std::shared_ptr<const Instrument>> renewed;
    history.renewSounds([&](Sound& known) {
        if (!plays(known.instrument, preview))
            return;
        auto map = known.preset.keyMap;
        map.object = wholeMap.object;
        auto& instrumentNow = renewed[known.instrument.get()];
        if (instrumentNow == nullptr && map == wholeMap)
            instrumentNow = whole;
        if (instrumentNow == nullptr)
            instrumentNow = buildSingleObject(map, object).value_or(nullptr);
        if (instrumentNow == nullptr)
            return;
        known.instrument = instrumentNow;
        known.preset.keyMap = map;
    });
}

double Processor::rateHz() const {
    const std::scoped_lock lock(soundMutex);
    return preparedRateHz > 0 ? preparedRateHz : 48000;
}

/// Matches the loudness of the current sound and keeps its headroom.
ParameterValues Processor::asLoudAs(const Sound& before,
                                    const Preset& preset,
                                    const std::shared_ptr<const Instrument>& built,
                                    ParameterValues values) const {
    const auto& now = before.parameters;
    if (before.instrument == nullptr)
        return values;
    const auto& surface = preset.surface;
    double level = now[ParameterId::level] +
                   predictedLufs(before.instrument, surface, rateHz(), now) -
                   predictedLufs(built, surface, rateHz(), values);
    if (isStruck(now) &&
        now[ParameterId::level] <= highestLevel(before.instrument, surface, rateHz(), now) + 0.1)
        level = std::min(level, highestLevel(built, surface, rateHz(), values));
    if (std::isfinite(level))
        values.set(ParameterId::level, level);
    return values;
}

/// Plays `preset` instead of the loaded sound, and changes only the parameters that differ between
/// its values and `values`. Returns the number of the load. Returns nothing if the loaded sound
/// plays no more, or if memory does not suffice, which it reports.
std::optional<int> Processor::playInstead(const Loaded& now,
                                          const Preset& preset,
                                          const std::shared_ptr<const Instrument>& built,
                                          const ParameterValues& values) {
    int number;
    {
        const std::scoped_lock lock(soundMutex);
        if (loads != now.number)
            return std::nullopt;
        auto player =
            newPlayer(built, preset, parameters.valuesAfter(now.sound.parameters, values));
        if (!player) {
            lastError = player.error().message;
            return std::nullopt;
        }
        play(preset, built, std::move(*player),
             [&] { parameters.loadChanges(now.sound.parameters, values); });
        programIndex = -1;
        number = loads;
    }
    tellOfSound();
    return number;
}

std::optional<KeyLayout> Processor::keyLayout() const {
    return layoutOf(loadedInstrument());
}

void Processor::setKeyLayout(KeyLayout layout) {
    const auto now = loaded();
    const auto before = layoutOf(now.sound.instrument);
    if (!before || *before == layout)
        return;
    auto map = now.sound.instrument->keyMap();
    map.kind = kindOf(layout);
    playMapped(now, map,
               layout == KeyLayout::zones ? "Keys along a path" : "Keys at their pitches");
}

void Processor::setStrikePath(std::size_t index, const std::vector<std::array<double, 3>>& metres) {
    const auto now = loaded();
    const auto& playing = now.sound.instrument;
    if (playing == nullptr || playing->stage())
        return;
    const auto slots = ownSlots(*playing);
    if (index >= slots.size())
        return;
    auto map = playing->keyMap();
    map.strikePath = relativePath(*playing->slots()[slots[index]].object, metres);
    if (!map.strikePath.empty())
        playMapped(now, map, "Strike path");
}

/// Plays the same objects by other keys or at other places.
void Processor::playMapped(const Loaded& now, const KeyMap& map, const std::string& step) {
    if (now.sound.missing != nullptr) // a new map would drop the missing objects
        return reportError("The keys cannot be changed while a steel ring plays in the place of " +
                           now.sound.missing->first + ", which is missing.");
    const bool isOurs = importLoads == now.number;
    const auto built = rebuilt(*now.sound.instrument, map);
    if (!built)
        return reportError("The keys cannot be changed: " + built.error().message);
    auto preset = now.sound.preset;
    preset.keyMap = map;
    const auto values = asLoudAs(now.sound, preset, *built, now.sound.parameters);
    shelf.keepAudition(); // the user wants the sound: its keys are changed
    std::optional<int> number;
    history.record(step, [&] { number = playInstead(now, preset, *built, values); });
    if (number)
        importLoads = isOurs ? *number : -1;
}

} // namespace idiophone
