// Plays music at random, faster than real time, in one processor, hour by hour of it; after each
// hour everything must fall silent, a reference phrase must sound as loud as at first and the
// process must not have grown. Begins no hour after so many seconds; goes on behind the last hour
// that the log tells of.
//   soak_music LOG SECONDS
#include "Soak/RandomSession.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <juce_events/juce_events.h>
#include <stdexcept>
#include <string>
#include <unistd.h>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double hourSeconds = 3600;
constexpr double farthestDb = 0.001;
constexpr double mostGrowthMebibytes = 64; // since the first hour, which fills all caches

int hoursLogged(const std::string& log) {
    int hours = 0;
    std::ifstream file(log);
    for (std::string line; std::getline(file, line);)
        hours += line.starts_with("hour ") ? 1 : 0;
    return hours;
}

double residentMebibytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0;
    file >> pages >> pages;
    return file ? pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20) : 0;
}

void checkLevel(double level, double first) {
    if (const double db = 20 * std::log10(level / first); !(std::abs(db) < farthestDb))
        throw std::runtime_error("The reference phrase has moved by " + std::to_string(db) +
                                 " dB.");
}

void soak(const std::string& log, double seconds) {
    const auto start = std::chrono::steady_clock::now();
    const auto isOver = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() >
               seconds;
    };
    Processor processor;
    RandomSession session(processor);
    const double first = session.referenceLevel();
    double afterFirstHour = 0;
    for (int hour = hoursLogged(log) + 1; !isOver(); ++hour) {
        const auto notes = session.notesPlayed();
        session.play(hourSeconds, static_cast<std::uint64_t>(hour));
        session.settle();
        checkLevel(session.referenceLevel(), first);
        session.settle();
        const double resident = residentMebibytes();
        if (afterFirstHour == 0)
            afterFirstHour = resident;
        if (resident > afterFirstHour + mostGrowthMebibytes)
            throw std::runtime_error("The process has grown from " +
                                     std::to_string(afterFirstHour) + " to " +
                                     std::to_string(resident) + " MiB.");
        std::ofstream(log, std::ios::app)
            << "hour " << hour << ": " << session.notesPlayed() - notes << " notes, "
            << std::lround(resident) << " MiB" << std::endl;
    }
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "soak_music LOG SECONDS" << std::endl;
        return 2;
    }
    const juce::ScopedJuceInitialiser_GUI juce;
    try {
        soak(arguments[1], std::atof(arguments[2]));
    } catch (const std::exception& fault) {
        std::cerr << fault.what() << std::endl;
        return 1;
    }
    return 0;
}
