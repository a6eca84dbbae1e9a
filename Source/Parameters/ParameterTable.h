// The one table of parameters with their units and ranges. Plugin, presets, console, docs and tests
// read it. Independent of the effect of a parameter on the sound.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// Order and numbers are internal. Hosts and files store the ids of the table.
enum class ParameterId : std::size_t {
#define PARAMETER(symbol, ...) symbol,
#include "Parameters/ParameterRows.def"
#undef PARAMETER
    count
};

inline constexpr std::size_t parameterCount = static_cast<std::size_t>(ParameterId::count);

/// `cubic` starts at 0 and grows with the cube of the normalised value, which gives small values
/// a large part of the range. Values below 5e-7 of the maximum are 0.
enum class ParameterScale { linear, logarithmic, steps, onOff, choice, cubic };

/// Returns the scale's word in lists for programs.
const char* scaleName(ParameterScale scale) noexcept;

/// The maximum effect of a mutation (Instrument/Mutation.h) on a parameter. Chosen, not derived: at
/// full strength, a damping or a hardness changes by a factor of three to six. A few mutations
/// reach another instrument; a single one does not.
struct MutationRange {
    double step = 0; ///< at full strength, in units of the normalised range; 0: never changes
    double lowest = 0, highest = 0; ///< musical bounds, in the parameter's unit
};

/// One row. Values are in `unit` and lie in [minimum, maximum]. `steps`, `onOff` and `choice` have
/// whole numbers only.
struct ParameterInfo {
    ParameterId parameter;
    const char* id = nullptr;        ///< stored in states, presets and host automation
    const char* name = nullptr;      ///< for people
    const char* shortName = nullptr; ///< used where `name` does not fit
    const char* group = nullptr;     ///< heading of its group in the window
    const char* unit = "";           ///< empty if the number has no unit
    ParameterScale scale = ParameterScale::linear;
    double minimum = 0;
    double maximum = 1;
    double defaultValue = 0;
    int decimals = 0;     ///< digits after the point; significant digits if logarithmic or cubic
    int versionAdded = 1; ///< JUCE's version hint; increases with each release that adds parameters
    bool glides = false;  ///< changes are audible: smoothed (Instrument/ParameterGlide.h)
    /// Belongs to the player's session and not to a sound. Presets, comparisons and undone loads do
    /// not change it.
    bool isSetup = false;
    bool isPhysical = false; ///< a figure of physics: see ValueDisplay
    MutationRange mutation = {};
    const char* description = nullptr; ///< one sentence: the effect on the sound
    const char* minimumName = nullptr; ///< name of the minimum, or nullptr
    const char* maximumName = nullptr; ///< name of the maximum, or nullptr

    /// Converts a value to 0 to 1 (clamped first) and back. NaN gives the default.
    double toNormalised(double value) const;
    double fromNormalised(double normalised) const;
    /// Returns the nearest valid value, or the default for NaN.
    double clamped(double value) const;
};

std::span<const ParameterInfo> parameterTable();
const ParameterInfo& parameterInfo(ParameterId parameter);
/// Returns the row of that id, or nullptr.
const ParameterInfo* findParameter(std::string_view id);

/// How figures of physics (ParameterInfo::isPhysical) are shown and typed. Other parameters always
/// have their units.
enum class ValueDisplay {
    units, ///< as numbers with units: for hosts, files and the console
    plain  ///< as the place in the range, 0 to 100 in whole numbers: for players
};

/// Returns "12.5 GPa", or "42" in the plain display; "Rosewood", "Greedy" or "On", in UTF-8.
std::string formatParameter(const ParameterInfo& info,
                            double value,
                            ValueDisplay display = ValueDisplay::units);

/// Parses typed text with or without a unit (Units.h), which may be another one of the same
/// quantity. A number without a unit follows the display. Returns nothing if it is not a value.
std::optional<double> parseParameter(const ParameterInfo& info,
                                     std::string_view text,
                                     ValueDisplay display = ValueDisplay::units);
/// Parses as above, but does not clamp a number to the range.
std::optional<double> parseUnclamped(const ParameterInfo& info,
                                     std::string_view text,
                                     ValueDisplay display = ValueDisplay::units);

/// Returns the names of a choice, or nothing for other parameters.
std::span<const std::string_view> choiceNames(ParameterId parameter);

/// A value for every parameter, in its unit. Plain data that crosses threads by copy.
class ParameterValues {
public:
    ParameterValues(); ///< the defaults

    double operator[](ParameterId parameter) const {
        return values[static_cast<std::size_t>(parameter)];
    }
    void set(ParameterId parameter, double value); ///< clamps to the range

    bool operator==(const ParameterValues&) const = default;

private:
    std::array<double, parameterCount> values;
};

/// Returns the values with the setup parameters (ParameterInfo::isSetup) of `setup`.
ParameterValues withSetupOf(const ParameterValues& setup, ParameterValues values);

/// Special choices of ParameterId::material; library materials follow.
enum MaterialChoice { ownMaterial = 0, customMaterial = 1, firstLibraryMaterial = 2 };

/// Choices of ParameterId::mallet: the custom mallet, then the rack.
enum MalletChoice { customMallet = 0, firstRackMallet = 1 };

/// Choices of ParameterId::motorSync: free speed, then one opening per note length.
enum MotorSyncChoice { freeMotor = 0, firstSyncedMotor = 1 };

/// Returns the beats of the note length of a ParameterId::motorSync choice, 0 for the free one.
double motorSyncBeats(int choice);

/// Choices of ParameterId::outputs: what decides on which output a key sounds.
enum OutputsChoice {
    mainOutput = 0,
    outputsByPart = 1,
    outputsByOctave = 2,
    outputsByKey = 3,
    outputChoices = 4
};

/// Choices of ParameterId::contact: the action of a held key.
enum ContactChoice {
    strikeContact = 0,
    scrapeContact = 1,
    rollContact = 2,
    bowContact = 3,
    rubContact = 4
};

} // namespace idiophone
