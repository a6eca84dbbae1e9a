// The one table of parameters: what exists, in which unit and range. The plugin, presets, console,
// docs and tests all read it. Knows nothing of what a parameter does to the sound.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// Order and number are internal; what hosts and files store are the ids of the table.
enum class ParameterId : std::size_t {
#define PARAMETER(symbol, ...) symbol,
#include "Parameters/ParameterRows.def"
#undef PARAMETER
    count
};

inline constexpr std::size_t parameterCount = static_cast<std::size_t>(ParameterId::count);

/// `cubic`: from 0, with the cube of the place, which reaches far down; below 5e-7 of the maximum
/// there is only 0.
enum class ParameterScale { linear, logarithmic, steps, onOff, choice, cubic };

/// How far a mutation (Instrument/Mutation.h) may move a parameter. Chosen, not derived: at full
/// strength a damping or a hardness moves by a factor of three to six, so that a few mutations
/// reach another instrument and one does not.
struct MutationRange {
    double step = 0; ///< at full strength, in units of the normalised range; 0: it does not move
    double lowest = 0, highest = 0; ///< musical bounds, in the parameter's unit
};

/// One row. Values are in `unit` and lie in [minimum, maximum]; `steps`, `onOff` and `choice` take
/// whole numbers only.
struct ParameterInfo {
    ParameterId parameter;
    const char* id = nullptr;        ///< what states, presets and host automation store
    const char* name = nullptr;      ///< for people
    const char* shortName = nullptr; ///< where there is little room and its kind is beside it
    const char* group = nullptr;     ///< the heading of those that it stands with in the window
    const char* unit = "";           ///< empty where the number has none
    ParameterScale scale = ParameterScale::linear;
    double minimum = 0;
    double maximum = 1;
    double defaultValue = 0;
    int decimals = 0;     ///< shown behind the point; significant digits where logarithmic or cubic
    int versionAdded = 1; ///< JUCE's version hint; rises with each release that adds parameters
    bool glides = false;  ///< heard while it moves, and so smoothed (Instrument/ParameterGlide.h)
    /// Belongs to the player's place in a session and not to a sound: presets, comparisons and
    /// loads that are undone leave it as it is.
    bool isSetup = false;
    MutationRange mutation = {};
    const char* description = nullptr; ///< one sentence: what it does to the sound
    const char* maximumName = nullptr; ///< what the top of the range is called, or nullptr

    /// 0 to 1 for a value, which is clamped first; and back. NaN is the default's.
    double toNormalised(double value) const;
    double fromNormalised(double normalised) const;
    /// The nearest value the parameter can take; NaN becomes the default.
    double clamped(double value) const;
};

std::span<const ParameterInfo> parameterTable();
const ParameterInfo& parameterInfo(ParameterId parameter);
/// The row of that id, or nullptr.
const ParameterInfo* findParameter(std::string_view id);

/// "12.5 GPa", "Rosewood", "Greedy", "On"; in UTF-8, as units are.
std::string formatParameter(const ParameterInfo& info, double value);

/// What a person typed, with or without the unit ("kg/m3" and "us" will do); nothing where it is
/// not a value.
std::optional<double> parseParameter(const ParameterInfo& info, std::string_view text);

/// The names of a choice; empty for other parameters. A choice's range may be longer than its
/// names: hosts automate places from 0 to 1, which must not move when a name is added.
std::span<const std::string_view> choiceNames(ParameterId parameter);

/// A value for every parameter, in its unit: plain data that crosses threads by copy.
class ParameterValues {
public:
    ParameterValues(); ///< the defaults

    double operator[](ParameterId parameter) const {
        return values[static_cast<std::size_t>(parameter)];
    }
    void set(ParameterId parameter, double value); ///< clamped to the range

    bool operator==(const ParameterValues&) const = default;

private:
    std::array<double, parameterCount> values;
};

/// The values with the setup (ParameterInfo::isSetup) of others.
ParameterValues withSetupOf(const ParameterValues& setup, ParameterValues values);

/// Choices of ParameterId::material with a meaning of their own; library materials follow.
enum MaterialChoice { ownMaterial = 0, customMaterial = 1, firstLibraryMaterial = 2 };

/// Choices of ParameterId::mallet: the custom one, then those of the rack.
enum MalletChoice { customMallet = 0, firstRackMallet = 1 };

/// Choices of ParameterId::motorSync: at its own speed, or opening once in every note of a length.
enum MotorSyncChoice { freeMotor = 0, firstSyncedMotor = 1 };

/// How many beats the note lasts that a choice of ParameterId::motorSync names; 0 for none.
double motorSyncBeats(int choice);

/// Choices of ParameterId::contact: what a held key does.
enum ContactChoice { strikeContact = 0, scrapeContact = 1, rollContact = 2 };

} // namespace idiophone
