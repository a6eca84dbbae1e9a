// The rows of the one table of parameters, and the names of its choices.
#include "Parameters/MaterialNames.h"
#include "Parameters/ParameterTable.h"

#include <algorithm>
#include <vector>

namespace idiophone {
namespace {

using enum ParameterId;
using enum ParameterScale;

// clang-format off
constexpr std::array<ParameterInfo, parameterCount> table{{
    {.parameter = tau, .id = "tau", .name = "Truncation threshold", .shortName = "Threshold",
     .unit = "steps", .scale = logarithmic, .minimum = 0.001, .maximum = 1000, .defaultValue = 0.1,
     .decimals = 3, .versionAdded = 1,
     .description = "Modes quieter than this many 16-bit steps are dropped"},
    {.parameter = qualitySlope, .id = "slope", .name = "Quality slope", .shortName = "Slope",
     .scale = linear, .maximum = 10, .defaultValue = 1, .decimals = 2, .versionAdded = 1,
     .description = "How steeply the mode budget favours the loudest objects",
     .maximumName = "Greedy"},
    {.parameter = modeBudget, .id = "budget", .name = "Mode budget", .shortName = "Budget",
     .unit = "modes", .scale = logarithmic, .minimum = 16, .maximum = 16384, .defaultValue = 4096,
     .decimals = 4, .versionAdded = 1,
     .description = "Modes mixed at a time by all objects together"},
    {.parameter = compression, .id = "compression", .name = "Mode compression",
     .shortName = "Compression", .unit = "×", .scale = linear, .maximum = 4, .defaultValue = 1,
     .decimals = 2, .versionAdded = 1,
     .description = "How far apart modes may lie to be merged, in units of what the ear discriminates"},
    {.parameter = material, .id = "material", .name = "Material", .shortName = "Material",
     .scale = choice, .maximum = 63, .defaultValue = ownMaterial, .versionAdded = 1,
     .description = "What the objects are made of; Custom takes the five figures below"},
    {.parameter = youngsModulus, .id = "young", .name = "Young's modulus",
     .shortName = "Young's mod.", .unit = "GPa", .scale = logarithmic, .minimum = 0.01,
     .maximum = 1000, .defaultValue = 12.5, .decimals = 4, .versionAdded = 1,
     .description = "Stiffness of the custom material: pitch rises with its square root"},
    {.parameter = density, .id = "density", .name = "Density", .shortName = "Density",
     .unit = "kg/m³", .scale = logarithmic, .minimum = 10, .maximum = 25000, .defaultValue = 850,
     .decimals = 4, .versionAdded = 1,
     .description = "Density of the custom material: pitch falls with its square root"},
    {.parameter = fluidDamping, .id = "gamma", .name = "Fluid damping", .shortName = "Fluid damp.",
     .unit = "1/s", .scale = logarithmic, .minimum = 0.01, .maximum = 1000, .defaultValue = 51.58,
     .decimals = 4, .versionAdded = 1,
     .description = "Damping of the custom material that is the same for all modes"},
    {.parameter = viscoelasticDamping, .id = "eta", .name = "Visco-elastic damping",
     .shortName = "Viscous damp.", .unit = "µs", .scale = logarithmic, .minimum = 0.0001,
     .maximum = 100, .defaultValue = 0.235, .decimals = 4, .versionAdded = 1,
     .description = "Damping of the custom material that grows with the square of frequency"},
    {.parameter = size, .id = "size", .name = "Size", .shortName = "Size", .unit = "×",
     .scale = logarithmic, .minimum = 0.1, .maximum = 10, .defaultValue = 1, .decimals = 3,
     .versionAdded = 1,
     .description = "Scales every object: twice the size sounds an octave lower"},
    {.parameter = strikeAlong, .id = "strike_along", .name = "Strike position along",
     .shortName = "Along", .unit = "%", .scale = linear, .minimum = -100, .maximum = 100,
     .decimals = 1, .versionAdded = 1,
     .description = "Moves the strike from its place on each key towards either end"},
    {.parameter = strikeAcross, .id = "strike_across", .name = "Strike position across",
     .shortName = "Across", .unit = "%", .scale = linear, .minimum = -100, .maximum = 100,
     .decimals = 1, .versionAdded = 1, .description = "Moves the strike towards either edge"},
    {.parameter = strikeSpread, .id = "spread", .name = "Strike spread", .shortName = "Spread",
     .unit = "%", .scale = linear, .maximum = 100, .defaultValue = 2, .decimals = 1,
     .versionAdded = 1, .description = "How far strikes stray from the position, as a player's do"},
    {.parameter = malletHardness, .id = "hardness", .name = "Mallet hardness",
     .shortName = "Hardness", .unit = "MPa", .scale = logarithmic, .minimum = 1, .maximum = 100000,
     .defaultValue = 1000, .decimals = 3, .versionAdded = 1,
     .description = "Modulus of the custom mallet's contact: 2 is wound yarn, 100 hard rubber, 1000 wood, 60000 brass"},
    {.parameter = malletMass, .id = "mallet_mass", .name = "Mallet mass", .shortName = "Mass",
     .unit = "g", .scale = logarithmic, .minimum = 1, .maximum = 500, .defaultValue = 20,
     .decimals = 3, .versionAdded = 1,
     .description = "Mass of the custom mallet: heavier ones strike louder, longer and darker"},
    {.parameter = malletSpeed, .id = "mallet_speed", .name = "Mallet speed", .shortName = "Speed",
     .unit = "m/s", .scale = logarithmic, .minimum = 0.1, .maximum = 10, .defaultValue = 3,
     .decimals = 3, .versionAdded = 1, .description = "Speed of the mallet at velocity 127"},
    {.parameter = velocityCurve, .id = "velocity_curve", .name = "Velocity curve",
     .shortName = "Velocity", .scale = logarithmic, .minimum = 0.25, .maximum = 4,
     .defaultValue = 1.5, .decimals = 3, .versionAdded = 1,
     .description = "Exponent from MIDI velocity to mallet speed"},
    {.parameter = letRing, .id = "let_ring", .name = "Let ring", .shortName = "Let ring",
     .scale = onOff, .maximum = 1, .defaultValue = 1, .versionAdded = 1,
     .description = "On: notes ring out; off: releasing a key damps it"},
    {.parameter = releaseTime, .id = "release", .name = "Release time", .shortName = "Release",
     .unit = "s", .scale = logarithmic, .minimum = 0.005, .maximum = 10, .defaultValue = 0.15,
     .decimals = 3, .versionAdded = 1, .description = "Time in which a damped key falls by 60 dB"},
    {.parameter = tune, .id = "tune", .name = "Tune", .shortName = "Tune", .unit = "cents",
     .scale = linear, .minimum = -1200, .maximum = 1200, .decimals = 1, .versionAdded = 1,
     .description = "Shifts every key"},
    {.parameter = bendRange, .id = "bend_range", .name = "Pitch bend range",
     .shortName = "Bend range", .unit = "semitones", .scale = steps, .maximum = 48,
     .defaultValue = 2, .versionAdded = 1, .description = "How far the pitch wheel bends"},
    {.parameter = level, .id = "level", .name = "Level", .shortName = "Level", .unit = "dB",
     .scale = linear, .minimum = -60, .maximum = 24, .decimals = 1, .versionAdded = 1,
     .description = "Output level"},
    {.parameter = bypass, .id = "bypass", .name = "Bypass", .shortName = "Bypass", .scale = onOff,
     .maximum = 1, .versionAdded = 1, .description = "Silences the instrument"},
    {.parameter = mallet, .id = "mallet", .name = "Mallet", .shortName = "Mallet", .scale = choice,
     .maximum = 31, .defaultValue = customMallet, .versionAdded = 2,
     .description = "What strikes; Custom takes mallet hardness, mass and radius"},
    {.parameter = malletRadius, .id = "mallet_radius", .name = "Mallet radius",
     .shortName = "Radius", .unit = "mm", .scale = logarithmic, .minimum = 1, .maximum = 100,
     .defaultValue = 12.5, .decimals = 3, .versionAdded = 2,
     .description = "Radius of the custom mallet's head: larger heads strike a little shorter and brighter"},
    {.parameter = chatter, .id = "chatter", .name = "Chatter", .shortName = "Chatter", .unit = "%",
     .scale = linear, .maximum = 100, .decimals = 1, .versionAdded = 2,
     .description = "How much of a hard blow comes as further collisions within 15 ms"},
    {.parameter = modalPulse, .id = "modal_pulse", .name = "Modal pulse",
     .shortName = "Modal pulse", .scale = onOff, .maximum = 1, .versionAdded = 2,
     .description = "On: a blow is four soft pulses, as long as the periods of the object's lowest modes"},
    {.parameter = radiation, .id = "radiation", .name = "Radiation", .shortName = "Radiation",
     .unit = "%", .scale = linear, .maximum = 100, .decimals = 1, .versionAdded = 2,
     .description = "From what is heard where an object is struck to what its whole surface radiates"},
    {.parameter = width, .id = "width", .name = "Stereo width", .shortName = "Width", .unit = "%",
     .scale = linear, .maximum = 200, .defaultValue = 100, .decimals = 1, .versionAdded = 2,
     .description = "How far apart the two listening directions are heard"},
    {.parameter = matchLoudness, .id = "match_loudness", .name = "Match loudness",
     .shortName = "Match loudn.", .scale = onOff, .maximum = 1, .versionAdded = 2,
     .description = "On: another material or mallet is as loud as the preset's own"},
    {.parameter = contact, .id = "contact", .name = "Contact", .shortName = "Contact",
     .scale = choice, .maximum = 7, .defaultValue = strikeContact, .versionAdded = 2,
     .description = "What a held key does: strike once, or scrape or roll while pressure presses it"},
    {.parameter = contactForce, .id = "force", .name = "Contact force", .shortName = "Force",
     .unit = "N", .scale = logarithmic, .minimum = 0.01, .maximum = 100, .defaultValue = 5,
     .decimals = 3, .versionAdded = 2,
     .description = "How hard full pressure presses a scrape or roll"},
    {.parameter = contactSpeed, .id = "speed", .name = "Contact speed", .shortName = "Speed",
     .unit = "m/s", .scale = logarithmic, .minimum = 0.01, .maximum = 10, .defaultValue = 1,
     .decimals = 3, .versionAdded = 2,
     .description = "How fast the full modulation wheel moves a scrape or roll"},
    {.parameter = roughness, .id = "roughness", .name = "Roughness", .shortName = "Roughness",
     .unit = "×", .scale = logarithmic, .minimum = 0.01, .maximum = 10, .defaultValue = 1,
     .decimals = 3, .versionAdded = 2,
     .description = "How rough the surface is that scrapes or rolls"},
    {.parameter = rollCoupling, .id = "roll_coupling", .name = "Roll coupling",
     .shortName = "Coupling", .unit = "%", .scale = linear, .maximum = 100, .decimals = 1,
     .versionAdded = 2,
     .description = "How much a roll drives the object's lowest modes; at 100 as hard as a scrape does"},
    {.parameter = lossFactor, .id = "loss_factor", .name = "Loss factor",
     .shortName = "Loss factor", .scale = cubic, .maximum = 0.5, .decimals = 3, .versionAdded = 3,
     .description = "Damping of the custom material that grows with frequency: 1/Q, the same for all modes"},
    {.parameter = motorSpeed, .id = "motor_speed", .name = "Motor speed", .shortName = "Speed",
     .unit = "turns/s", .scale = linear, .maximum = 12, .defaultValue = 3, .decimals = 1,
     .versionAdded = 3,
     .description = "How fast the discs above the resonators turn, which open twice a turn"},
    {.parameter = motorDepth, .id = "motor_depth", .name = "Motor depth", .shortName = "Depth",
     .unit = "%", .scale = linear, .maximum = 100, .decimals = 1, .versionAdded = 3,
     .description = "How far the discs close the resonators: the depth of the tremolo"},
    {.parameter = thickness, .id = "thickness", .name = "Thickness", .shortName = "Thickness",
     .unit = "%", .scale = logarithmic, .minimum = 25, .maximum = 400, .defaultValue = 100,
     .decimals = 3, .versionAdded = 3,
     .description = "Of shells, to the thickness they were analysed with; solids keep theirs"},
    {.parameter = concertPitch, .id = "a4", .name = "Concert pitch", .shortName = "A4",
     .unit = "Hz", .scale = linear, .minimum = 380, .maximum = 480, .defaultValue = 440,
     .decimals = 1, .versionAdded = 4,
     .description = "What the A above middle C is tuned to; everything else moves with it"},
    {.parameter = mpe, .id = "mpe", .name = "MPE", .shortName = "MPE", .scale = onOff, .maximum = 1,
     .versionAdded = 4,
     .description = "On: every note has a channel, a bend, a place and a pressure of its own"},
    {.parameter = mpeBendRange, .id = "mpe_bend_range", .name = "MPE bend range",
     .shortName = "MPE bend", .unit = "semitones", .scale = steps, .minimum = 1, .maximum = 96,
     .defaultValue = 48, .versionAdded = 4,
     .description = "How far the bend of a single note reaches"},
    {.parameter = motorSync, .id = "motor_sync", .name = "Motor sync", .shortName = "Sync",
     .scale = choice, .maximum = 15, .defaultValue = freeMotor, .versionAdded = 4,
     .description = "The note of the host's tempo in which the discs open once; Free turns at motor speed"},
    {.parameter = room, .id = "room", .name = "Room", .shortName = "Room", .unit = "%",
     .scale = linear, .maximum = 100, .decimals = 1, .versionAdded = 4,
     .description = "How much of a room is heard around the sound"},
    {.parameter = roomDecay, .id = "room_decay", .name = "Room decay", .shortName = "Decay",
     .unit = "s", .scale = logarithmic, .minimum = 0.4, .maximum = 10, .defaultValue = 0.8,
     .decimals = 3, .versionAdded = 4,
     .description = "In what time the room's sound fades by 60 dB: small rooms fade soon, halls late"},
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

} // namespace

std::span<const ParameterInfo> parameterTable() {
    return table;
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

} // namespace idiophone
