#include "Analysis/FactoryBars.h"
#include "Console/Command.h"
#include "Console/Interrupt.h"
#include "Console/OutputCheck.h"
#include "Console/ProgressLine.h"
#include "Geometry/ParametricMesh.h"
#include "Object/ModalObjectFile.h"

#include <iomanip>
#include <iostream>
#include <sstream>

namespace idiophone {
namespace {

struct Options {
    std::filesystem::path folder;
    std::string only;
};

struct FactoryObject {
    ModalObject object;
    std::string remark;
};

using Maker = std::function<Result<FactoryObject>(const AnalysisControl&)>;

Result<FactoryObject> makeBar(int note, const AnalysisControl& control) {
    const auto specification = rosewoodXylophoneBar(note);
    auto bar = tuneBar(specification, control);
    if (!bar)
        return tl::unexpected(bar.error());
    std::ostringstream remark;
    remark << std::fixed << std::setprecision(1) << bar->lengthMetres * 1000 << " mm, "
           << std::setprecision(2) << bar->fundamentalHz << " Hz (" << std::showpos
           << std::setprecision(3) << cents(bar->fundamentalHz, specification.targetFrequencyHz)
           << " cent)";
    return FactoryObject{.object = std::move(bar->object), .remark = remark.str()};
}

/// Five triangles to a bending wave at 16 kHz; what lies above is dense and only has to be bright.
Result<FactoryObject> makePlate(const AnalysisControl& control) {
    constexpr double lengthMetres = 0.36, widthMetres = 0.30;
    const auto mesh = sheetMesh(lengthMetres, widthMetres, 1800);
    auto object =
        analyse(mesh,
                {.name = "plate",
                 .source = "rectangular sheet, 0.36 x 0.30 m",
                 .material = *findMaterial("Steel"),
                 .thicknessMetres = 0.003,
                 .maxFrequencyHz = 30000,
                 .shapeVertices = evenSheetVertices(mesh, lengthMetres, widthMetres, 300)},
                control);
    if (!object)
        return tl::unexpected(object.error());
    return FactoryObject{.object = std::move(*object), .remark = "0.36 x 0.30 m"};
}

/// A hoop, because there the two-layer shell is accurate; its lowest mode is near C4, so that keys
/// below keep their overtones within the band.
Result<FactoryObject> makeRing(const AnalysisControl& control) {
    constexpr int around = 176, rows = 6;
    const auto mesh = hoopMesh(0.1, 0.02, around, rows);
    std::vector<int> everyOther;
    for (int vertex = 0; vertex < around * (rows + 1); vertex += 2)
        everyOther.push_back(vertex);
    auto object = analyse(mesh,
                          {.name = "ring",
                           .source = "hoop of radius 0.1 m, height 20 mm",
                           .material = *findMaterial("Steel"),
                           .thicknessMetres = 0.004,
                           .maxFrequencyHz = 48000,
                           .shapeVertices = everyOther},
                          control);
    if (!object)
        return tl::unexpected(object.error());
    return FactoryObject{.object = std::move(*object), .remark = "radius 0.1 m"};
}

std::vector<std::pair<std::string, Maker>> makers() {
    std::vector<std::pair<std::string, Maker>> list;
    for (int note = lowestXylophoneNote; note <= highestXylophoneNote; ++note)
        list.emplace_back(
            "xylophone-" + std::to_string(note),
            [note](const AnalysisControl& control) { return makeBar(note, control); });
    list.emplace_back("plate", makePlate);
    list.emplace_back("ring", makeRing);
    return list;
}

Result<void>
makeOne(const std::string& name, const Maker& maker, const std::filesystem::path& folder) {
    const auto file = folder / (name + ".modal");
    if (auto writable = checkWritable(file); !writable)
        return writable;
    ProgressLine progress(name);
    auto made = maker(
        {.progress = [&](double fraction, std::string_view step) { progress.show(fraction, step); },
         .cancelled = &interruptRequested()});
    if (!made)
        return made.error().message == cancelledMessage
                   ? Result<void>(tl::unexpected(made.error()))
                   : Result<void>(failure(name + ": " + made.error().message));
    const double seconds = made->object.provenance.analysisSeconds;
    // The time is the machine's: without it, the same sources give the same file.
    made->object.provenance.analysisSeconds = 0;
    if (auto written = writeModalObject(made->object, file, ShapePrecision::half); !written)
        return written;
    std::error_code ignored;
    std::cout << std::fixed << std::setprecision(1) << name << ": " << made->remark << ", "
              << made->object.modeCount() << " modes, "
              << static_cast<double>(std::filesystem::file_size(file, ignored)) / 1000 << " kB, "
              << seconds << " s" << std::endl;
    return {};
}

Result<void> makeFactory(const Options& options) {
    std::error_code fault;
    std::filesystem::create_directories(options.folder, fault);
    if (!std::filesystem::is_directory(options.folder, fault))
        return failure(options.folder.string() + ": the directory cannot be made");
    bool found = false;
    for (const auto& [name, maker] : makers()) {
        if (!options.only.empty() && name != options.only)
            continue;
        found = true;
        if (auto done = makeOne(name, maker, options.folder); !done)
            return done;
    }
    if (!found)
        return failure("--only " + options.only +
                       ": the factory objects are xylophone-72 to xylophone-108, plate and ring");
    return {};
}

} // namespace

void addFactory(CLI::App& program, Action& chosen) {
    auto* command =
        program.add_subcommand("factory", "Makes the modal objects of the factory presets anew");
    auto options = std::make_shared<Options>();
    command->add_option("-o,--output", options->folder, "The directory to write them to")
        ->required();
    command->add_option("--only", options->only, "One of them, such as xylophone-72 or plate");
    command->final_callback(
        [options, &chosen] { chosen = [options] { return makeFactory(*options); }; });
}

} // namespace idiophone
