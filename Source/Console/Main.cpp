#include "Console/Command.h"
#include "Console/Interrupt.h"
#include "Console/OptionChecks.h"
#include "Console/TerminalText.h"
#include "Object/WorkControl.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#ifdef _WIN32
#define NOMINMAX
#include <windows.h>
#endif

namespace {

enum ExitCode { success = 0, failed = 1, badUsage = 2, interrupted = 130 };

int complain(const std::string& sentence, ExitCode code) {
    std::cerr << "idiophone: " << sentence << std::endl;
    return code;
}

int run(int argc, char** argv) {
    using namespace idiophone;
    CLI::App program("Idiophone: triangle meshes become playable modal objects", "idiophone");
    program.set_version_flag("--version", "Idiophone " IDIOPHONE_VERSION);
    Action chosen;
    for (const auto add : {addAnalyse, addInfo, addStrike, addRender, addScene, addMesh, addFactory,
                           addSample, addTune, addFit, addExport, addMaterial, addToneMap,
                           addSurface, addPresets, addMaterials, addLists, addSofaTable})
        add(program, chosen);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return program.exit(help);
    } catch (const CLI::ParseError& error) {
        return complain(error.what(), badUsage);
    }
    if (!chosen)
        return complain("Give a command; `idiophone --help` lists them.", badUsage);
    for (const auto* command : program.get_subcommands())
        if (const auto apart = checkWrittenFiles(*command); !apart)
            return complain(apart.error().message, failed);
    const auto outcome = chosen();
    if (outcome)
        return std::cout.flush() ? success
                                 : complain("the standard output cannot be written", failed);
    const auto& sentence = outcome.error().message;
    const bool stopped = sentence == cancelledMessage || sentence == interruptedMessage;
    return complain(sentence, stopped ? interrupted : failed);
}

} // namespace

int main(int argc, char** argv) {
#ifdef _WIN32 // utf8.manifest does the same for arguments and names of files
    SetConsoleOutputCP(CP_UTF8);
#endif
    const idiophone::TerminalText output(std::cout), complaints(std::cerr);
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain("There is not enough memory.", failed);
    } catch (const std::exception& exception) {
        return complain(exception.what(), failed);
    }
}
