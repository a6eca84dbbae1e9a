#include "Plugin/KitSession.h"

#include "Editor/Utf8.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/StereoSpan.h"
#include "Plugin/KitSound.h"
#include "Plugin/PlayInstead.h"

#include <algorithm>
#include <span>

namespace idiophone {
namespace {

static_assert(KitView::chokeGroups == maximumChokeGroup && KitView::outputs == maximumOutputs);

std::span<const KitPart> partsOf(const std::shared_ptr<const Instrument>& instrument) {
    if (instrument == nullptr)
        return {};
    const auto& parts = instrument->keyMap().parts;
    return {parts.begin(), parts.size()};
}

/// Returns "Brake drum" for a factory object and "Marimba" for its bars. Other objects have names
/// given by people.
std::string nameOf(const Instrument& instrument, const KitPart& part) {
    for (std::size_t slot = 0; slot < instrument.slots().size(); ++slot) {
        if (instrument.part(slot) != &part)
            continue;
        auto name = fromUtf8(instrument.slots()[slot].object->name);
        if (part.keyMap.kind == KeyMapKind::bars)
            name = name.trimCharactersAtEnd("0123456789").trimCharactersAtEnd("- ");
        if (factoryObject(instrument.objectName(slot)))
            name = name.substring(0, 1).toUpperCase() + name.substring(1).replace("-", " ");
        return name.toStdString();
    }
    return {};
}

KitView::Part shown(const KitPart& part, std::string name) {
    return {.object = std::move(name),
            .lowestNote = part.keyMap.lowestNote,
            .highestNote = part.keyMap.highestNote,
            .lowestVelocity = part.lowestVelocity,
            .highestVelocity = part.highestVelocity,
            .levelDb = part.levelDb,
            .chokeGroup = part.chokeGroup,
            .output = part.output,
            .material = part.material,
            .mallet = part.mallet};
}

std::optional<int> validChoice(ParameterId parameter, const std::optional<int>& choice) {
    if (!choice || (parameter == ParameterId::material && *choice == customMaterial))
        return std::nullopt;
    return static_cast<int>(parameterInfo(parameter).clamped(*choice));
}

KitPart changed(KitPart part, const KitView::Part& wanted) {
    const auto [lowest, highest] = std::minmax(
        {std::clamp(wanted.lowestNote, 0, 127), std::clamp(wanted.highestNote, 0, 127)});
    const auto [softest, hardest] = std::minmax(
        {std::clamp(wanted.lowestVelocity, 1, 127), std::clamp(wanted.highestVelocity, 1, 127)});
    if (lowest != part.keyMap.lowestNote || highest != part.keyMap.highestNote)
        part.keyMap = onKeys(part.keyMap, lowest, highest);
    part.lowestVelocity = softest;
    part.highestVelocity = hardest;
    part.levelDb = std::clamp(wanted.levelDb, -KitView::maximumLevelDb, KitView::maximumLevelDb);
    part.chokeGroup = std::clamp(wanted.chokeGroup, 0, KitView::chokeGroups);
    part.output = std::clamp(wanted.output, 0, KitView::outputs);
    part.material = validChoice(ParameterId::material, wanted.material);
    part.mallet = validChoice(ParameterId::mallet, wanted.mallet);
    return part;
}

/// Returns what an undo step calls the change.
std::string changeOf(const KitPart& before, const KitPart& after) {
    return before.keyMap != after.keyMap           ? "Keys"
           : before.levelDb != after.levelDb       ? "Level"
           : before.chokeGroup != after.chokeGroup ? "Choke group"
           : before.output != after.output         ? "Output"
           : before.material != after.material     ? "Material"
           : before.mallet != after.mallet         ? "Mallet"
                                                   : "Velocities";
}

} // namespace

std::vector<KitView::Part> KitSession::kitParts() const {
    const auto playing = session.instrument();
    std::vector<Part> parts;
    for (const auto& part : partsOf(playing))
        parts.push_back(shown(part, nameOf(*playing, part)));
    return parts;
}

Result<void> KitSession::canBeKit() const {
    return idiophone::canBeKit(session.loadedSound());
}

void KitSession::makeKit() {
    const auto now = session.loaded();
    if (partsOf(now.sound.instrument).empty())
        play(now, asKit(now.sound), "Make a kit", "This sound cannot be a kit");
}

void KitSession::changePart(std::size_t index, const Part& wanted) {
    const auto now = session.loaded();
    const auto parts = partsOf(now.sound.instrument);
    if (index >= parts.size())
        return;
    const auto part = changed(parts[index], wanted);
    if (part == parts[index])
        return;
    const auto name = nameOf(*now.sound.instrument, parts[index]);
    play(now, withChangedPart(now.sound, index, part), changeOf(parts[index], part) + " of " + name,
         name + " stays as it was");
}

void KitSession::removePart(std::size_t index) {
    const auto now = session.loaded();
    const auto parts = partsOf(now.sound.instrument);
    if (index >= parts.size())
        return;
    const auto name = nameOf(*now.sound.instrument, parts[index]);
    play(now, withoutPart(now.sound, index), "Remove " + name, name + " stays");
}

void KitSession::play(const SoundSession::Loaded& now,
                      const Result<Sound>& wanted,
                      const std::string& step,
                      const std::string& refusal) {
    if (!wanted)
        return session.reportError(refusal + ": " + wanted.error().message + ".");
    history.keepAudition(); // editing an auditioned sound keeps it
    history.record(step, [&] { playInstead(shared, session, now, *wanted, LoadOrigin::stays); });
}

} // namespace idiophone
