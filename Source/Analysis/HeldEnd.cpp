#include "Analysis/HeldEnd.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double hairMetres = 1e-6; ///< around a plane of nodes

} // namespace

UndercutBar withBridge(UndercutBar bar, const HeldEnd& end) {
    if (end.backMetres > 0)
        bar.archHalfLengthShare = std::clamp(0.5 - end.backMetres / bar.lengthMetres, 0.1, 0.49);
    return bar;
}

Support supportOf(const HeldEnd& end, const UndercutBar& bar) {
    Support support{
        .clamps = {{{.axis = 0, .isBelow = false, .metres = bar.lengthMetres / 2 - hairMetres}}},
        .resistanceNsPerM = end.resistanceNsPerM,
        .boardKgPerM2 = end.boardKgPerM2};
    if (end.backMetres > 0) {
        const double bridge = bar.archHalfLengthShare * bar.lengthMetres;
        support.clamps.push_back(
            {{.axis = 0, .isBelow = false, .metres = bridge - hairMetres},
             {.axis = 0, .isBelow = true, .metres = bridge + hairMetres},
             {.axis = 2, .isBelow = true, .metres = hairMetres - bar.heightMetres}});
    }
    return support;
}

double estimatedLengthMetres(const HeldEnd& end,
                             const UndercutBar& bar,
                             const BeamMaterial& material,
                             double fundamentalHz) {
    constexpr double betaLength = 1.87510407;
    const double gyrationMetres = bar.heightMetres / std::sqrt(12.0);
    const double speed = std::sqrt(material.youngsModulusPa / material.densityKgPerM3);
    return end.backMetres +
           betaLength * std::sqrt(gyrationMetres * speed / (2 * std::numbers::pi * fundamentalHz));
}

} // namespace idiophone
