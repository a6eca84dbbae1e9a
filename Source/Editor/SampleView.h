// The window's view of the export of samples: single strikes of the current sound as files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace idiophone {

struct SampleSettings {
    enum class Source {
        keys,  ///< of the instrument, with an SFZ file for samplers
        places ///< of one object, with a table for games
    };

    Source source = Source::keys;
    int lowestKey = 0, highestKey = 127; ///< MIDI notes; those that play nothing are left out
    int every = 1;                       ///< samples every nth of these keys
    std::size_t object = 0;              ///< index into InstrumentView::playedObjects
    int places = 12;                     ///< spread over the object, from 1 on
    int velocities = 5;                  ///< layers, 1 to 127
    int roundRobins = 1;                 ///< of keys, from 1 on
    bool isFlac = false;                 ///< otherwise WAV
    int bitDepth = 24;                   ///< 16 or 24
    int sampleRateHz = 48000;
    int tailDecibels = -60;  ///< where a sample ends, relative to its peak
    int longestSeconds = 60; ///< maximum length of a sample

    bool operator==(const SampleSettings&) const = default;
};

/// The state of the last estimate or export.
struct SampleStatus {
    enum class Stage {
        none,
        estimating,
        estimated, ///< `samples`, `seconds` and `megabytes` are known
        refused,   ///< the sound cannot be sampled with these settings: `sentence` says why
        exporting,
        done,    ///< `samples` lie in `folder`
        stopped, ///< cancelled
        failed   ///< `sentence` says why
    };

    Stage stage = Stage::none;
    std::size_t samples = 0;
    double seconds = 0;                  ///< of all samples together
    double megabytes = 0;                ///< of all files together
    double progress = 0;                 ///< of an export, 0 to 1
    std::optional<int> secondsLeft = {}; ///< of an export, once there is an estimate
    std::string sentence = {};
    std::filesystem::path folder = {}; ///< of the last export

    bool isExporting() const { return stage == Stage::exporting; }
    bool operator==(const SampleStatus&) const = default;
};

/// For the message thread. No call blocks.
class SampleView {
public:
    virtual ~SampleView() = default;

    /// Estimates how many samples the current sound gives and how large they are, unless this has
    /// been done or an export runs.
    virtual void estimateSamples(const SampleSettings& settings) = 0;
    /// Exports the sound as it plays now in the background: with its parameters, muted modes and
    /// own tuning. The files lie in a new folder in `parent`, named after the preset. If `parent`
    /// or that folder has samples of this sound, the export goes on with those that are missing.
    /// The status shows errors. The export goes on if the window closes.
    virtual void exportSamples(const SampleSettings& settings,
                               const std::filesystem::path& parent) = 0;
    virtual void stopExport() = 0;
    virtual SampleStatus sampleStatus() const = 0;
};

} // namespace idiophone
