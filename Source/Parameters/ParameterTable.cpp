#include "Parameters/ParameterTable.h"

#include "Parameters/MaterialNames.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

using enum ParameterId;
using enum ParameterScale;

// clang-format off
constexpr std::array<ParameterInfo, parameterCount> table{{
    {tau, "tau", "Truncation threshold", "Threshold", "steps", logarithmic, 0.001, 1000, 0.1, 3, 1,
     "Modes quieter than this many 16-bit steps are dropped", nullptr},
    {qualitySlope, "slope", "Quality slope", "Slope", "", linear, 0, 10, 1, 2, 1,
     "How steeply the mode budget favours the loudest objects", "Greedy"},
    {modeBudget, "budget", "Mode budget", "Budget", "modes", logarithmic, 16, 16384, 4096, 4, 1,
     "Modes mixed at a time by all objects together", nullptr},
    {compression, "compression", "Mode compression", "Compression", "×", linear, 0, 4, 1, 2, 1,
     "How far apart modes may lie to be merged, in units of what the ear discriminates", nullptr},
    {material, "material", "Material", "Material", "", choice, 0, 63, ownMaterial, 0, 1,
     "What the objects are made of; Custom takes the five figures below", nullptr},
    {youngsModulus, "young", "Young's modulus", "Young's mod.", "GPa", logarithmic, 0.01, 1000, 12.5, 4, 1,
     "Stiffness of the custom material: pitch rises with its square root", nullptr},
    {density, "density", "Density", "Density", "kg/m³", logarithmic, 10, 25000, 850, 4, 1,
     "Density of the custom material: pitch falls with its square root", nullptr},
    {fluidDamping, "gamma", "Fluid damping", "Fluid damp.", "1/s", logarithmic, 0.01, 1000, 51.58, 4, 1,
     "Damping of the custom material that is the same for all modes", nullptr},
    {viscoelasticDamping, "eta", "Visco-elastic damping", "Viscous damp.", "µs", logarithmic, 0.0001, 100, 0.235, 4, 1,
     "Damping of the custom material that grows with the square of frequency", nullptr},
    {size, "size", "Size", "Size", "×", logarithmic, 0.1, 10, 1, 3, 1,
     "Scales every object: twice the size sounds an octave lower", nullptr},
    {strikeAlong, "strike_along", "Strike position along", "Along", "%", linear, -100, 100, 0, 1, 1,
     "Moves the strike from its place on each key towards either end", nullptr},
    {strikeAcross, "strike_across", "Strike position across", "Across", "%", linear, -100, 100, 0, 1, 1,
     "Moves the strike towards either edge", nullptr},
    {strikeSpread, "spread", "Strike spread", "Spread", "%", linear, 0, 100, 2, 1, 1,
     "How far strikes stray from the position, as a player's do", nullptr},
    {malletHardness, "hardness", "Mallet hardness", "Hardness", "MPa", logarithmic, 1, 100000, 1000, 3, 1,
     "Modulus of the custom mallet's contact: 2 is wound yarn, 100 hard rubber, 1000 wood, 60000 brass", nullptr},
    {malletMass, "mallet_mass", "Mallet mass", "Mass", "g", logarithmic, 1, 500, 20, 3, 1,
     "Mass of the custom mallet: heavier ones strike louder, longer and darker", nullptr},
    {malletSpeed, "mallet_speed", "Mallet speed", "Speed", "m/s", logarithmic, 0.1, 10, 3, 3, 1,
     "Speed of the mallet at velocity 127", nullptr},
    {velocityCurve, "velocity_curve", "Velocity curve", "Velocity", "", logarithmic, 0.25, 4, 1.5, 3, 1,
     "Exponent from MIDI velocity to mallet speed", nullptr},
    {letRing, "let_ring", "Let ring", "Let ring", "", onOff, 0, 1, 1, 0, 1,
     "On: notes ring out; off: releasing a key damps it", nullptr},
    {releaseTime, "release", "Release time", "Release", "s", logarithmic, 0.005, 10, 0.15, 3, 1,
     "Time in which a damped key falls by 60 dB", nullptr},
    {tune, "tune", "Tune", "Tune", "cents", linear, -1200, 1200, 0, 1, 1,
     "Shifts every key", nullptr},
    {bendRange, "bend_range", "Pitch bend range", "Bend range", "semitones", steps, 0, 48, 2, 0, 1,
     "How far the pitch wheel bends", nullptr},
    {level, "level", "Level", "Level", "dB", linear, -60, 24, 0, 1, 1,
     "Output level", nullptr},
    {bypass, "bypass", "Bypass", "Bypass", "", onOff, 0, 1, 0, 0, 1,
     "Silences the instrument", nullptr},
    {mallet, "mallet", "Mallet", "Mallet", "", choice, 0, 31, customMallet, 0, 2,
     "What strikes; Custom takes mallet hardness, mass and radius", nullptr},
    {malletRadius, "mallet_radius", "Mallet radius", "Radius", "mm", logarithmic, 1, 100, 12.5, 3, 2,
     "Radius of the custom mallet's head: larger heads strike a little shorter and brighter", nullptr},
    {chatter, "chatter", "Chatter", "Chatter", "%", linear, 0, 100, 0, 1, 2,
     "How much of a hard blow comes as further collisions within 15 ms", nullptr},
    {modalPulse, "modal_pulse", "Modal pulse", "Modal pulse", "", onOff, 0, 1, 0, 0, 2,
     "On: a blow is four soft pulses, as long as the periods of the object's lowest modes",
     nullptr},
    {radiation, "radiation", "Radiation", "Radiation", "%", linear, 0, 100, 0, 1, 2,
     "From what is heard where an object is struck to what its whole surface radiates", nullptr},
    {width, "width", "Stereo width", "Width", "%", linear, 0, 200, 100, 1, 2,
     "How far apart the two listening directions are heard", nullptr},
    {matchLoudness, "match_loudness", "Match loudness", "Match loudn.", "", onOff, 0, 1, 0, 0, 2,
     "On: another material or mallet is as loud as the preset's own", nullptr},
    {contact, "contact", "Contact", "Contact", "", choice, 0, 7, strikeContact, 0, 2,
     "What a held key does: strike once, or scrape or roll while pressure presses it", nullptr},
    {contactForce, "force", "Contact force", "Force", "N", logarithmic, 0.01, 100, 5, 3, 2,
     "How hard full pressure presses a scrape or roll", nullptr},
    {contactSpeed, "speed", "Contact speed", "Speed", "m/s", logarithmic, 0.01, 10, 1, 3, 2,
     "How fast the full modulation wheel moves a scrape or roll", nullptr},
    {roughness, "roughness", "Roughness", "Roughness", "×", logarithmic, 0.01, 10, 1, 3, 2,
     "How rough the surface is that scrapes or rolls", nullptr},
    {rollCoupling, "roll_coupling", "Roll coupling", "Coupling", "%", linear, 0, 100, 0, 1, 2,
     "How much a roll drives the object's lowest modes; at 100 as hard as a scrape does", nullptr},
    {lossFactor, "loss_factor", "Loss factor", "Loss factor", "", cubic, 0, 0.5, 0, 3, 3,
     "Damping of the custom material that grows with frequency: 1/Q, the same for all modes", nullptr},
    {motorSpeed, "motor_speed", "Motor speed", "Speed", "turns/s", linear, 0, 12, 3, 1, 3,
     "How fast the discs above the resonators turn, which open twice a turn", nullptr},
    {motorDepth, "motor_depth", "Motor depth", "Depth", "%", linear, 0, 100, 0, 1, 3,
     "How far the discs close the resonators: the depth of the tremolo", nullptr},
    {thickness, "thickness", "Thickness", "Thickness", "%", logarithmic, 25, 400, 100, 3, 3,
     "Of shells, to the thickness they were analysed with; solids keep theirs", nullptr},
    {concertPitch, "a4", "Concert pitch", "A4", "Hz", linear, 380, 480, 440, 1, 4,
     "What the A above middle C is tuned to; everything else moves with it", nullptr},
    {mpe, "mpe", "MPE", "MPE", "", onOff, 0, 1, 0, 0, 4,
     "On: every note has a channel, a bend, a place and a pressure of its own", nullptr},
    {mpeBendRange, "mpe_bend_range", "MPE bend range", "MPE bend", "semitones", steps, 1, 96, 48, 0, 4,
     "How far the bend of a single note reaches", nullptr},
    {motorSync, "motor_sync", "Motor sync", "Sync", "", choice, 0, 15, freeMotor, 0, 4,
     "The note of the host's tempo in which the discs open once; Free turns at motor speed", nullptr},
    {room, "room", "Room", "Room", "%", linear, 0, 100, 0, 1, 4,
     "How much of a room is heard around the sound", nullptr},
    {roomDecay, "room_decay", "Room decay", "Decay", "s", logarithmic, 0.4, 10, 0.8, 3, 4,
     "In what time the room's sound fades by 60 dB: small rooms fade soon, halls late", nullptr},
}};

// Appended to only, in the order of malletRack().
constexpr std::array<std::string_view, 8> malletNames{
    "Custom", "Yarn", "Soft rubber", "Medium rubber", "Hard rubber", "Wood", "Hard plastic", "Brass"};

constexpr std::array<std::string_view, 3> contactNames{"Strike", "Scrape", "Roll"};

// Appended to only.
constexpr std::array<std::string_view, 9> motorSyncNames{
    "Free", "1/1", "1/2", "1/2 T", "1/4", "1/4 T", "1/8", "1/8 T", "1/16"};
constexpr std::array<double, motorSyncNames.size()> motorSyncLengths{
    0, 4, 2, 4.0 / 3, 1, 2.0 / 3, 0.5, 1.0 / 3, 0.25};
// clang-format on

// Of the maximum; what is smaller is 0, as its digits would not end.
constexpr double smallestCubicShare = 5e-7;

constexpr bool tableIsInOrder() {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (table[i].parameter != static_cast<ParameterId>(i))
            return false;
    return true;
}
static_assert(tableIsInOrder());

std::vector<std::string_view> allMaterialNames() {
    std::vector<std::string_view> names{"Own", "Custom"};
    const auto library = libraryMaterialNames();
    names.insert(names.end(), library.begin(), library.end());
    return names;
}

std::string_view trimmed(std::string_view text) {
    const auto isSpace = [](unsigned char c) { return std::isspace(c) != 0; };
    while (!text.empty() && isSpace(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back()))
        text.remove_suffix(1);
    return text;
}

bool sameWord(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// Units as they are typed: µ has two code points and may be a u, ³ a 3, × an x.
std::string typedUnit(std::string_view unit) {
    std::string typed(unit);
    for (const auto& [shown, plain] :
         {std::pair<std::string_view, const char*>("µ", "u"), {"μ", "u"}, {"³", "3"}, {"×", "x"}})
        for (auto at = typed.find(shown); at != std::string::npos; at = typed.find(shown))
            typed.replace(at, shown.size(), plain);
    return typed;
}

std::string formatNumber(double value, int decimals) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream << std::fixed << std::setprecision(decimals) << value;
    return stream.str();
}

/// Decimals that show at least so many significant digits of the value as it is rounded.
int decimalsFor(double value, int significantDigits) {
    if (value == 0)
        return 0;
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - significantDigits + 1);
    const double rounded = std::round(value / unit) * unit;
    const int magnitude = static_cast<int>(std::floor(std::log10(rounded) + 1e-9));
    return std::max(0, significantDigits - 1 - magnitude);
}

bool bySignificantDigits(ParameterScale scale) {
    return scale == logarithmic || scale == cubic;
}

bool isWhole(ParameterScale scale) {
    return scale == steps || scale == onOff || scale == choice;
}

} // namespace

double ParameterInfo::toNormalised(double value) const {
    const double inside = clamped(value);
    if (scale == logarithmic)
        return std::log(inside / minimum) / std::log(maximum / minimum);
    if (scale == cubic)
        return std::cbrt(inside / maximum);
    return (inside - minimum) / (maximum - minimum);
}

double ParameterInfo::fromNormalised(double normalised) const {
    const double inside =
        std::isnan(normalised) ? toNormalised(defaultValue) : std::clamp(normalised, 0.0, 1.0);
    if (scale == logarithmic)
        return clamped(minimum * std::pow(maximum / minimum, inside));
    if (scale == cubic)
        return clamped(inside * inside * inside * maximum);
    return clamped(minimum + inside * (maximum - minimum));
}

double ParameterInfo::clamped(double value) const {
    if (std::isnan(value))
        return defaultValue;
    const double inside = std::clamp(value, minimum, maximum);
    if (scale == cubic && inside < smallestCubicShare * maximum)
        return 0;
    return isWhole(scale) ? std::round(inside) : inside;
}

std::span<const ParameterInfo> parameterTable() {
    return table;
}

const ParameterInfo& parameterInfo(ParameterId parameter) {
    return table[static_cast<std::size_t>(parameter)];
}

const ParameterInfo* findParameter(std::string_view id) {
    const auto found =
        std::ranges::find_if(table, [&](const ParameterInfo& info) { return id == info.id; });
    return found == table.end() ? nullptr : &*found;
}

std::span<const std::string_view> choiceNames(ParameterId parameter) {
    if (parameter == material) {
        static const auto materialNames = allMaterialNames();
        return materialNames;
    }
    if (parameter == mallet)
        return malletNames;
    if (parameter == contact)
        return contactNames;
    if (parameter == motorSync)
        return motorSyncNames;
    return {};
}

double motorSyncBeats(int choice) {
    const auto index = static_cast<std::size_t>(std::max(choice, 0));
    return index < motorSyncLengths.size() ? motorSyncLengths[index] : 0;
}

std::string formatParameter(const ParameterInfo& info, double value) {
    const double inside = info.clamped(value);
    if (info.scale == onOff)
        return inside != 0 ? "On" : "Off";
    if (info.scale == choice) {
        const auto names = choiceNames(info.parameter);
        const auto index = static_cast<std::size_t>(inside);
        return index < names.size() ? std::string(names[index]) : "(" + std::to_string(index) + ")";
    }
    if (info.maximumName != nullptr && inside == info.maximum)
        return info.maximumName;
    std::string text =
        formatNumber(inside, bySignificantDigits(info.scale) ? decimalsFor(inside, info.decimals)
                                                             : info.decimals);
    if (*info.unit != '\0')
        text += std::string(" ") + info.unit;
    return text;
}

std::optional<double> parseParameter(const ParameterInfo& info, std::string_view text) {
    text = trimmed(text);
    if (info.scale == onOff && (sameWord(text, "on") || sameWord(text, "off")))
        return sameWord(text, "on") ? 1.0 : 0.0;
    if (info.maximumName != nullptr && sameWord(text, info.maximumName))
        return info.maximum;
    const auto names = choiceNames(info.parameter);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (sameWord(text, names[i]))
            return static_cast<double>(i);
    if (text.starts_with('(') && text.ends_with(')'))
        text = text.substr(1, text.size() - 2);

    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic()); // a host may have set a locale with decimal commas
    double value = 0;
    stream >> value;
    if (!stream)
        return std::nullopt;
    std::string rest;
    std::getline(stream, rest);
    if (!trimmed(rest).empty() && !sameWord(typedUnit(trimmed(rest)), typedUnit(info.unit)))
        return std::nullopt;
    return info.clamped(value);
}

ParameterValues::ParameterValues() {
    for (const auto& info : table)
        values[static_cast<std::size_t>(info.parameter)] = info.defaultValue;
}

void ParameterValues::set(ParameterId parameter, double value) {
    values[static_cast<std::size_t>(parameter)] = parameterInfo(parameter).clamped(value);
}

ParameterValues withSetupOf(const ParameterValues& setup, ParameterValues values) {
    for (const auto parameter : setupParameters)
        values.set(parameter, setup[parameter]);
    return values;
}

} // namespace idiophone
