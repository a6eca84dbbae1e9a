// Objects struck at given times and rendered cell by cell, for most benchmarks. It has no keys,
// mallets or parameters.
#pragma once

#include "Synth/ModalPole.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <memory>
#include <random>
#include <span>
#include <vector>

namespace idiophone {

inline constexpr double benchSampleRateHz = 44100;
inline constexpr double cellSeconds = cellSamples / benchSampleRateHz;

struct SceneStrike {
    double seconds = 0;
    std::size_t slot = 0;
    Strike strike;
};

class BenchScene {
public:
    /// `strikes` are in ascending order of time.
    BenchScene(std::vector<SynthesiserSlot> slots,
               std::vector<SceneStrike> strikes,
               const SynthesisSettings& settings);

    /// Silences everything and returns to the first strike.
    void restart();

    /// Renders the next cell with the strikes that fall into it.
    std::span<const float, cellSamples> nextCell();

    /// Renders everything from the start, [cells · 64].
    std::vector<float> render(std::size_t cells);

    /// Renders from the start and returns the number of modes mixed in each cell.
    std::vector<std::int64_t> modesMixed(std::size_t cells);

    Synthesiser& synthesiser() { return synth; }

private:
    Synthesiser synth;
    std::vector<SceneStrike> strikes; ///< seconds counted in samples
    std::size_t next = 0;
    std::int64_t cellIndex = 0;
    alignas(64) std::array<float, cellSamples> cell{};
};

/// Returns a number from 0 to 1. The standard fixes the engine's numbers, but not those of its
/// distributions.
double share(std::minstd_rand& random);

std::size_t cellsIn(double seconds);

double meanOf(std::span<const std::int64_t> numbers);

/// Returns the vertex of a row of the shapes.
StrikePoint strikePointOfRow(const ModalObject& object, std::size_t row);

/// Returns the vertex nearest to a point of the bounding box (−1 to 1 along x, y and z).
StrikePoint strikePointAt(const ModalObject& object, const std::array<double, 3>& place);

/// Returns a strike perpendicular to the surface. A contact time of 0 is an impulse.
Strike strikeInto(const StrikePoint& point, double newtonSeconds, double contactSeconds);

/// Returns a body whose modes have equal shapes, are evenly spread up to 18 kHz, then shifted, and
/// ring for a minute.
std::shared_ptr<const ModalObject>
longRingingObject(const ModalObject& body, std::size_t modes, double shiftHz);

} // namespace idiophone
