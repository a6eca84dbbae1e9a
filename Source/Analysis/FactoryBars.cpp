#include "Analysis/FactoryBars.h"

#include "Analysis/FactoryTines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

/// Values at the lowest and the highest bar of a keyboard.
struct Span {
    double lowest, highest;
    double at(double share) const { return std::lerp(lowest, highest, share); }
};

double noteOf(double frequencyHz) {
    return 69 + 12 * std::log2(frequencyHz / 440);
}

struct BarMeasures {
    Span widthMetres, heightMetres;
    Span archHalfLengthShare = {0.3, 0.3};
    Span endHeightShare = {1, 1}; ///< as a share of the height
    double archExponent = 2;
};

UndercutBar start(const BarMeasures& measures, double share, double centreShare) {
    const double height = measures.heightMetres.at(share);
    return {.lengthMetres = 0,
            .widthMetres = measures.widthMetres.at(share),
            .heightMetres = height,
            .centreHeightMetres = centreShare * height,
            .endHeightMetres = measures.endHeightShare.at(share) * height,
            .archHalfLengthShare = measures.archHalfLengthShare.at(share),
            .archExponent = measures.archExponent};
}

/// Above the last note with a tuned second partial, the arch grows shallower towards the highest
/// bar.
double untunedCentreShare(double note, Span notes, Span centreShare) {
    return centreShare.at(
        std::clamp((note - notes.lowest) / (notes.highest - notes.lowest), 0.0, 1.0));
}

/// Quint tuning: the depth of the arch sets the twelfth. The arch's steep edges and the thin ends
/// bring the next two partials near 5.8 and 8.5, as on a recorded xylophone. The bars of the
/// highest octave are too short for quint tuning.
BarSpecification xylophoneBar(const char* material, double frequencyHz, double share) {
    constexpr double lastTuned = 96;
    const double note = noteOf(frequencyHz);
    const bool isTuned = note < lastTuned + 0.5;
    return {.source = "undercut bar after concert xylophones, tuned 1:3 up to C7",
            .shape = start(
                {.widthMetres = {0.038, 0.026},
                 .heightMetres = {0.019, 0.016},
                 .archHalfLengthShare = {0.20, 0.25},
                 .endHeightShare = {0.65, 0.95},
                 .archExponent = 4},
                share, isTuned ? 0.8 : untunedCentreShare(note, {lastTuned, 108}, {0.65, 0.85})),
            .targets = {.fundamentalHz = frequencyHz, .secondRatio = isTuned ? 3.0 : 0.0},
            .material = *findMaterial(material),
            .maxFrequencyHz = std::lerp(16000, 18500, share),
            // A fit to recorded decays: the fundamental loses most.
            .cords = CordSupport{.resistanceNsPerM = 10, .resistanceExponent = -0.5},
            .tube = Tube{.frequencyHz = frequencyHz,
                         .radiusMetres = std::lerp(0.015, 0.016, share),
                         .gapMetres = 0.010}};
}

BarSpecification rosewoodBar(double frequencyHz, double share) {
    return xylophoneBar("Rosewood", frequencyHz, share);
}

BarSpecification padaukBar(double frequencyHz, double share) {
    return xylophoneBar("Padauk", frequencyHz, share);
}

/// The bars have three tuned partials in the low octave, then two, and one at the top, as on real
/// marimbas.
BarSpecification marimbaBar(double frequencyHz, double share) {
    constexpr double lastTuned = 84, lastOfThreePartials = 56;
    const double note = noteOf(frequencyHz);
    const bool isTuned = note < lastTuned + 0.5;
    return {.source = "undercut bar after concert marimbas, tuned 1:4:10 up to G#3, 1:4 up to C6",
            .shape = start({.widthMetres = {0.064, 0.040},
                            .heightMetres = {0.022, 0.020},
                            .archHalfLengthShare = {0.36, 0.36},
                            .archExponent = 3.4}, // result of tuning the lowest bars to 1:4:10
                           share,
                           isTuned ? 0.3 : untunedCentreShare(note, {lastTuned, 96}, {0.21, 0.75})),
            .targets = {.fundamentalHz = frequencyHz,
                        .secondRatio = isTuned ? 4.0 : 0.0,
                        .thirdRatio = note < lastOfThreePartials + 0.5 ? 10.0 : 0.0},
            .material = *findMaterial("Rosewood"),
            .maxFrequencyHz = 14000,
            .tube = Tube{.frequencyHz = frequencyHz,
                         .radiusMetres = std::lerp(0.029, 0.012, share),
                         .gapMetres = std::lerp(0.010, 0.045, share)}};
}

/// Follows the first overtone of measured sets: two octaves up to F5, falling to a ratio of 3.5
/// above.
BarSpecification vibraphoneBar(double frequencyHz, double share) {
    const double note = noteOf(frequencyHz);
    return {.source = "undercut bar after concert vibraphones, tuned 1:4, to 1:3.5 at the top",
            .shape = start({.widthMetres = {0.057, 0.040},
                            .heightMetres = {0.0127, 0.0127},
                            .archHalfLengthShare = {0.34, 0.34}},
                           share, 0.4),
            .targets = {.fundamentalHz = frequencyHz,
                        .secondRatio = 4 - 0.5 * std::clamp((note - 77) / 12, 0.0, 1.0)},
            .material = *findMaterial("Aluminium"),
            .maxFrequencyHz = 18000,
            // The holes are at the nodes. The value is an estimate: no vibraphone was measured.
            .cords = CordSupport{.spreadOverLength = 0.02},
            .tube =
                Tube{.frequencyHz = frequencyHz, .radiusMetres = std::lerp(0.019, 0.013, share)}};
}

BarSpecification glockenspielBar(double frequencyHz, double share) {
    // 1 1/4 by 5/16 inches give the twisting and sideways partials of the recorded bars.
    return {.source = "steel bar after orchestra bells, uniform",
            .shape =
                start({.widthMetres = {0.032, 0.032}, .heightMetres = {0.008, 0.008}}, share, 1),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Mild steel"),
            .cords = CordSupport{}};
}

BarSpecification stoneBar(double frequencyHz, double share) {
    return {.source = "slab of slate after the Skiddaw lithophones, uniform",
            .shape =
                start({.widthMetres = {0.060, 0.045}, .heightMetres = {0.020, 0.020}}, share, 1),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Slate")};
}

/// Thin bars on strips of felt.
BarSpecification toyBar(double frequencyHz, double share) {
    return {.source = "steel bar after toy glockenspiels, uniform, on felt",
            .shape =
                start({.widthMetres = {0.020, 0.020}, .heightMetres = {0.0025, 0.0025}}, share, 1),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Mild steel"),
            .cords = CordSupport{.resistanceNsPerM = 0.6}};
}

/// A thick slab on pins and cushions, over a trough, which sounds as a tube under each slab.
BarSpecification saronBar(double frequencyHz, double share) {
    return {.source = "bronze slab after the saron, uniform, over its trough",
            .shape =
                start({.widthMetres = {0.060, 0.045}, .heightMetres = {0.012, 0.014}}, share, 1),
            .targets = {.fundamentalHz = frequencyHz},
            .material = *findMaterial("Bell bronze"),
            .maxFrequencyHz = 14000,
            .cords = CordSupport{.resistanceNsPerM = 8},
            .tube = Tube{.frequencyHz = frequencyHz, .radiusMetres = 0.02}};
}

/// A thin bar on cords over a tube of bamboo or tin.
BarSpecification genderBar(double frequencyHz, double share) {
    return {
        .source = "bronze bar after the gender, uniform, over a tube",
        .shape = start({.widthMetres = {0.055, 0.040}, .heightMetres = {0.003, 0.003}}, share, 1),
        .targets = {.fundamentalHz = frequencyHz},
        .material = *findMaterial("Bell bronze"),
        .maxFrequencyHz = 7000,
        .cords = CordSupport{.resistanceNsPerM = 1, .spreadOverLength = 0.02},
        .tube = Tube{.frequencyHz = frequencyHz, .radiusMetres = std::lerp(0.025, 0.018, share)}};
}

constexpr std::array<BarInstrument, 14> instruments{{{"xylophone", 65, 108, rosewoodBar},
                                                     {"padauk-xylophone", 65, 108, padaukBar},
                                                     {"marimba", 45, 96, marimbaBar},
                                                     {"vibraphone", 53, 89, vibraphoneBar},
                                                     {"glockenspiel", 79, 108, glockenspielBar},
                                                     {"stones", 72, 96, stoneBar},
                                                     {"toy-glockenspiel", 84, 100, toyBar},
                                                     {"saron", 72, 86, saronBar},
                                                     {"gender", 55, 67, genderBar},
                                                     {"kalimba", 60, 84, kalimbaTine},
                                                     {"music-box", 72, 96, musicBoxTooth},
                                                     {"steel-tongue", 60, 60, steelTongue},
                                                     {"wooden-tongue", 48, 48, woodenTongue},
                                                     {"jaw-harp", 45, 45, jawHarpReed}}};

} // namespace

std::string BarInstrument::barName(int midiNote) const {
    return std::string(name) + "-" + std::to_string(midiNote);
}

BarSpecification BarInstrument::barAt(int midiNote, double frequencyHz) const {
    const double share =
        static_cast<double>(midiNote - lowestNote) / std::max(1, highestNote - lowestNote);
    BarSpecification specification = bar(frequencyHz, std::clamp(share, 0.0, 1.0));
    specification.name = barName(midiNote);
    return specification;
}

std::span<const BarInstrument> barInstruments() {
    return instruments;
}

const BarInstrument* findBarInstrument(std::string_view name) {
    const auto found = std::ranges::find(instruments, name, &BarInstrument::name);
    return found == instruments.end() ? nullptr : &*found;
}

double noteFrequencyHz(double midiNote) {
    return 440 * std::exp2((midiNote - 69) / 12);
}

} // namespace idiophone
