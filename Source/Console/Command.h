// The subcommands of the program `idiophone`, one per file. Each adds its options to the command
// line. If its subcommand is given, it sets the action that Main runs.
#pragma once

#include "Object/Result.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <utility>

namespace idiophone {

/// Runs after the whole command line is parsed. The error becomes one sentence on standard error
/// and an exit code other than 0.
using Action = std::function<Result<void>()>;

/// Adds a subcommand and its options' values. If the subcommand is given, Main runs `run` with
/// these values.
template <class Options>
std::pair<CLI::App*, std::shared_ptr<Options>> addCommand(CLI::App& program,
                                                          Action& chosen,
                                                          const char* name,
                                                          const char* description,
                                                          Result<void> (*run)(const Options&)) {
    auto* command = program.add_subcommand(name, description);
    auto options = std::make_shared<Options>();
    command->final_callback([=, &chosen] { chosen = [=] { return run(*options); }; });
    return {command, options};
}

void addAnalyse(CLI::App& program, Action& chosen);
void addInfo(CLI::App& program, Action& chosen);
void addStrike(CLI::App& program, Action& chosen);
void addRender(CLI::App& program, Action& chosen);
void addScene(CLI::App& program, Action& chosen);
void addMesh(CLI::App& program, Action& chosen);
void addFactory(CLI::App& program, Action& chosen);
void addTune(CLI::App& program, Action& chosen);
void addFit(CLI::App& program, Action& chosen);
void addSample(CLI::App& program, Action& chosen);
void addMaterial(CLI::App& program, Action& chosen);
void addExport(CLI::App& program, Action& chosen);
void addToneMap(CLI::App& program, Action& chosen);
void addSurface(CLI::App& program, Action& chosen);
void addPresets(CLI::App& program, Action& chosen);
void addMaterials(CLI::App& program, Action& chosen);
void addSofaTable(CLI::App& program, Action& chosen); ///< for SofaHead, not listed
void addLists(CLI::App& program, Action& chosen);     ///< parameters, scenes

} // namespace idiophone
