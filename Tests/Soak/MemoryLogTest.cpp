#include "Soak/MemoryLog.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <sstream>

using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Returns hours that repeat seven measured hours of one process. The hours of a single player
/// have a level of their own. Memory rises by `leak` with each hour of a process.
std::vector<LoggedHour> measured(int count, double leak, int hoursOfProcess = 1000) {
    constexpr std::array mebibytes{142, 162, 137, 165, 165, 164, 149};
    std::vector<LoggedHour> hours;
    for (int hour = 1; hour <= count; ++hour) {
        const int own = (hour - 1) % hoursOfProcess + 1;
        const double life = hourOfDay(hour) >= shortLivedHours ? -20 : 0;
        hours.push_back({hour, own,
                         mebibytes[static_cast<std::size_t>(hour - 1) % mebibytes.size()] + life +
                             leak * (own - 1)});
    }
    return hours;
}

bool anyGrowth(const std::vector<LoggedHour>& hours) {
    for (std::size_t count = 1; count <= hours.size(); ++count)
        if (growthOf(std::span(hours).first(count)))
            return true;
    return false;
}

} // namespace

TEST_CASE("Memory that varies as in real hours counts as no growth, in one process or many") {
    CHECK_FALSE(anyGrowth(measured(7 * 24, 0)));
    CHECK_FALSE(anyGrowth(measured(7 * 24, 0, 4)));
    CHECK_FALSE(anyGrowth(measured(7 * 24, 0, 1)));
}

TEST_CASE("A leak of 2.6 MiB an hour is found after a day, also over processes of eight hours") {
    const auto day = growthOf(measured(24, 2.6));
    REQUIRE(day);
    CHECK_THAT(*day, ContainsSubstring("MiB an hour"));
    const auto days = growthOf(measured(3 * 24, 2.6, 8));
    REQUIRE(days);
    CHECK_THAT(*days, ContainsSubstring("MiB an hour"));
}

TEST_CASE("Growth of more than 64 MiB since the log's first hour is found, also across processes") {
    const std::vector<LoggedHour> hours{{1, 1, 142}, {2, 2, 150}, {3, 1, 205}, {4, 2, 207}};
    CHECK_FALSE(growthOf(std::span(hours).first(3)));
    const auto growth = growthOf(hours);
    REQUIRE(growth);
    CHECK_THAT(*growth, ContainsSubstring("207.0") && ContainsSubstring("142.0"));
}

TEST_CASE("The log reads back as written, also lines without an hour of process") {
    std::stringstream log;
    log << "hour 1: 48748 notes, 142 MiB\nhour 2: 47594 notes, 162 MiB\n"
        << logLine({3, 1, 137.24}, 54676) << '\n'
        << logLine({4, 2, 165}, 46807) << "\nsomething else\n";
    const auto hours = readHours(log);
    REQUIRE(hours.size() == 4);
    CHECK((hours[1].hour == 2 && hours[1].hourOfProcess == 2 && hours[1].mebibytes == 162));
    CHECK((hours[2].hour == 3 && hours[2].hourOfProcess == 1 && hours[2].mebibytes == 137.2));
    CHECK((hours[3].hour == 4 && hours[3].hourOfProcess == 2));
}
