// The benchmarks of `idiophone-bench`. All except `plugin` and `crowd` use the engine through its
// headers, without JUCE. Every ratio comes from times measured side by side in one run.
#pragma once

#include "Benchmarks/Report.h"
#include "Benchmarks/Scene.h"
#include "Object/Result.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// The content of the benchmarks, from the factory and the command line.
struct BenchContent {
    /// All factory objects with their names: "xylophone-65" to "xylophone-108", and others.
    std::vector<std::shared_ptr<const ModalObject>> factoryObjects;

    /// A song on the factory's xylophone; empty if none was given.
    std::string songName;
    std::vector<SynthesiserSlot> songSlots;
    std::vector<SceneStrike> song; ///< in ascending order of time
    SynthesisSettings songSettings;

    int pluginReplays = 10; ///< of each preset by `plugin`
};

/// Returns the objects whose names start with `beginning`, in the order of the factory. Fails if
/// there are fewer than `count`.
Result<std::vector<std::shared_ptr<const ModalObject>>>
objectsNamed(const BenchContent& content, const std::string& beginning, std::size_t count = 1);

struct NamedBenchmark {
    const char* name;
    const char* description;
    Result<BenchSection> (*run)(const BenchContent&);
};

/// Returns the benchmarks in the order in which they run.
std::span<const NamedBenchmark> namedBenchmarks();

/// Compares modal banks with the FMA peak, the paper's loop and double-precision exponentials.
Result<BenchSection> benchKernel(const BenchContent&);
/// Compares the worst callback with the mean, and silence with sound.
Result<BenchSection> benchCallback(const BenchContent&);
/// Compares steps of a callback with few and with many strikes, messages and modes.
Result<BenchSection> benchCrowd(const BenchContent&);
/// Times the plugin's callback with every factory preset.
Result<BenchSection> benchPlugin(const BenchContent&);
/// Compares cells under continuous force with the same object's free cells.
Result<BenchSection> benchForce(const BenchContent&);
/// Counts entries of the gain matrix before and after compression.
Result<BenchSection> benchMemory(const BenchContent&);
/// Counts modes mixed over time at two truncation thresholds (the paper's Figure 4).
Result<BenchSection> benchTau(const BenchContent&);
/// Renders a hundred rings on a table (the paper's Figure 8).
Result<BenchSection> benchRings(const BenchContent&);
/// Measures modes mixed, cost and memory with 10, 100 and 1000 sounding bodies.
Result<BenchSection> benchScale(const BenchContent&);
/// Compares the time to move the bodies of the factory scenes with real time.
Result<BenchSection> benchScenes(const BenchContent&);
/// Compares two cores with one for a rendered scene, in time and bits.
Result<BenchSection> benchRender(const BenchContent&);
/// Compares two cores with one for the analysis of large bodies, in time and bits.
Result<BenchSection> benchAnalysis(const BenchContent&);
/// Measures a song's share of one core.
Result<BenchSection> benchXylophone(const BenchContent&);
/// Compares modes and level before and after compression.
Result<BenchSection> benchCompression(const BenchContent&);

} // namespace idiophone
