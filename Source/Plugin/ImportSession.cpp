#include "Plugin/ImportSession.h"

#include "Editor/ModeText.h"
#include "Instrument/OwnSlots.h"
#include "Instrument/SingleObjectMap.h"
#include "Mesh/ObjectMesh.h"
#include "Object/Material.h"
#include "Object/OneLine.h"
#include "Plugin/ImportSummary.h"
#include "Plugin/KitSound.h"
#include "Plugin/PlayInstead.h"
#include "Plugin/WithinMemory.h"

#include <utility>

namespace idiophone {
void ImportSession::begin(int originOfJob, std::optional<int> midiNote) {
    history.keepAudition(); // analysing an auditioned sound keeps it
    origin = originOfJob;
    keyOfJob = midiNote;
    if (!keyOfJob)
        pendingFiles.clear();
    failureShown = false;
}

void ImportSession::open(const File& file) {
    begin(session.origin(), file.key);
    importSettings.longestMetres = 0; // a new file has its own size, and parts of its own
    importSettings.held = {.quality = importSettings.held.quality};
    workshop.open(file.path, importSettings);
}

/// Waits for the object of another key, which would remain a preview.
void ImportSession::openFileOnKey(const std::filesystem::path& file, int midiNote) {
    const File opened{.path = file, .key = midiNote};
    if (!keyOfJob || origin != session.origin())
        return open(opened);
    pendingFiles.push_back(opened);
    poll(); // opens it now if nothing is being made
}

void ImportSession::cancelImport() {
    pendingFiles.clear();
    workshop.cancel();
}

/// Returns the playing single object if it was not made from the workshop's mesh.
std::shared_ptr<const ModalObject> ImportSession::foreignObject() const {
    if (followsSettings())
        return nullptr;
    const auto playing = session.instrument();
    return layoutOf(playing) ? playing->slots().front().object : nullptr;
}

/// Returns the settings for the next analysis. A foreign object keeps its own material and
/// thickness until the user gives settings for it. A custom material has no name here; then uses
/// the material that the object was analysed with.
ImportSettings ImportSession::settingsInForce() const {
    auto settings = importSettings;
    const auto object = foreignObject();
    if (followsSettings() || (object != nullptr && object == settingsGivenFor.lock()))
        return settings;
    using Held = HeldSettings::Kind;
    const bool wasHeld = object != nullptr && !object->clampedVertices.empty();
    settings.held = {.kind = wasHeld ? Held::asBefore : Held::free,
                     .quality = settings.held.quality};
    if (object == nullptr)
        return settings;
    const auto values = shared.parameters.values();
    settings.longestMetres = 0;
    settings.thicknessMetres =
        thicknessMetresOf(*object, values).value_or(settings.thicknessMetres);
    const auto name = materialNameOf(*object, values);
    if (findMaterial(name) != nullptr || materials.contains(name))
        settings.material = name;
    return settings;
}

void ImportSession::setImportSettings(const ImportSettings& settings) {
    settingsGivenFor = foreignObject();
    auto before = std::exchange(importSettings, settings);
    const bool changed = before != settings;
    if (before.held.isFree() && settings.held.isFree())
        before.held = settings.held;
    const bool isWithoutEffect = changed && before == settings; // such as nothing painted yet
    if (followsSettings() && !isWithoutEffect)
        analyseAgain();
}

bool ImportSession::canAnalyseAgain() const {
    const auto object = foreignObject();
    return followsSettings() || // a recorded object has no mesh of its own
           (object != nullptr && object->method != "measured");
}

void ImportSession::analyseAgain() {
    const auto now = session.loaded();
    const bool isOurs = followsSettings();
    if (!isOurs && !canAnalyseAgain())
        return;
    importSettings = settingsInForce(); // the mesh is the workshop's from now on
    begin(now.origin, std::nullopt);
    if (isOurs)
        return workshop.analyseAgain(importSettings);
    workshop.analyse(*now.sound.instrument->slots().front().object, importSettings);
}

ImportStatus ImportSession::importStatus() const {
    const bool isOfWhatPlays = origin == session.origin() || importedPlays();
    auto status = isOfWhatPlays ? workshop.status() : ImportStatus{};
    status.followsSettings = followsSettings();
    status.settings = status.isWorking() ? importSettings : settingsInForce();
    if (const auto foreign = foreignObject()) {
        status.sidesMetres = sidesMetresOf(*foreign);
        status.massKg = foreign->mass.massKg;
        status.groups.clear();
        status.wasHeld = !foreign->clampedVertices.empty();
        if (status.stage == ImportStatus::Stage::failed) // the figures are not those of the file
            status.fileName = foreign->name;
    }
    return status;
}

bool ImportSession::playsPreview() const {
    if (!importedIsPreview || !importedPlays())
        return false;
    const auto stage = workshop.status().stage; // the whole object of a finished import follows
    return stage == ImportStatus::Stage::previewed || stage == ImportStatus::Stage::done;
}

void ImportSession::poll() {
    if (origin != session.origin())
        return cancelImport();
    const auto status = workshop.status(); // before the product, which may be made meanwhile
    if (const auto product = workshop.takeProduct()) {
        const auto played = withinMemory(
            [&]() -> Result<void> {
                keyOfJob ? putOnKey(*product, *keyOfJob) : play(*product);
                return {};
            },
            oneLine(product->object->name));
        if (!played)
            session.reportError(played.error().message);
    }
    if (status.stage == ImportStatus::Stage::failed && !std::exchange(failureShown, true))
        session.reportError(status.error);
    if (!status.isWorking() && !pendingFiles.empty()) {
        const auto next = std::move(pendingFiles.front());
        pendingFiles.pop_front();
        open(next);
    }
}

void ImportSession::play(const ObjectWorkshop::Product& product) {
    if (product.isFirst)
        history.keepAudition(); // recording would end the audition and load the sound before it
    const auto now = session.loaded();
    if (now.origin != origin)
        return;
    const auto sound = soundOf(product, now.sound, session.rateHz());
    if (!sound)
        return session.reportError(sound.error().message);
    std::optional<int> number;
    const auto play = [&] {
        number = playInstead(shared, session, now, *sound, LoadOrigin::isNew);
    };
    if (product.isFirst)
        history.record((product.isNewFile ? "Open " : "Analyse ") + product.object->name, play);
    else
        play();
    if (!number)
        return;
    origin = *number;
    imported = product.object;
    importedIsPreview = product.isPreview;
    if (!product.isFirst && now.sound.instrument != nullptr)
        renewHistory(now.sound.instrument->slots().front().object, product,
                     {{now.sound.instrument.get(), sound->instrument}});
}

/// The preview and the whole object are one step of undo.
void ImportSession::putOnKey(const ObjectWorkshop::Product& product, int midiNote) {
    if (product.isFirst)
        putFirst(product, midiNote);
    else
        replacePreview(product);
    imported = product.object;
    importedIsPreview = product.isPreview;
}

void ImportSession::putFirst(const ObjectWorkshop::Product& product, int midiNote) {
    imported.reset();
    history.keepAudition();
    const auto now = session.loaded();
    if (now.origin != origin)
        return;
    const auto key = noteName(midiNote).toStdString();
    const auto& name = product.object->name;
    const auto sound =
        withObjectOnKey(now.sound, midiNote, product.object, product.objectName, session.rateHz());
    if (!sound) {
        workshop.cancel(); // the whole object would be refused too
        return session.reportError(name + " cannot be put on " + key + ": " +
                                   sound.error().message + ".");
    }
    history.record("Put " + name + " on " + key,
                   [&] { playInstead(shared, session, now, *sound, LoadOrigin::stays); });
}

/// The user may have changed the kit meanwhile, or undone the step of the preview.
void ImportSession::replacePreview(const ObjectWorkshop::Product& whole) {
    const auto preview = imported.lock();
    if (preview == nullptr) // no step keeps it
        return;
    const auto now = session.loaded();
    Renewed renewed;
    if (plays(now.sound.instrument, *preview)) {
        const auto sound =
            withWholeObject(now.sound, preview, whole.object, whole.objectName, session.rateHz());
        if (!sound)
            return session.reportError(whole.object->name +
                                       " stays a preview: " + sound.error().message + ".");
        playInstead(shared, session, now, *sound, LoadOrigin::stays);
        renewed[now.sound.instrument.get()] = sound->instrument;
    }
    renewHistory(preview, whole, std::move(renewed));
}

/// Replaces the preview by the whole object in all undo steps, with their own key maps. `renewed`
/// holds the instruments that have it already.
void ImportSession::renewHistory(const std::shared_ptr<const ModalObject>& preview,
                                 const ObjectWorkshop::Product& whole,
                                 Renewed renewed) {
    history.renewSounds([&](Sound& known) {
        if (!plays(known.instrument, *preview))
            return;
        auto& instrumentNow = renewed[known.instrument.get()];
        if (instrumentNow == nullptr)
            instrumentNow =
                withWholeObject(known, preview, whole.object, whole.objectName, session.rateHz())
                    .value_or(known)
                    .instrument;
        known.instrument = instrumentNow;
        known.preset.keyMap = instrumentNow->keyMap();
    });
}

void ImportSession::setKeyLayout(KeyLayout layout) {
    const auto now = session.loaded();
    const auto before = layoutOf(now.sound.instrument);
    if (!before || *before == layout)
        return;
    const bool isPath = layout == KeyLayout::zones;
    auto map = now.sound.instrument->keyMap();
    map.kind = isPath ? KeyMapKind::zones : KeyMapKind::scaled;
    playMapped(now, map, isPath ? "Keys along a path" : "Keys at their pitches");
}

void ImportSession::setStrikePath(std::size_t index,
                                  const std::vector<std::array<double, 3>>& pathMetres) {
    const auto now = session.loaded();
    const auto& playing = now.sound.instrument;
    if (playing == nullptr || playing->stage())
        return;
    const auto slots = ownSlots(*playing);
    if (index >= slots.size())
        return;
    auto map = playing->keyMap();
    map.strikePath = relativePath(*playing->slots()[slots[index]].object, pathMetres);
    if (!map.strikePath.empty())
        playMapped(now, map, "Strike path");
}

/// Plays the same objects with another key map.
void ImportSession::playMapped(const SoundSession::Loaded& now,
                               const KeyMap& map,
                               const std::string& step) {
    if (now.sound.missing != nullptr) // a new map would drop the missing objects
        return session.reportError(
            "The keys cannot be changed while a steel ring plays in the place of " +
            now.sound.missing->first + ", which is missing.");
    const auto built = rebuilt(*now.sound.instrument, map);
    if (!built)
        return session.reportError("The keys cannot be changed: " + built.error().message);
    Sound mapped{.preset = now.sound.preset,
                 .instrument = *built,
                 .parameters = now.sound.parameters,
                 .stored = now.sound.preset.parameters};
    mapped.preset.keyMap = map;
    mapped = asLoudAs(now.sound, std::move(mapped), session.rateHz());
    const bool isOurs = origin == now.origin;
    history.keepAudition(); // changing the keys of an auditioned sound keeps it
    std::optional<int> number;
    history.record(step,
                   [&] { number = playInstead(shared, session, now, mapped, LoadOrigin::isNew); });
    if (number)
        origin = isOurs ? *number : -1;
}

} // namespace idiophone
