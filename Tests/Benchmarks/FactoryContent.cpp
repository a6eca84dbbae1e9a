#include "Benchmarks/FactoryContent.h"

#include "Analysis/FactoryObjects.h"
#include "Console/MidiSong.h"
#include "Instrument/ContactTrain.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/Instrument.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr const char* presetName = "Rosewood Xylophone";

/// Adds a key's strike as the player makes it: place, strength and number of contacts.
void addImpact(const SongEvent& event,
               const Instrument& instrument,
               const ParameterValues& parameters,
               std::uint32_t number,
               std::vector<SceneStrike>& strikes) {
    const Key& key = instrument.key(event.bytes[1]);
    if (key.slot < 0)
        return;
    const auto slot = static_cast<std::size_t>(key.slot);
    const StrikePlace place = strikePlace(key.along, parameters, number);
    const Strike strike =
        malletStrike(key.strip->between(place.along, place.across).point, event.bytes[2],
                     key.mallet, parameters, instrument.slots()[slot]);
    const auto train =
        contactTrain(strike, key.mallet.scale, parameters[ParameterId::chatter], number);
    for (const auto& contact : withFilledNulls(train))
        strikes.push_back({event.seconds + contact.delaySeconds, slot, contact.strike});
}

Result<void> addSong(const std::filesystem::path& file, BenchContent& content) {
    const Preset* preset = findFactoryPreset(presetName);
    if (preset == nullptr)
        return failure(std::string("There is no factory preset '") + presetName + "'.");
    const auto instrument = Instrument::build(preset->keyMap, ObjectLibrary::shared());
    if (!instrument)
        return tl::unexpected(instrument.error());
    const auto song = readMidiSong(file);
    if (!song)
        return tl::unexpected(song.error());

    std::uint32_t number = 0;
    for (const SongEvent& event : song->events)
        if (event.isNoteOn())
            addImpact(event, **instrument, preset->parameters, number++, content.song);
    if (content.song.empty())
        return failure(file.string() + ": the rosewood xylophone has none of its notes");
    std::ranges::stable_sort(content.song, {}, &SceneStrike::seconds);
    content.songName = file.filename().string();
    content.songSlots.assign((*instrument)->slots().begin(), (*instrument)->slots().end());
    content.songSettings = synthesisSettings(preset->parameters);
    return {};
}

} // namespace

Result<BenchContent> factoryBenchContent(const std::filesystem::path& song) {
    BenchContent content;
    for (const auto& name : factoryObjectNames()) {
        auto object = ObjectLibrary::shared().find(name);
        if (!object)
            return tl::unexpected(object.error());
        content.factoryObjects.push_back(std::move(*object));
    }
    if (!song.empty())
        if (auto added = addSong(song, content); !added)
            return tl::unexpected(added.error());
    return content;
}

} // namespace idiophone
