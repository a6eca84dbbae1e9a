#include "Analysis/FactoryObjects.h"
#include "Console/Command.h"
#include "Console/OptionChecks.h"
#include "Console/ProgressLine.h"
#include "Object/FileBytes.h"
#include "Object/ModalObjectFile.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>

namespace idiophone {
namespace {

struct FactoryOptions {
    std::filesystem::path folder;
    std::string only;
    bool replaces = false;
};

void report(const ModalObject& object, const std::filesystem::path& file, double seconds) {
    std::error_code ignored;
    const double lowestHz = std::sqrt(object.eigenvalues.front()) / (2 * std::numbers::pi);
    std::cout << std::fixed << std::setprecision(2) << object.name << ": lowest mode " << lowestHz
              << " Hz, " << object.modeCount() << " modes, " << std::setprecision(1)
              << static_cast<double>(std::filesystem::file_size(file, ignored)) / 1000 << " kB, "
              << seconds << " s" << std::endl;
}

Result<void> makeOne(const std::string& name, const FactoryOptions& options) {
    const auto file = options.folder / pathNamed(name + ".modal");
    std::error_code ignored;
    if (!options.replaces &&
        std::filesystem::exists(file, ignored)) // the user did not name the file
        return failure(nameOf(file) + ": it exists already; --replace replaces it");
    if (auto writable = checkWritable(file); !writable)
        return writable;
    auto made = [&] {
        ProgressLine progress(name);
        return makeFactoryObject(name, progress.control());
    }();
    if (!made)
        return tl::unexpected(made.error());
    // The time depends on the machine. Without it, the same sources give the same file.
    const double seconds = std::exchange(made->provenance.analysisSeconds, 0);
    if (auto written = writeModalObject(*made, file, ShapePrecision::half); !written)
        return written;
    report(*made, file, seconds);
    return {};
}

Result<void> makeFactory(const FactoryOptions& options) {
    if (auto made = makeDirectory(options.folder); !made)
        return made;
    if (!options.only.empty())
        return makeOne(options.only, options);
    for (const auto& name : factoryObjectNames())
        if (auto done = makeOne(name, options); !done)
            return done;
    return {};
}

} // namespace

void addFactory(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<FactoryOptions>(
        program, chosen, "factory", "Makes the modal objects of the factory presets again",
        makeFactory);
    command->add_option("-o,--output", options->folder, "The directory to write to")->required();
    command
        ->add_option("--only", options->only,
                     "Makes only this object, for example xylophone-72 or plate")
        ->check(CLI::IsMember(factoryObjectNames()));
    command->add_flag("--replace", options->replaces, "Replaces files that exist already");
}

} // namespace idiophone
