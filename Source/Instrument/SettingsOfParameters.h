// What the parameters ask of the synthesiser.
#pragma once

#include "Object/Mallet.h"
#include "Object/Material.h"
#include "Parameters/ParameterTable.h"
#include "Synth/SynthesisSettings.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <optional>
#include <span>

namespace idiophone {

/// What the custom material has, all live.
inline constexpr std::array materialFigures{
    ParameterId::youngsModulus, ParameterId::density, ParameterId::fluidDamping,
    ParameterId::viscoelasticDamping, ParameterId::lossFactor};

/// What the custom mallet has.
inline constexpr std::array malletFigures{ParameterId::malletHardness, ParameterId::malletMass,
                                          ParameterId::malletRadius, ParameterId::malletExponent};

/// A choice of whose custom entry there are figures.
struct FigureChoice {
    ParameterId choice;
    int custom; ///< that entry
    std::span<const ParameterId> figures;
};

inline constexpr std::array figureChoices{
    FigureChoice{ParameterId::material, customMaterial, materialFigures},
    FigureChoice{ParameterId::mallet, customMallet, malletFigures}};

/// The choice that the parameter is a figure of, or nullptr.
const FigureChoice* choiceOfFigure(ParameterId parameter);

/// The values with the figures of the material and the mallet that are chosen in the place of the
/// custom ones', so that the custom ones with these sound alike; `own` is what the objects are made
/// of, or nullptr. Any thread.
ParameterValues effectiveFigures(ParameterValues values, const Material* own);

/// The values with the choice custom, which sound as before: with the figures of what was chosen,
/// as `effectiveFigures` has them. Any thread.
ParameterValues withCustom(ParameterValues values, const FigureChoice& choice, const Material* own);

/// Whether the thickness acts on one of these. Any thread.
bool hasLiveThickness(std::span<const SynthesiserSlot> slots);

/// Whether one of these has a pitch that `keep_pitch` can keep. Any thread.
bool hasPitch(std::span<const SynthesiserSlot> slots);

/// The values with that material as the custom one, its figures held to the parameters' ranges. Its
/// Poisson ratio and contact figures are not among them. Any thread.
ParameterValues withCustomMaterial(ParameterValues values, const Material& material);

/// The values with that mallet as the custom one, whose contact has that modulus whatever it meets.
/// Any thread.
ParameterValues withCustomMallet(ParameterValues values, const Mallet& played, double contactPa);

/// The settings that the values stand for. Any thread.
SynthesisSettings synthesisSettings(const ParameterValues& values);

/// How fast the motor turns: two openings a turn, one in every note of the chosen length, where a
/// length is chosen and the tempo is known, which 0 is not. Any thread.
double motorTurnsPerSecond(const ParameterValues& values, double beatsPerMinute);

/// How often it has turned at a place of the song where it follows the tempo; nothing where it does
/// not. Any thread.
std::optional<double> motorTurnsAt(const ParameterValues& values, double songBeats);

/// The library's material where one is chosen to be live, else nullptr. Any thread.
const Material* chosenLibraryMaterial(const ParameterValues& values);

/// The mallet of the rack that is chosen, or nullptr where the custom one is. Any thread.
const Mallet* chosenMallet(const ParameterValues& values);

} // namespace idiophone
