#include "Analysis/Clamp.h"

#include "Object/NumberText.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace idiophone {
namespace {

constexpr std::string_view axes = "xyz";

std::string withoutBlanks(std::string_view text) {
    std::string result;
    for (const char character : text)
        if (character != ' ' && character != '\t')
            result += character;
    return result;
}

/// Reads "x<0.02".
bool parseSide(std::string_view text, ClampSide& side) {
    if (text.size() < 3 || (text[1] != '<' && text[1] != '>'))
        return false;
    const auto axis = axes.find(text[0]);
    const auto metres = parseNumber(text.substr(2));
    side.metres = metres.value_or(0);
    side.axis = static_cast<int>(axis);
    side.isBelow = text[1] == '<';
    return axis != std::string_view::npos && metres && std::isfinite(*metres);
}

} // namespace

Result<void> validate(const Support& support) {
    if (!(support.resistanceNsPerM.value_or(1) > 0))
        return failure("The support's resistance must be a positive number of N s/m.");
    if (!(support.quality.value_or(1) > 0))
        return failure("The quality factor of the support must be a positive number.");
    if (!(support.boardKgPerM2.value_or(1) > 0))
        return failure("The board's mass must be a positive number of kg/m².");
    return {};
}

Result<ClampRegion> parseClamp(std::string_view text) {
    const std::string bare = withoutBlanks(text);
    ClampRegion region;
    for (std::size_t start = 0; start <= bare.size();) {
        const std::size_t comma = std::min(bare.find(',', start), bare.size());
        ClampSide side;
        if (!parseSide(std::string_view(bare).substr(start, comma - start), side))
            return failure("is no region such as x<0.02 or x>0.1,z<0, in metres");
        region.push_back(side);
        start = comma + 1;
    }
    return region;
}

bool isClamped(std::span<const ClampRegion> regions, const Eigen::Vector3d& pointMetres) {
    return std::ranges::any_of(regions, [&](const ClampRegion& region) {
        return std::ranges::all_of(
            region, [&](const ClampSide& side) { return side.contains(pointMetres); });
    });
}

} // namespace idiophone
