// What the soak's log tells of its processes' memory, hour by hour, and whether that grows.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone::test {

/// Of a day's hours the first ones are of many players, the others of one that lives on.
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
    double mebibytes = 0;  ///< resident when it was over
};

/// "hour 9: 46379 notes, 149.2 MiB, 1 of its process".
std::string logLine(const LoggedHour& hour, std::int64_t notes);

/// Lines that say nothing of the process go on with the one of the line before.
std::vector<LoggedHour> readHours(std::istream& log);

/// The sentence that tells of it where the last hour has far more than the log's first, or where
/// the memory of each process climbs with its hours by more than they differ anyhow: by the slope
/// that fits all of them best, with a level of its own for each process and for each life of one
/// player.
std::optional<std::string> growthOf(std::span<const LoggedHour> hours);

} // namespace idiophone::test
