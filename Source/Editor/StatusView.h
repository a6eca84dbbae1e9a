// The status line's view of the processor.
#pragma once

#include <cstdint>
#include <string>

namespace idiophone {

/// For the message thread.
class StatusView {
public:
    struct Status {
        std::string sentence; ///< the loaded sound, or the last error
        bool isError = false;
        std::int64_t modesMixed = 0; ///< in the last rendered cell
        double delaySeconds = 0;     ///< on a stage: from a key to its sound; otherwise 0
        std::int64_t lateEvents = 0; ///< on a stage: impacts known too late to sound in time
        float peak = 0;              ///< output peak since the last call; full scale is 1
    };

    virtual ~StatusView() = default;

    virtual Status takeStatus() = 0;
    /// Reports an error of the window in one sentence; the status shows it.
    virtual void reportError(const std::string& sentence) = 0;
};

} // namespace idiophone
