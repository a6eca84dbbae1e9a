// The benchmarks of `idiophone bench`. They use the engine as a user of its headers does, without
// JUCE; every ratio comes from times measured side by side in one run.
#pragma once

#include "Console/BenchReport.h"
#include "Console/BenchScene.h"
#include "Object/Result.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// What the benchmarks play, from the factory and the command line.
struct BenchContent {
    /// All factory objects by their names: "xylophone-65" to "xylophone-108", others.
    std::vector<std::shared_ptr<const ModalObject>> factoryObjects;

    /// A song on the factory's xylophone; empty where none was given.
    std::string songName;
    std::vector<SynthesiserSlot> songSlots;
    std::vector<SceneStrike> song; ///< in ascending order of time
    SynthesisSettings songSettings;
};

/// Objects whose names begin so, in the order of the factory.
std::vector<std::shared_ptr<const ModalObject>> objectsNamed(const BenchContent& content,
                                                             std::string_view beginning);

struct NamedBenchmark {
    const char* name;
    const char* description;
    Result<BenchSection> (*run)(const BenchContent&);
};

/// In the order in which they run.
std::span<const NamedBenchmark> namedBenchmarks();

/// Modal banks against the FMA peak, the paper's loop and double-precision exponentials.
Result<BenchSection> benchKernel(const BenchContent&);
/// The worst callback against the mean, and silence against sound.
Result<BenchSection> benchCallback(const BenchContent&);
/// Cells under continuous force against the same object's free cells.
Result<BenchSection> benchForce(const BenchContent&);
/// Entries of the gain matrix before and after compression.
Result<BenchSection> benchMemory(const BenchContent&);
/// Modes mixed over time at two truncation thresholds (the paper's Figure 4).
Result<BenchSection> benchTau(const BenchContent&);
/// A hundred rings on a table (the paper's Figure 8).
Result<BenchSection> benchRings(const BenchContent&);
/// Modes mixed, cost and memory with 10, 100 and 1000 sounding bodies.
Result<BenchSection> benchScale(const BenchContent&);
/// A song as a share of one core.
Result<BenchSection> benchXylophone(const BenchContent&);
/// Modes and level before and after compression.
Result<BenchSection> benchCompression(const BenchContent&);

} // namespace idiophone
