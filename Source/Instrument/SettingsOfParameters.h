// Converts parameters to settings of the synthesiser.
#pragma once

#include "Instrument/KeyMap.h"
#include "Object/Mallet.h"
#include "Object/Material.h"
#include "Parameters/ParameterTable.h"
#include "Synth/SynthesisSettings.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <optional>
#include <span>

namespace idiophone {

/// Figures of the custom material; all act live.
inline constexpr std::array materialFigures{
    ParameterId::youngsModulus, ParameterId::density, ParameterId::fluidDamping,
    ParameterId::viscoelasticDamping, ParameterId::lossFactor};

/// Figures of the custom mallet.
inline constexpr std::array malletFigures{ParameterId::malletHardness, ParameterId::malletMass,
                                          ParameterId::malletRadius, ParameterId::malletExponent};

/// A choice whose custom entry has figures.
struct FigureChoice {
    ParameterId choice;
    int custom; ///< index of the custom entry
    std::span<const ParameterId> figures;
};

inline constexpr std::array figureChoices{
    FigureChoice{ParameterId::material, customMaterial, materialFigures},
    FigureChoice{ParameterId::mallet, customMallet, malletFigures}};

/// Returns the choice that the parameter is a figure of, or nullptr.
const FigureChoice* choiceOfFigure(ParameterId parameter);

/// Returns the values with the custom figures replaced by those of the chosen material and mallet.
/// The custom entries with these figures sound the same. `own` is the objects' material, or
/// nullptr. Any thread.
ParameterValues effectiveFigures(ParameterValues values, const Material* own);

/// Returns the values with the choice set to custom and with the figures of `effectiveFigures`, so
/// that they sound as before. Any thread.
ParameterValues withCustom(ParameterValues values, const FigureChoice& choice, const Material* own);

/// Returns whether the thickness acts on any of the slots. Any thread.
bool hasLiveThickness(std::span<const SynthesiserSlot> slots);

/// Returns whether any of the slots has a pitch that `keep_pitch` can keep. Any thread.
bool hasPitch(std::span<const SynthesiserSlot> slots);

/// Returns the values with that material as the custom one; ParameterValues::set clamps the
/// figures. The values do not include its Poisson ratio and contact figures. Any thread.
ParameterValues withCustomMaterial(ParameterValues values, const Material& material);

/// Returns the values with the material and the mallet of a kit's part. Any thread.
ParameterValues withPart(ParameterValues values, const KitPart& part);

/// Returns the material that a part gives an object, or nothing if the part follows the parameters.
/// Any thread.
std::optional<LiveMaterial> materialOfPart(const KitPart& part, const ModalObject& object);

/// Returns the synthesiser's settings for the values. Any thread.
SynthesisSettings synthesisSettings(const ParameterValues& values);

/// Returns the decay rate [1/s] that falls by 60 dB in that time: ln(1000)/T60.
constexpr double decayPerSecond(double t60Seconds) {
    return 6.907755278982137 / t60Seconds;
}

/// Returns the motor's speed in turns per second: two openings a turn. If a note length is chosen
/// and the tempo is known (not 0), there is one opening in every note of that length. Any thread.
double motorTurnsPerSecond(const ParameterValues& values, double beatsPerMinute);

/// Returns the motor's turns at a song position if it follows the tempo, otherwise nothing. Any
/// thread.
std::optional<double> motorTurnsAt(const ParameterValues& values, double songBeats);

/// Returns the live material chosen from the library, or nullptr if none is. Any thread.
const Material* chosenLibraryMaterial(const ParameterValues& values);

/// Returns the material whose contact figures act: the library's if one is chosen, otherwise the
/// object's `own`. Any thread.
const Material& contactMaterial(const ParameterValues& values, const Material& own);

/// Returns the chosen mallet of the rack, or nullptr for the custom one. Any thread.
const Mallet* chosenMallet(const ParameterValues& values);

} // namespace idiophone
