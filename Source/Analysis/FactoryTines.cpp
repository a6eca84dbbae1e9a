#include "Analysis/FactoryTines.h"

#include <cmath>

namespace idiophone {
namespace {

UndercutBar uniformBar(double widthMetres, double heightMetres) {
    return {.lengthMetres = 0,
            .widthMetres = widthMetres,
            .heightMetres = heightMetres,
            .centreHeightMetres = heightMetres,
            .endHeightMetres = heightMetres};
}

} // namespace

BarSpecification kalimbaTine(double frequencyHz, double share) {
    return {.source = "steel tine after kalimbas of 17 keys, over a bridge, on a wooden box",
            .shape = uniformBar(0.0045, 0.0011),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Mild steel"),
            // The short tines stand at the sides of the box, where its lid is stiffer.
            .held = HeldEnd{.backMetres = std::lerp(0.013, 0.008, share),
                            .resistanceNsPerM = std::lerp(500, 1000, share),
                            .boardKgPerM2 = 4}};
}

BarSpecification musicBoxTooth(double frequencyHz, double share) {
    return {.source = "steel tooth after combs of 30 notes, uniform, on a wooden box",
            .shape = uniformBar(0.0012, std::lerp(0.0003, 0.0005, share)),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Mild steel"),
            .held = HeldEnd{.resistanceNsPerM = 200, .boardKgPerM2 = 2}};
}

BarSpecification steelTongue(double frequencyHz, double) {
    return {.source = "steel tongue, 35 x 2.3 mm, after tongue drums of sheet steel",
            .shape = uniformBar(0.035, 0.0023),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Mild steel"),
            .maxFrequencyHz = 14000,
            .held = HeldEnd{.resistanceNsPerM = 20000, .boardKgPerM2 = 18}};
}

BarSpecification woodenTongue(double frequencyHz, double) {
    return {.source = "padauk tongue, 60 x 12 mm, after slit drums of boards",
            .shape = uniformBar(0.060, 0.012),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Padauk"),
            .maxFrequencyHz = 6000,
            .held = HeldEnd{.resistanceNsPerM = 6000, .boardKgPerM2 = 11}};
}

BarSpecification jawHarpReed(double frequencyHz, double) {
    return {.source = "steel reed, 3 x 0.6 mm, after jaw harps, without frame and mouth",
            .shape = uniformBar(0.003, 0.0006),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Mild steel"),
            .maxFrequencyHz = 14000,
            .held = HeldEnd{.resistanceNsPerM = 50, .boardKgPerM2 = 4}};
}

} // namespace idiophone
