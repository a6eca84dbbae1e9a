#include "Plugin/ModeSession.h"

#include "Instrument/OwnSlots.h"
#include "Instrument/SilencedModes.h"

#include <utility>

namespace idiophone {
namespace {

constexpr int asksPerSilentPicture = 10;

bool exists(std::int32_t mode, std::size_t modeCount) {
    return mode >= 0 && static_cast<std::size_t>(mode) < modeCount;
}

} // namespace

const SoundFrame* ModeSession::takeSoundFrame() {
    PictureSubject subject;
    {
        const auto held = session.lock();
        subject = {.instrument = session.playing().instrument,
                   .instrumentNumber = session.number(),
                   .muted = session.playing().preset.mutedModes,
                   .heardAlone = session.modesHeardAlone()};
    }
    const MonitoredSound* monitored = shared.report.monitor.take();
    const auto playing = subject.instrument;
    if (playing == nullptr || playing->slots().empty())
        return nullptr;
    // Watch no object of the last instrument.
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
    return &picture.ofSilence(shown, shared.parameters.values(), session.rateHz());
}

void ModeSession::watchObject(std::optional<std::size_t> object) {
    watched = object;
    watchedInstrument = session.number();
    const auto playing = session.instrument();
    if (playing == nullptr)
        return;
    const auto own = ownSlots(*playing);
    shared.report.monitor.watch(object && *object < own.size() ? std::optional(own[*object])
                                                               : std::nullopt);
}

bool ModeSession::muteMode(std::size_t object, std::int32_t mode, bool isMuted) {
    return record(isMuted ? "Mute mode" : "Unmute mode", object,
                  [&](const std::string& key, std::size_t modeCount) {
                      return exists(mode, modeCount) &&
                             session.playing().preset.mutedModes.set(key, mode, isMuted);
                  });
}

bool ModeSession::hearModeAlone(std::size_t object, std::int32_t mode, bool isAlone) {
    return change(object, [&](const std::string& key, std::size_t modeCount) {
        return exists(mode, modeCount) && session.modesHeardAlone().set(key, mode, isAlone);
    });
}

void ModeSession::unmuteModes(std::size_t object) {
    record("Unmute modes", object, [&](const std::string& key, std::size_t) {
        session.playing().preset.mutedModes.clear(key);
        return true;
    });
}

void ModeSession::hearAllModes(std::size_t object) {
    change(object, [&](const std::string& key, std::size_t) {
        session.modesHeardAlone().clear(key);
        return true;
    });
}

/// Makes the change a step of the history, and reports it to the host.
bool ModeSession::record(const std::string& step, std::size_t object, const Change& changeModes) {
    bool done = false;
    history.record(step, [&] { done = change(object, changeModes); });
    if (done)
        shared.reporter.reportState();
    return done;
}

bool ModeSession::change(std::size_t object, const Change& changeModes) {
    const auto held = session.lock();
    const auto& playing = session.playing().instrument;
    if (playing == nullptr)
        return false;
    const auto own = ownSlots(*playing);
    if (object >= own.size() || !changeModes(modeSetKey(*playing, own[object]),
                                             playing->slots()[own[object]].object->modeCount()))
        return false;
    session.sendSilences();
    return true;
}

} // namespace idiophone
