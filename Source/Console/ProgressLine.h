// Shows the progress of a long task on one line of standard error. Shows nothing if that is no
// terminal.
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

    /// Shows the progress of an analysis, which an interrupt cancels. Valid as long as this line.
    WorkControl control();

private:
    std::string task;
    std::string shown;
    bool onTerminal;
};

} // namespace idiophone
