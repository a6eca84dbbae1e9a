#include "Soak/MemoryLog.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

namespace idiophone::test {
namespace {

constexpr double mostGrowthMebibytes = 64; // since the log's first hour
constexpr double mostMebibytesPerHour = 1;
// Presets and the allocator's reserves make hours differ by some ten mebibytes. So a slope counts
// only after eight hours, and only if it exceeds its own standard error by this factor.
constexpr int leastHours = 8, leastFreedom = 5;
constexpr double leastErrors = 3;

std::string rounded(double mebibytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", mebibytes);
    return text;
}

/// Sums over hours whose memory should be equal.
struct Level {
    double hours = 0, count = 0, mebibytes = 0;
};

struct Slope {
    double perHour = 0, error = 0;
};

std::optional<Slope> slopeOf(std::span<const LoggedHour> hours) {
    std::vector<std::pair<int, int>> keys;
    std::map<std::pair<int, int>, Level> levels;
    int process = 0;
    for (const auto& each : hours) {
        process += each.hourOfProcess == 1 ? 1 : 0;
        const bool isOneLife = hourOfDay(each.hour) >= shortLivedHours;
        keys.emplace_back(process, isOneLife ? 1 + dayOf(each.hour) : 0);
        auto& level = levels[keys.back()];
        level.hours += each.hour, level.mebibytes += each.mebibytes, ++level.count;
    }
    double xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < hours.size(); ++i) {
        const auto& level = levels[keys[i]];
        const double x = hours[i].hour - level.hours / level.count;
        const double y = hours[i].mebibytes - level.mebibytes / level.count;
        xx += x * x, xy += x * y, yy += y * y;
    }
    const int freedom = static_cast<int>(hours.size()) - static_cast<int>(levels.size()) - 1;
    if (freedom < leastFreedom || xx == 0)
        return {};
    return Slope{xy / xx, std::sqrt(std::max(0.0, yy - xy * xy / xx) / freedom / xx)};
}

} // namespace

std::string logLine(const LoggedHour& hour, std::int64_t notes) {
    return "hour " + std::to_string(hour.hour) + ": " + std::to_string(notes) + " notes, " +
           rounded(hour.mebibytes) + " MiB, " + std::to_string(hour.hourOfProcess) +
           " of its process";
}

std::vector<LoggedHour> readHours(std::istream& log) {
    std::vector<LoggedHour> hours;
    for (std::string line; std::getline(log, line);) {
        LoggedHour hour;
        long long notes = 0;
        const int read =
            std::sscanf(line.c_str(), "hour %d: %lld notes, %lf MiB, %d of its process", &hour.hour,
                        &notes, &hour.mebibytes, &hour.hourOfProcess);
        if (read < 3)
            continue;
        if (read == 3)
            hour.hourOfProcess = hours.empty() ? 1 : hours.back().hourOfProcess + 1;
        hours.push_back(hour);
    }
    return hours;
}

std::optional<std::string> growthOf(std::span<const LoggedHour> hours) {
    if (hours.empty())
        return {};
    const auto& first = hours.front();
    const auto& last = hours.back();
    if (last.mebibytes > first.mebibytes + mostGrowthMebibytes)
        return "The process has " + rounded(last.mebibytes) + " MiB after hour " +
               std::to_string(last.hour) + ", where hour " + std::to_string(first.hour) +
               " of the log had " + rounded(first.mebibytes) + ".";
    const auto slope = static_cast<int>(hours.size()) < leastHours ? std::nullopt : slopeOf(hours);
    if (slope && slope->perHour > mostMebibytesPerHour &&
        slope->perHour > leastErrors * slope->error)
        return "The processes grow by " + rounded(slope->perHour) + " MiB an hour, give or take " +
               rounded(slope->error) + ", over the " + std::to_string(hours.size()) +
               " hours of the log, which is to be begun anew once that is mended.";
    return {};
}

} // namespace idiophone::test
