// Records a rolling sound to a WAV file of any length, on a thread of its own.
#pragma once

#include "AudioFiles/AudioFileWriter.h"
#include "Editor/RecorderView.h"
#include "Plugin/RollingSound.h"

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace idiophone {

/// For one thread, not the audio thread. The audio thread only fills the rolling sound, which this
/// thread follows: juce::AudioFormatWriter::ThreadedWriter would lock a mutex in the callback.
class SoundRecorder {
public:
    /// If less is free on the disk, a recording ends while its file can still be completed.
    static constexpr std::uintmax_t usualFreeBytes = 100'000'000;

    explicit SoundRecorder(std::uintmax_t bytesToLeaveFree = usualFreeBytes)
        : freeBytes(bytesToLeaveFree) {}
    /// Stops.
    ~SoundRecorder() { stop(); }
    SoundRecorder(const SoundRecorder&) = delete;
    SoundRecorder& operator=(const SoundRecorder&) = delete;

    /// Records what follows in the sound, until `stop`, the end of the sound or a fault. The file
    /// is 32-bit float and in its place once it is complete. Stops a running recording. The error
    /// names a file that cannot be written.
    Result<void> start(std::shared_ptr<const RollingSound> from, const std::filesystem::path& to);
    /// Completes the file of a running recording, with all frames written before the call.
    void stop();

    RecorderView::Recording state() const;
    /// Returns why the recording ended by itself, in one sentence, or nothing. Then forgets it.
    std::string takeError();

private:
    // On the recorder's thread.
    void run();
    bool waitForStop();
    Result<void> writeNext();
    std::string reasonToEnd() const;
    void end(const Result<void>& finished, const std::string& reason);

    const std::uintmax_t freeBytes;
    mutable std::mutex mutex; ///< for the next three
    RecorderView::Recording shown;
    std::string error;
    bool stops = false;
    std::condition_variable wake;

    // The recorder's thread's, while it runs.
    std::shared_ptr<const RollingSound> sound;
    std::filesystem::path file;
    std::unique_ptr<AudioFileWriter> writer;
    std::uint64_t first = 0, next = 0; ///< frames of the sound: the recording's first, and the next
    bool hasLost = false;              ///< frames were overwritten before they were read
    std::thread thread;
};

} // namespace idiophone
