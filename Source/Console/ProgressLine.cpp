#include "Console/ProgressLine.h"

#include "Console/Interrupt.h"
#include "Object/OneLine.h"

#include <cmath>
#include <iostream>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace idiophone {
namespace {

bool standardErrorIsTerminal() {
#ifdef _WIN32
    return _isatty(2) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

} // namespace

ProgressLine::ProgressLine(std::string_view what)
    : task(oneLine(what)), onTerminal(standardErrorIsTerminal()) {}

ProgressLine::~ProgressLine() {
    if (!shown.empty())
        std::clog << '\r' << std::string(shown.size(), ' ') << '\r' << std::flush;
}

void ProgressLine::show(double fraction, std::string_view step) {
    if (!onTerminal)
        return;
    std::string line = task + ": " + std::to_string(std::lround(100 * fraction)) + " %";
    if (!step.empty())
        line += ", " + std::string(step);
    if (line == shown)
        return;
    const auto width = shown.size();
    shown = line;
    if (line.size() < width)
        line.append(width - line.size(), ' ');
    std::clog << '\r' << line << std::flush; // std::cerr would escape the '\r' (TerminalText)
}

WorkControl ProgressLine::control() {
    return {.progress = [this](double fraction, std::string_view step) { show(fraction, step); },
            .cancelled = &interruptRequested()};
}

} // namespace idiophone
