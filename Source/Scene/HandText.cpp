#include "Scene/HandText.h"

#include "Object/OneLine.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr std::size_t maximumRows = 100'000;
constexpr double strongestNewtons = 1000;
constexpr double slowestTapMetresPerSecond = 1e-4, fastestTapMetresPerSecond = 100;

struct Row {
    double seconds = 0;
    Eigen::Vector3d pointMetres;
    double figure = 0;
};

/// Parses rows of seconds, x, y, z and one more figure, ascending in time.
std::vector<Row>
parseRows(const JsonPlace& place, const std::string& what, double lowest, double highest) {
    std::vector<Row> rows;
    for (const auto& row : place.list(maximumRows)) {
        const auto figures = row.list(5);
        if (figures.size() != 5)
            row.fail("is not a list of five numbers: s, x, y, z and " + what);
        Row next{.seconds = figures[0].number(0, longestSeconds),
                 .pointMetres = {},
                 .figure = figures[4].number(lowest, highest)};
        for (int axis = 0; axis < 3; ++axis)
            next.pointMetres(axis) =
                figures[static_cast<std::size_t>(axis) + 1].number(-maximumMetres, maximumMetres);
        if (!rows.empty() && !(next.seconds > rows.back().seconds))
            row.fail("is not later than the one before it");
        rows.push_back(next);
    }
    return rows;
}

} // namespace

std::size_t parseKindName(const JsonPlace& place, const std::vector<BodyTemplate>& kinds) {
    const auto name = place.text();
    const auto found = std::ranges::find(kinds, name, &BodyTemplate::name);
    if (found == kinds.end())
        place.fail("is " + inQuotes(name) + ", which is none of the kinds");
    return static_cast<std::size_t>(found - kinds.begin());
}

Hand parseHand(const JsonPlace& place, const std::vector<BodyTemplate>& kinds) {
    place.allow({"kind", "tool", "path", "taps"});
    Hand hand;
    hand.kind = parseKindName(place.at("kind"), kinds);
    if (kinds[hand.kind].given != nullptr)
        place.at("kind").fail("is a ball, which is not heard");
    hand.tool = parseKindName(place.at("tool"), kinds);
    if (kinds[hand.tool].isFixed)
        place.at("tool").fail("is fixed and cannot be held");
    if (place.has("path"))
        for (const auto& row : parseRows(place.at("path"), "N", 0, strongestNewtons))
            hand.path.push_back({row.seconds, row.pointMetres, row.figure});
    if (place.has("taps"))
        for (const auto& row : parseRows(place.at("taps"), "m/s", slowestTapMetresPerSecond,
                                         fastestTapMetresPerSecond))
            hand.taps.push_back({row.seconds, row.pointMetres, row.figure});
    return hand;
}

} // namespace idiophone
