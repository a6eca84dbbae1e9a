// One line on standard error that says how far a long task is; nothing where that is no terminal.
#pragma once

#include <string>
#include <string_view>

namespace idiophone {

class ProgressLine {
public:
    explicit ProgressLine(std::string_view task);
    ~ProgressLine(); ///< takes the line away
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(double fraction, std::string_view step);

private:
    std::string task;
    std::string shown;
    bool onTerminal;
};

} // namespace idiophone
