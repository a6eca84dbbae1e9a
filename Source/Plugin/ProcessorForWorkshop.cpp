// What becomes of objects made in the workshop: how keys play them, and how loud.
#include "Plugin/Processor.h"

#include "Geometry/ObjectMesh.h"
#include "Instrument/SingleObjectMap.h"
#include "Instrument/StartingLevel.h"
#include "Plugin/FileKinds.h"
#include "Plugin/ImportSummary.h"
#include "Plugin/ObjectEmbedding.h"

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

bool isStruck(const ParameterValues& values) {
    return static_cast<int>(values[ParameterId::contact]) == strikeContact;
}

} // namespace

bool Processor::canOpen(const std::filesystem::path& file) const {
    return isMeshFile(file) || isModalFile(file);
}

void Processor::beginImport() {
    importLoads = loads;
    importFailureShown = false;
    startTimer(busyMilliseconds); // else what is made would wait for a timer at rest
}

void Processor::openFile(const std::filesystem::path& file) {
    beginImport();
    workshop.open(file, importSettings);
}

bool Processor::canAnalyseAgain() const {
    return followsImportSettings() || keyLayout().has_value();
}

void Processor::setImportSettings(const ImportSettings& settings) {
    importSettings = settings;
    if (followsImportSettings())
        analyseAgain();
}

void Processor::analyseAgain() {
    const bool isOurs = followsImportSettings();
    if (!isOurs && !keyLayout())
        return;
    beginImport();
    if (isOurs)
        return workshop.analyseAgain(importSettings);
    const auto playing = loadedInstrument();
    const auto& object = *playing->slots().front().object;
    workshop.analyse(objectMesh(object), object.name, importSettings);
}

ImportStatus Processor::importStatus() const {
    auto status = workshop.status();
    status.followsSettings = followsImportSettings();
    status.settings = importSettings;
    return status;
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
    if (isNew || map.kind == KeyMapKind::bars)
        map = singleObjectMap(object, product.objectName, KeyMapKind::scaled);
    map.object = product.objectName;
    map.referenceNote = -1;
    preset.name = object.name;
    preset.author.clear();
    preset.description = object.name + ": " + summaryOf(object);
    preset.tags = {"imported"};
    preset.unknownParameters.clear();
    preset.mutedModes = {};
    auto built = buildSingleObject(map, product.object);
    if (!built) {
        const std::scoped_lock lock(soundMutex);
        lastError = object.name + " cannot be played: " + built.error().message;
        return;
    }
    if (product.isFirst) {
        values.set(ParameterId::material, ownMaterial);
        values.set(ParameterId::thickness, parameterInfo(ParameterId::thickness).defaultValue);
        if (isNew && isStruck(values))
            values = withAudibleMallet(*built, preset.surface, rateHz(), values);
        preset.parameters = values;
    }
    const auto former = loadedInstrument();
    const auto play = [&] {
        if (!isNew || !isStruck(values)) // scrapes and rolls are predicted but for a constant
            return playAsLoud(preset, *built, values);
        values.set(ParameterId::level, startingLevel(*built, preset.surface, rateHz(), values));
        playAtOwnLevel(preset, *built, values);
    };
    if (product.isFirst) {
        history.record((product.isNewFile ? "Open " : "Analyse ") + object.name, play);
    } else {
        play();
        if (former != nullptr)
            renewHistory(*former->slots().front().object, product.object);
    }
    importLoads = loads;
}

/// Steps that know the preview know the whole object from now on, by whatever keys they play it.
void Processor::renewHistory(const ModalObject& preview,
                             const std::shared_ptr<const ModalObject>& whole) {
    const auto now = loadedSound();
    std::map<const Instrument*, std::shared_ptr<const Instrument>> renewed;
    history.renewSounds([&](Sound& known) {
        if (!plays(known.instrument, preview))
            return;
        auto map = known.preset.keyMap;
        map.object = now.preset.keyMap.object;
        auto& instrumentNow = renewed[known.instrument.get()];
        if (instrumentNow == nullptr && map == now.preset.keyMap)
            instrumentNow = now.instrument;
        if (instrumentNow == nullptr)
            instrumentNow = buildSingleObject(map, whole).value_or(nullptr);
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

/// With the level that keeps what plays as loud as it is, and where that had headroom, leaves it.
void Processor::playAsLoud(const Preset& preset,
                           const std::shared_ptr<const Instrument>& built,
                           ParameterValues values) {
    const auto now = parameters.values();
    if (const auto before = loadedInstrument(); before != nullptr) {
        const auto& surface = preset.surface;
        double level = now[ParameterId::level] + predictedLufs(before, surface, rateHz(), now) -
                       predictedLufs(built, surface, rateHz(), values);
        if (isStruck(now) &&
            now[ParameterId::level] <= highestLevel(before, surface, rateHz(), now) + 0.1)
            level = std::min(level, highestLevel(built, surface, rateHz(), values));
        if (std::isfinite(level))
            values.set(ParameterId::level, level);
    }
    playAtOwnLevel(preset, built, values);
}

void Processor::playAtOwnLevel(const Preset& preset,
                               const std::shared_ptr<const Instrument>& built,
                               const ParameterValues& values) {
    {
        const std::scoped_lock lock(soundMutex);
        parameters.load(values);
        play(preset, built);
        programIndex = -1;
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
    playMapped(map, layout == KeyLayout::zones ? "Keys along a path" : "Keys at their pitches");
}

std::vector<std::array<double, 3>> Processor::strikePath(std::size_t index) const {
    const auto playing = loadedInstrument();
    if (playing == nullptr || playing->stage())
        return {};
    const auto slots = ownSlots(*playing);
    if (index >= slots.size())
        return {};
    return pathMetres(*playing->slots()[slots[index]].object, playing->keyMap());
}

void Processor::setStrikePath(std::size_t index, const std::vector<std::array<double, 3>>& metres) {
    const auto playing = loadedInstrument();
    if (playing == nullptr || playing->stage())
        return;
    const auto slots = ownSlots(*playing);
    if (index >= slots.size())
        return;
    auto map = playing->keyMap();
    map.strikePath = relativePath(*playing->slots()[slots[index]].object, metres);
    if (!map.strikePath.empty())
        playMapped(map, "Strike path");
}

/// The same objects, played by other keys or at other places.
void Processor::playMapped(const KeyMap& map, const std::string& step) {
    const bool isOurs = importLoads == loads;
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
    history.record(step, [&] { playAsLoud(preset, *built, parameters.values()); });
    importLoads = isOurs ? loads.load() : -1;
}

} // namespace idiophone
