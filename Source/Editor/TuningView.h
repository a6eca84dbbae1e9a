// What the window needs of the tuning of the keys.
#pragma once

#include <filesystem>
#include <string>

namespace idiophone {

/// What the keys are tuned to, and who says so.
struct TuningStatus {
    enum class Source {
        equal,   ///< nobody: twelve equal steps
        files,   ///< the user's own, for this instance
        session, ///< a master of the session (MTS-ESP)
        messages ///< MIDI's
    };

    Source source = Source::equal;
    std::string scale;       ///< its description
    std::string mappingFile; ///< name of the keyboard mapping's file, or empty

    bool operator==(const TuningStatus&) const = default;
};

/// For the message thread.
class TuningView {
public:
    virtual ~TuningView() = default;

    /// Whether the extension is .scl or .kbm, in any case.
    virtual bool isTuningFile(const std::filesystem::path& file) const = 0;
    /// Of these files, separated by semicolons.
    virtual std::string tuningPatterns() const = 0;
    /// Tunes the keys of this instance by a scale or a keyboard mapping; the other of the two
    /// stays. The project keeps the file's text. What goes wrong is what the status says, and the
    /// tuning stays.
    virtual void openTuning(const std::filesystem::path& file) = 0;
    /// Forgets scale and mapping, or else what messages have tuned: keys are as the session tunes
    /// them, or equally tempered.
    virtual void forgetTuning() = 0;
    virtual TuningStatus tuningStatus() const = 0;
};

} // namespace idiophone
