#include "Analysis/PulseSpectrum.h"
#include "Console/AssignedEffect.h"
#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Console/OptionChecks.h"
#include "Console/ParameterAssignments.h"
#include "Console/SongRender.h"
#include "Geometry/LengthUnit.h"
#include "Gltf/ObjectFile.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/ObjectBox.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/SettingsOfParameters.h"
#include "Instrument/StrikePointMetres.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Sampling/ObjectPlaces.h"
#include "Synth/Listening.h"
#include "Synth/LiveConditions.h"
#include "Synth/PointShapes.h"
#include "World/ObjectSurface.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <ranges>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct StrikeOptions {
    std::string object;
    std::optional<std::int64_t> vertex;
    std::vector<double> pointMetres;
    int velocity = 100;
    std::string material;
    std::vector<std::string> assignments;
    RecordingFormat format;
    bool json = false;
};

constexpr int struckKey = 60;
constexpr std::size_t modesNamed = 5;

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Result<std::size_t> chooseRow(const ModalObject& object, const StrikeOptions& options) {
    if (!options.pointMetres.empty())
        return nearestShapeRow(
            object, {options.pointMetres[0], options.pointMetres[1], options.pointMetres[2]});
    if (!options.vertex)
        return spreadPlaces(object, 1).value().front(); // no node of a mode, so every mode sounds
    const auto found = std::ranges::lower_bound(object.shapeVertices, *options.vertex);
    if (found == object.shapeVertices.end() || *found != *options.vertex)
        return failure("--vertex " + std::to_string(*options.vertex) + ": " + options.object +
                       (*options.vertex < 0 ||
                                *options.vertex >= static_cast<std::int64_t>(object.vertexCount())
                            ? " has only " + std::to_string(object.vertexCount()) + " vertices"
                            : " has no mode shapes at that vertex"));
    return static_cast<std::size_t>(found - object.shapeVertices.begin());
}

/// Warns of a point off the surface: a typing error, or millimetres for metres.
void warnOfPointOff(const ModalObject& object, const StrikeOptions& options) {
    constexpr double largestShare = 0.05; // of the object's size
    const std::array<double, 3> point{options.pointMetres[0], options.pointMetres[1],
                                      options.pointMetres[2]};
    const auto half = ObjectBox(object).halfExtentMetres;
    const double sizeMetres = 2 * std::hypot(half[0], half[1], half[2]);
    const auto nearest = strikePointMetres(object, ObjectSurface(object).nearest(point));
    const double offMetres = distance(point, nearest);
    if (offMetres > largestShare * sizeMetres)
        std::cerr << "warning: --at: the point lies " << millimetresText(offMetres)
                  << " off the object, whose diagonal is " << millimetresText(sizeMetres)
                  << std::endl;
}

/// Returns the object in another material. Exact if the Poisson ratios are equal.
ModalObject withMaterial(ModalObject object, const Material& material) {
    const auto& before = object.material;
    const double densityRatio = material.densityKgPerM3 / before.densityKgPerM3;
    const double eigenvalueRatio = material.youngsModulusPa / before.youngsModulusPa / densityRatio;
    for (std::size_t mode = 0; mode < object.decaysPerSecond.size(); ++mode)
        object.decaysPerSecond[mode] =
            object.damping(mode).scale / 2 *
            material.damping.perSecond(eigenvalueRatio * object.eigenvalues[mode]);
    if (material.damping == DampingLaw{})
        object.decaysPerSecond.clear();
    for (double& decay : object.extraDecaysPerSecond)
        decay *= std::sqrt(eigenvalueRatio);
    for (auto* parts : {&object.eigenvalues, &object.bending})
        for (double& eigenvalue : *parts)
            eigenvalue *= eigenvalueRatio;
    for (float& component : object.shapes)
        component /= static_cast<float>(std::sqrt(densityRatio));
    object.mass.massKg *= densityRatio;
    for (double& component : object.mass.inertiaKgM2)
        component *= densityRatio;
    object.bandHz *= std::sqrt(eigenvalueRatio);
    object.material = material;
    return object;
}

struct StruckMode {
    double frequencyHz = 0;      ///< damped, as it sounds
    double relativeDecibels = 0; ///< initial amplitude relative to the loudest mode
};

/// Returns at most `count` modes below the Nyquist frequency, loudest first. A mode's initial
/// amplitude is its residue at the strike, times the spectrum of the raised-cosine pulse at its
/// frequency.
std::vector<StruckMode> loudestModes(const ModalObject& object,
                                     const Strike& strike,
                                     const ParameterValues& parameters,
                                     double sampleRateHz,
                                     std::size_t count) {
    const auto law = liveConditions(object.material, synthesisSettings(parameters)).law;
    // φ·J and φ·ℓ of each mode, for an impulse J heard along ℓ.
    std::vector<float> struck(object.modeCount()), heard(object.modeCount());
    projectShapes(pointShapes(object, strike.point), strike.impulseNewtonSeconds,
                  listeningDirection(strike.point), object.modeCount(), struck.data(),
                  heard.data());
    std::vector<StruckMode> modes;
    for (std::size_t i = 0; i < object.modeCount(); ++i) {
        const double frequencyHz =
            dampedFrequency(law.pole(object.eigenvalues[i], object.damping(i))) /
            (2 * std::numbers::pi);
        const double residue =
            std::abs(static_cast<double>(struck[i]) * static_cast<double>(heard[i]));
        const double amplitude = residue * pulseSpectrum(frequencyHz * strike.durationSeconds);
        if (frequencyHz > 0 && frequencyHz < sampleRateHz / 2 && amplitude > 0)
            modes.push_back(
                {.frequencyHz = frequencyHz, .relativeDecibels = 20 * std::log10(amplitude)});
    }
    std::ranges::stable_sort(modes, std::greater{}, &StruckMode::relativeDecibels);
    modes.resize(std::min(modes.size(), count));
    for (auto& mode : modes | std::views::reverse)
        mode.relativeDecibels -= modes.front().relativeDecibels;
    return modes;
}

/// Returns a key map of one key that strikes one vertex.
KeyMap keyMapFor(const std::string& name, const ModalObject& object, std::size_t row) {
    return {.kind = KeyMapKind::zones,
            .lowestNote = struckKey,
            .highestNote = struckKey,
            .object = name,
            .strikePath = {ObjectBox(object).relative(vertexOfRow(object, row))}};
}

void report(const ModalObject& object,
            std::size_t row,
            const std::vector<StruckMode>& modes,
            const Recording& recording,
            const StrikeOptions& options) {
    const auto vertex = vertexOfRow(object, row);
    if (options.json) {
        auto result = recording.statistics();
        result["object"] = object.name;
        result["vertex"] = object.shapeVertices[row];
        result["point_m"] = vertex;
        result["material"] = object.material.name;
        for (const auto& mode : modes)
            result["loudest_modes"].push_back(
                {{"frequency_hz", mode.frequencyHz}, {"relative_db", mode.relativeDecibels}});
        std::cout << jsonText(result);
        return;
    }
    std::cout << nameOf(options.format.file) << ": " << recording.summary() << '\n'
              << "struck '" << object.name << "' at vertex " << object.shapeVertices[row]
              << std::fixed << std::setprecision(4) << " (" << vertex[0] << ", " << vertex[1]
              << ", " << vertex[2] << " m)\n"
              << "loudest modes:" << std::setprecision(1);
    for (const auto& mode : modes)
        std::cout << "  " << mode.frequencyHz << " Hz (" << mode.relativeDecibels << " dB)";
    std::cout << std::endl;
}

Result<void> strikeObject(const StrikeOptions& options) {
    auto object = readObject(options.object);
    if (!object)
        return tl::unexpected(object.error());
    if (!options.material.empty()) {
        const auto material = findOrReadMaterial(options.material);
        if (!material)
            return tl::unexpected(material.error());
        object = validated(withMaterial(std::move(*object), *material));
        if (!object)
            return failure(options.object + ": as " + inQuotes(material->name) + ", " +
                           object.error().message);
    }
    const auto row = chooseRow(*object, options);
    if (!row)
        return tl::unexpected(row.error());
    if (!options.pointMetres.empty())
        warnOfPointOff(*object, options);
    ParameterValues values;
    const auto assigned = assignParameters(options.assignments, values);
    if (!assigned)
        return tl::unexpected(assigned.error());

    ObjectLibrary library;
    const auto known = library.add(options.object, std::move(*object));
    auto instrument = Instrument::build(keyMapFor(options.object, *known, *row), library);
    if (!instrument)
        return tl::unexpected(instrument.error());
    const auto effect =
        assignedEffect(values, *assigned, {.slots = (*instrument)->slots(), .isOnePoint = true});
    print(effect.warnings);
    values = effect.values;
    auto recording = Recording::start(options.format, values);
    if (!recording)
        return tl::unexpected(recording.error());
    const SongEvent noteOn{.seconds = 0,
                           .bytes = {0x90, struckKey, static_cast<std::uint8_t>(options.velocity)}};
    Player player(*instrument, options.format.sampleRateHz);
    const auto tally = renderSong(player, {&noteOn, 1}, values, **recording,
                                  nameOf(options.format.file.filename()));
    if (!tally)
        return tl::unexpected(tally.error());
    const auto& point = (*instrument)->key(struckKey).strip->points.front();
    const auto strike =
        malletStrike(point, options.velocity, {}, values, (*instrument)->slots().front());
    report(*known, *row,
           loudestModes(*known, strike, values, options.format.sampleRateHz, modesNamed),
           **recording, options);
    return {};
}

} // namespace

void addStrike(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<StrikeOptions>(
        program, chosen, "strike", "Renders one strike of a modal object to a sound file",
        strikeObject);
    command->add_option("OBJECT", options->object, "A .modal or glTF file")->required();
    auto* vertex =
        command->add_option("--vertex", options->vertex, "Number of the vertex to strike");
    command
        ->add_option("--at", options->pointMetres,
                     "Strikes the vertex nearest to this point, in metres")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3)
        ->check(numberBetween(-1e6, 1e6))
        ->excludes(vertex);
    command->add_option("--velocity", options->velocity, "MIDI velocity")
        ->check(numberBetween(1, 127))
        ->capture_default_str();
    command->add_option("--material", options->material, "Name of a material, or a JSON file");
    addRecordingOptions(*command, options->format);
    addParameterAssignments(*command, options->assignments);
    command->add_flag("--json", options->json, "Writes the report as JSON");
}

} // namespace idiophone
