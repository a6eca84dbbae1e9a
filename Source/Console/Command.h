// The subcommands of the program `idiophone`, one a file. Each adds its options to the command
// line. If its subcommand is given, it sets the action that Main runs.
#pragma once

#include "Object/Result.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace idiophone {

/// Runs after the whole command line is parsed. The error becomes one sentence on standard error
/// and an exit code other than 0.
using Action = std::function<Result<void>()>;

void addAnalyse(CLI::App& program, Action& chosen);
void addInfo(CLI::App& program, Action& chosen);
void addStrike(CLI::App& program, Action& chosen);
void addRender(CLI::App& program, Action& chosen);
void addScene(CLI::App& program, Action& chosen);
void addMesh(CLI::App& program, Action& chosen);
void addFactory(CLI::App& program, Action& chosen);
void addTune(CLI::App& program, Action& chosen);
void addFit(CLI::App& program, Action& chosen);
void addToneMap(CLI::App& program, Action& chosen);
void addSurface(CLI::App& program, Action& chosen);
void addPresets(CLI::App& program, Action& chosen);
void addMaterials(CLI::App& program, Action& chosen);
void addSofaTable(CLI::App& program, Action& chosen); ///< for SofaHead, not listed
void addLists(CLI::App& program, Action& chosen);     ///< parameters, scenes

} // namespace idiophone
