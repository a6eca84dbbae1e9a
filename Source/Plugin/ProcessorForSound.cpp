// Shows the sound to the window, and mutes modes or plays them alone.
#include "Plugin/Processor.h"

#include "Instrument/SilencedModes.h"
#include "Plugin/OwnSlots.h"

#include <utility>

namespace idiophone {
namespace {

constexpr int asksPerSilentPicture = 10;

} // namespace

const SoundFrame* Processor::takeSoundFrame() {
    PictureSubject subject;
    double rateHz;
    {
        const std::scoped_lock lock(soundMutex);
        subject = {.instrument = instrument,
                   .instrumentNumber = loads,
                   .muted = loadedPreset.mutedModes,
                   .heardAlone = modesHeardAlone};
        rateHz = preparedRateHz > 0 ? preparedRateHz : 44100;
    }
    const MonitoredSound* monitored = monitor.take();
    const auto playing = subject.instrument;
    if (playing == nullptr || playing->slots().empty())
        return nullptr;
    // A new instrument has other objects.
    if (std::exchange(watchedInstrument, subject.instrumentNumber) != subject.instrumentNumber)
        watchObject(std::nullopt);
    picture.show(std::move(subject));
    if (monitored != nullptr && monitored->instrument == playing->serialNumber()) {
        asksUnanswered = 0;
        return &picture.of(*monitored);
    }
    if (++asksUnanswered % asksPerSilentPicture != 0)
        return nullptr;
    const auto own = ownSlots(*playing);
    const std::size_t shown = watched && *watched < own.size() ? own[*watched] : own.front();
    return &picture.ofSilence(shown, parameters.values(), rateHz);
}

void Processor::watchObject(std::optional<std::size_t> object) {
    watched = object;
    watchedInstrument = loads;
    const auto playing = loadedInstrument();
    if (playing == nullptr)
        return;
    const auto own = ownSlots(*playing);
    monitor.watch(object && *object < own.size() ? std::optional(own[*object]) : std::nullopt);
}

bool Processor::muteMode(std::size_t object, std::int32_t mode, bool isMuted) {
    bool done = false;
    history.record(isMuted ? "Mute mode" : "Unmute mode", [&] {
        done = changeModes(object, [&](const std::string& key, std::size_t modeCount) {
            return mode >= 0 && static_cast<std::size_t>(mode) < modeCount &&
                   loadedPreset.mutedModes.set(key, mode, isMuted);
        });
    });
    if (done)
        updateHostDisplay(ChangeDetails().withNonParameterStateChanged(true));
    return done;
}

bool Processor::hearModeAlone(std::size_t object, std::int32_t mode, bool isAlone) {
    return changeModes(object, [&](const std::string& key, std::size_t modeCount) {
        return mode >= 0 && static_cast<std::size_t>(mode) < modeCount &&
               modesHeardAlone.set(key, mode, isAlone);
    });
}

void Processor::unmuteModes(std::size_t object) {
    bool done = false;
    history.record("Unmute modes", [&] {
        done = changeModes(object, [&](const std::string& key, std::size_t) {
            loadedPreset.mutedModes.clear(key);
            return true;
        });
    });
    if (done)
        updateHostDisplay(ChangeDetails().withNonParameterStateChanged(true));
}

void Processor::hearAllModes(std::size_t object) {
    changeModes(object, [&](const std::string& key, std::size_t) {
        modesHeardAlone.clear(key);
        return true;
    });
}

/// Calls `change` with the object's key in mode sets and its number of modes.
bool Processor::changeModes(
    std::size_t object,
    const std::function<bool(const std::string& key, std::size_t modeCount)>& change) {
    const std::scoped_lock lock(soundMutex);
    if (instrument == nullptr)
        return false;
    const auto own = ownSlots(*instrument);
    if (object >= own.size() || !change(modeSetKey(*instrument, own[object]),
                                        instrument->slots()[own[object]].object->modeCount()))
        return false;
    sendSilences();
    return true;
}

/// Call under soundMutex with an instrument.
void Processor::sendSilences() {
    silencer.send(*instrument,
                  silencedModes(*instrument, loadedPreset.mutedModes, modesHeardAlone));
}

} // namespace idiophone
