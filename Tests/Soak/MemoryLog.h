// Reads and writes the soak's log of memory per hour, and finds whether memory grows.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone::test {

/// The first hours of a day use many players, the others a single player.
constexpr int hoursPerDay = 24, shortLivedHours = 8; // 2^31 samples are 12.4 hours at 48 kHz
constexpr int hourOfDay(int hour) {
    return (hour - 1) % hoursPerDay;
}
constexpr int dayOf(int hour) {
    return (hour - 1) / hoursPerDay;
}

struct LoggedHour {
    int hour = 0;          ///< from 1, over all processes
    int hourOfProcess = 0; ///< from 1
    double mebibytes = 0;  ///< resident at its end
};

/// "hour 9: 46379 notes, 149.2 MiB, 1 of its process".
std::string logLine(const LoggedHour& hour, std::int64_t notes);

/// Reads the hours of a log. A line without an hour of process continues the process of the line
/// before.
std::vector<LoggedHour> readHours(std::istream& log);

/// Returns a sentence if memory grows: if the last hour has far more than the log's first, or if
/// memory rises with the hours of each process. The second test fits one slope to all hours, with a
/// separate level for each process and for each player of several hours. It compares the slope with
/// its standard error.
std::optional<std::string> growthOf(std::span<const LoggedHour> hours);

} // namespace idiophone::test
