// The window's view of the output as sound files: the last seconds, and recordings of any length.
#pragma once

#include <filesystem>
#include <string>

namespace idiophone {

/// For the message thread. WAV files are stereo, 32-bit float, and contain no offline render. The
/// status shows errors.
class RecorderView {
public:
    struct Recording {
        bool isRunning = false;
        double seconds = 0;              ///< recorded so far, or in all
        std::filesystem::path file = {}; ///< the last complete recording; empty before
    };

    virtual ~RecorderView() = default;

    /// Keeps the last 30 s of the output from now on. A window calls it when it opens.
    virtual void keepLastSound() = 0;
    /// Whether anything in the kept output is heard.
    virtual bool hasLastSound() const = 0;
    /// Writes the kept output, without the silence at both ends, and replaces the file. Returns
    /// false on failure.
    virtual bool writeLastSound(const std::filesystem::path& file) = 0;
    /// Records the output from now on, to a new file in the folder "Idiophone" of the user's music.
    virtual void startRecording() = 0;
    /// Ends a running recording, and returns when its file is complete.
    virtual void stopRecording() = 0;
    virtual Recording recording() const = 0;
    /// A name for a sound file without its extension: the preset and the local time.
    virtual std::string newName() const = 0;
};

} // namespace idiophone
