// The window's view of the tuning of the keys.
#pragma once

#include <filesystem>
#include <string>

namespace idiophone {

struct TuningStatus {
    enum class Source {
        equal,   ///< no source: twelve equal steps
        files,   ///< the user's files, for this instance
        session, ///< a master of the session (MTS-ESP)
        messages ///< MIDI tuning messages
    };

    Source source = Source::equal;
    std::string scale;       ///< description of the scale, may be empty
    std::string mappingFile; ///< name of the keyboard mapping's file, or empty

    bool operator==(const TuningStatus&) const = default;
};

/// For the message thread.
class TuningView {
public:
    virtual ~TuningView() = default;

    /// Whether the extension is .scl or .kbm, in upper or lower case.
    virtual bool isTuningFile(const std::filesystem::path& file) const = 0;
    /// The patterns of these files, separated by semicolons.
    virtual std::string tuningPatterns() const = 0;
    /// Loads a scale or a keyboard mapping for this instance, and keeps the other of the two. The
    /// project stores the file's text. After an error, which the status shows, the tuning is
    /// unchanged.
    virtual void openTuning(const std::filesystem::path& file) = 0;
    /// Removes the scale and the mapping, or else the tuning by MIDI messages. Then the keys follow
    /// the session's tuning, or equal temperament.
    virtual void forgetTuning() = 0;
    virtual TuningStatus tuningStatus() const = 0;
};

} // namespace idiophone
