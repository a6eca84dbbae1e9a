// Shows the progress of a long task on one line of standard error, if it is a terminal.
#pragma once

#include "Object/WorkControl.h"

#include <string>
#include <string_view>

namespace idiophone {

class ProgressLine {
public:
    explicit ProgressLine(std::string_view task);
    ~ProgressLine(); ///< clears the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(double fraction, std::string_view step);

    /// Shows the progress of an analysis, which an interrupt cancels. The result is valid while
    /// this object lives.
    WorkControl control();

private:
    std::string task;
    std::string shown;
    bool onTerminal;
};

} // namespace idiophone
