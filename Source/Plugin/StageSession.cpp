#include "Plugin/StageSession.h"

#include "Instrument/OwnSlots.h"
#include "Plugin/SoundPicture.h"

namespace idiophone {

bool StageSession::hasStage() const {
    const auto playing = session.instrument();
    return playing != nullptr && playing->stage() != nullptr;
}

std::vector<BodyNow> StageSession::stageBodies() const {
    const auto playing = session.instrument();
    if (playing == nullptr || !playing->stage())
        return {};
    return bodiesAt(playing->stage()->firstPoses(), objectsOfSlots(*playing));
}

/// Brings the capture up to date.
StageCapture& StageSession::capture() {
    report.capture.follow(session.instrument());
    return report.capture;
}

void StageSession::resetStage() {
    messages.stageReset = true;
    capture().clear();
}

bool StageSession::hasCaptured() {
    return capture().count() > 0;
}

bool StageSession::writeCapture(CaptureKind kind, const std::filesystem::path& file) {
    constexpr double usualTempo = 120;
    const double beatsPerMinute = report.tempo > 0 ? report.tempo.load() : usualTempo;
    const auto written = kind == CaptureKind::midi ? capture().writeMidi(file, beatsPerMinute)
                                                   : capture().writeImpulses(file);
    if (!written)
        session.reportError("The capture was not written: " + written.error().message);
    return written.has_value();
}

} // namespace idiophone
