// The window's view of a stage, whose keys move simulated bodies instead of striking objects.
#pragma once

#include "Editor/SoundView.h"

#include <filesystem>
#include <vector>

namespace idiophone {

/// For the message thread.
class StageView {
public:
    /// File formats of a capture: the impacts on the stage since it was loaded or last reset.
    enum class CaptureKind {
        midi,    ///< a Standard MIDI File at the host's tempo
        impulses ///< a list for `idiophone render --impulses`
    };

    virtual ~StageView() = default;

    /// Whether the instrument is on a stage.
    virtual bool hasStage() const = 0;
    /// The bodies before the first note.
    virtual std::vector<BodyNow> stageBodies() const = 0;
    /// On a stage: a pause stops bodies in place, and a reset removes them.
    virtual void pauseStage(bool isPaused) = 0;
    virtual bool isStagePaused() const = 0;
    virtual void resetStage() = 0;
    virtual bool hasCaptured() = 0;
    /// Writes the captured impacts to a file, and replaces it. Returns false and reports the error
    /// in the status on failure.
    virtual bool writeCapture(CaptureKind kind, const std::filesystem::path& file) = 0;
};

} // namespace idiophone
