#include "Analysis/FactoryBars.h"
#include "Console/Command.h"
#include "Console/MaterialChoice.h"
#include "Console/OptionChecks.h"
#include "Console/ProgressLine.h"
#include "Geometry/MeshWriter.h"
#include "Instrument/Instrument.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/PresetFile.h"
#include "Instrument/StartingLevel.h"
#include "Object/FileBytes.h"
#include "Object/ModalObjectFile.h"
#include "Object/TextFile.h"
#include "Sampling/LoudnessMeter.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <locale>
#include <optional>
#include <sstream>

namespace idiophone {
namespace {

struct TuneOptions {
    std::string instrument;
    std::filesystem::path folder;
    std::optional<int> lowestNote, highestNote;
    double a4Hz = 440;
    std::vector<double> scaleCents;
    std::string material;
    double widthMetres = 0, heightMetres = 0;
    std::vector<double> ratios;
    bool meshesOnly = false, replaces = false;
};

/// Returns the pitch of a note in equal temperament, or in a scale of twelve cents values from C to
/// B. A has the requested pitch.
double pitchHz(const TuneOptions& options, int note) {
    if (options.scaleCents.empty())
        return options.a4Hz * noteFrequencyHz(note) / 440;
    constexpr int a = 9, a4Octave = 5;
    const double cents = options.scaleCents[static_cast<std::size_t>(note % 12)] -
                         options.scaleCents[a] + 1200.0 * (note / 12 - a4Octave);
    return options.a4Hz * std::exp2(cents / 1200);
}

Result<void> check(const TuneOptions& options, const BarInstrument& instrument) {
    if (!options.scaleCents.empty() && options.scaleCents.size() != 12)
        return failure("--scale: it needs twelve figures in cents, from C to B");
    if (options.ratios.size() > 2)
        return failure("--ratios: it takes at most two, for the second and the third partial");
    if (options.lowestNote.value_or(instrument.lowestNote) >
        options.highestNote.value_or(instrument.highestNote))
        return failure("--to: it is lower than --from");
    return {};
}

Result<BarSpecification>
specification(const TuneOptions& options, const BarInstrument& instrument, int note) {
    auto bar = instrument.barAt(note, pitchHz(options, note));
    if (!options.material.empty()) {
        auto material = findOrReadMaterial(options.material);
        if (!material)
            return tl::unexpected(material.error());
        bar.material = std::move(*material);
    }
    if (options.widthMetres > 0)
        bar.shape.widthMetres = options.widthMetres;
    if (options.heightMetres > 0) {
        const double scale = options.heightMetres / bar.shape.heightMetres;
        bar.shape.heightMetres *= scale;
        bar.shape.centreHeightMetres *= scale;
        bar.shape.endHeightMetres *= scale;
    }
    if (!options.ratios.empty()) {
        bar.targets.secondRatio = options.ratios[0];
        bar.targets.thirdRatio = options.ratios.size() > 1 ? options.ratios[1] : 0;
    }
    return bar;
}

constexpr const char* tableHead =
    "note,frequency_hz,miss_cents,second_ratio,third_ratio,length_mm,width_mm,height_mm,"
    "centre_height_mm,end_height_mm,arch_length_mm,arch_exponent,left_cord_mm,right_cord_mm,"
    "tube_length_mm,tube_radius_mm";

std::string tableRow(const BarSpecification& asked, const TunedBar& bar, int note) {
    std::ostringstream row;
    row.imbue(std::locale::classic());
    const auto& shape = bar.shape;
    const auto& partials = bar.partialsHz;
    const auto cords = cordPlacesMetres(bar.object);
    const bool isArched = shape.centreHeightMetres < shape.heightMetres;
    row << note << std::fixed << std::setprecision(3) << ',' << partials[0] << ','
        << cents(partials[0], asked.targets.fundamentalHz);
    for (std::size_t k = 1; k < 3; ++k) {
        row << ',';
        if (k < partials.size())
            row << partials[k] / partials[0];
    }
    for (const double metres :
         {shape.lengthMetres, shape.widthMetres, shape.heightMetres, shape.centreHeightMetres,
          shape.endHeightMetres, isArched ? 2 * shape.archHalfLengthShare * shape.lengthMetres : 0})
        row << ',' << 1000 * metres;
    row << ',' << shape.archExponent;
    for (std::size_t k = 0; k < 2; ++k) {
        row << ',';
        if (cords.size() == 2)
            row << 1000 * (cords[k] + shape.lengthMetres / 2);
    }
    if (asked.tube)
        row << ',' << 1000 * tubeLengthMetres(*asked.tube) << ','
            << 1000 * asked.tube->radiusMetres;
    else
        row << ",,";
    return row.str();
}

Result<void> writeBar(const TunedBar& bar, const TuneOptions& options) {
    const auto file = [&](const char* ending) {
        return options.folder / pathNamed(bar.object.name + ending);
    };
    Mesh inMillimetres = bar.surface;
    inMillimetres.vertices *= 1000;
    if (auto written = writeMesh(inMillimetres, file(".obj")); !written)
        return written;
    if (options.meshesOnly)
        return {};
    return writeModalObject(bar.object, file(".modal"), ShapePrecision::half);
}

std::filesystem::path inFolder(const TuneOptions& options, const std::string& ending) {
    return options.folder / pathNamed(options.instrument + ending);
}

/// Fails if a file exists: the user did not name the files, so none is replaced.
Result<void> checkAbsent(const TuneOptions& options, int from, int to) {
    std::vector<std::string> endings{".csv"};
    for (int note = from; note <= to; ++note)
        endings.push_back("-" + std::to_string(note) + ".obj");
    if (!options.meshesOnly) {
        for (int note = from; note <= to; ++note)
            endings.push_back("-" + std::to_string(note) + ".modal");
        endings.emplace_back(".json");
    }
    std::error_code ignored;
    for (const auto& ending : endings)
        if (const auto file = inFolder(options, ending); std::filesystem::exists(file, ignored))
            return failure(nameOf(file) + ": it exists already; --replace replaces it");
    return {};
}

/// Writes a preset as loud as the factory's. It names objects relative to itself, so that the
/// folder can be moved.
Result<void>
writePreset(const TuneOptions& options, const BarInstrument& instrument, int from, int to) {
    Preset preset;
    preset.name = "Tuned " + std::string(instrument.name);
    preset.description = "Made by idiophone tune.";
    preset.keyMap = {.kind = KeyMapKind::bars,
                     .lowestNote = from,
                     .highestNote = to,
                     .object = std::string(instrument.name) + "-{note}.modal"};
    auto played = preset.keyMap;
    played.object = storedNameOf(std::filesystem::absolute(options.folder) / played.object);
    return Instrument::build(played, ObjectLibrary::shared())
        .and_then([&](const std::shared_ptr<const Instrument>& built) {
            preset.parameters.set(
                ParameterId::level,
                startingLevel({built, preset.surface, measuredRateHz}, preset.parameters));
            return writeTextFile(inFolder(options, ".json"), encodePreset(preset) + "\n");
        });
}

Result<void> tuneKeyboard(const TuneOptions& options) {
    const BarInstrument* instrument = findBarInstrument(options.instrument);
    if (auto fine = check(options, *instrument); !fine)
        return fine;
    if (auto made = makeDirectory(options.folder); !made)
        return made;
    const int from = options.lowestNote.value_or(instrument->lowestNote);
    const int to = options.highestNote.value_or(instrument->highestNote);
    if (auto fine = checkAbsent(options, from, to); !fine && !options.replaces)
        return fine;
    const auto tablePath = inFolder(options, ".csv");
    if (auto writable = checkWritable(tablePath); !writable)
        return writable;
    std::string table = tableHead + std::string("\n");
    for (int note = from; note <= to; ++note) {
        const auto asked = specification(options, *instrument, note);
        if (!asked)
            return tl::unexpected(asked.error());
        const auto bar = [&] {
            ProgressLine progress(asked->name);
            return tuneBar(*asked, progress.control());
        }();
        if (!bar)
            return tl::unexpected(bar.error());
        if (auto written = writeBar(*bar, options); !written)
            return written;
        table += tableRow(*asked, *bar, note) + "\n";
        if (auto written = writeTextFile(tablePath, table); !written)
            return written;
        std::cout << asked->name << ": " << std::fixed << std::setprecision(2) << bar->partialsHz[0]
                  << " Hz, " << std::setprecision(1) << 1000 * bar->shape.lengthMetres
                  << " mm long, " << 1000 * bar->shape.centreHeightMetres
                  << " mm thick in the middle" << std::endl;
    }
    return options.meshesOnly ? Result<void>() : writePreset(options, *instrument, from, to);
}

} // namespace

void addTune(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<TuneOptions>(
        program, chosen, "tune",
        "Makes the bars of a keyboard: objects to play, meshes to cut, a table of measures",
        tuneKeyboard);
    std::vector<std::string> names;
    for (const auto& instrument : barInstruments())
        names.emplace_back(instrument.name);
    command->add_option("INSTRUMENT", options->instrument, "The kind of bar")
        ->required()
        ->check(CLI::IsMember(names));
    command->add_option("-o,--output", options->folder, "The directory to write to")->required();
    command->add_option("--from", options->lowestNote, "The lowest MIDI note")
        ->check(CLI::Range(0, 127));
    command->add_option("--to", options->highestNote, "The highest MIDI note")
        ->check(CLI::Range(0, 127));
    command->add_option("--a4", options->a4Hz, "The pitch of A4, in Hz")
        ->check(numberBetween(200, 900))
        ->capture_default_str();
    command
        ->add_option("--scale", options->scaleCents,
                     "Twelve pitches in cents, from C to B (default: equal temperament)")
        ->delimiter(',');
    command->add_option("--material", options->material, "Name of a material, or a JSON file");
    command->add_option("--width", options->widthMetres, "Width of all bars, in metres")
        ->check(numberBetween(1e-3, 10));
    command->add_option("--height", options->heightMetres, "Height of all bars, in metres")
        ->check(numberBetween(1e-3, 1));
    command
        ->add_option(
            "--ratios", options->ratios,
            "Ratios of the second and third partial, for example 4,10; 0 leaves one untuned")
        ->delimiter(',')
        ->check(numberBetween(0, 100));
    command->add_flag("--meshes-only", options->meshesOnly, "Writes only meshes and the table");
    command->add_flag("--replace", options->replaces, "Replaces files that exist already");
}

} // namespace idiophone
