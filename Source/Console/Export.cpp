#include "Console/Command.h"
#include "Console/OptionChecks.h"
#include "Gltf/ObjectFile.h"
#include "Instrument/ObjectLibrary.h"
#include "Object/FileBytes.h"

#include <iostream>

namespace idiophone {
namespace {

struct ExportOptions {
    std::string object;
    std::filesystem::path output;
};

Result<void> exportObject(const ExportOptions& options) {
    const auto object = ObjectLibrary::shared().find(options.object);
    if (!object)
        return tl::unexpected(object.error());
    return writeObject(**object, options.output).map([&] {
        std::cout << "wrote " << shownNameOf(options.output) << ": " << (*object)->modeCount()
                  << " modes at " << (*object)->shapeVertexCount() << " points\n";
    });
}

} // namespace

void addExport(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<ExportOptions>(
        program, chosen, "export", "Writes an object as a glTF file for other programs",
        exportObject);
    command
        ->add_option("OBJECT", options->object,
                     "A .modal or glTF file, or the name of a factory object")
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "The .glb file to write (KHR_audio_rigid_bodies), or a .modal file")
        ->type_name(writtenFile)
        ->required();
}

} // namespace idiophone
