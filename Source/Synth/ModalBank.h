// The poles, coefficients and states of one object's modes (groups of merged modes) in contiguous
// arrays. It moves and renders them; which of them sound is decided elsewhere.
#pragma once

#include "Synth/ModalPole.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread.
class ModalBank {
public:
    ModalBank(std::size_t capacity, double sampleRateHz);

    const ModalPole& pole(std::size_t g) const noexcept { return poles[g]; }
    ModalState state(std::size_t g) const noexcept { return {states[2 * g], states[2 * g + 1]}; }

    /// Gives g another pole. The state x, y stays (DESIGN 5, State: no step in the velocity); where
    /// the coordinates change near critical damping, velocity and displacement stay.
    void setPole(std::size_t g, const ModalPole& pole) noexcept;

    void setState(std::size_t g, const ModalState& state) noexcept;
    void add(std::size_t g, const ModalState& state) noexcept;
    void scale(std::size_t g, double factor) noexcept;

    /// Free motion over any time, exact, and over one cell from a stored propagator.
    void advance(std::size_t g, double seconds) noexcept;
    void advanceCell(std::size_t g) noexcept;

    double amplitude(std::size_t g) const noexcept { return amplitudeBound(pole(g), state(g)); }

    /// Adds modes `active` to `output` (a multiple of 16 samples) and advances them.
    void render(std::span<const std::int32_t> active, std::span<float> output) noexcept;

    /// The same from states [G,2] elsewhere; the bank's own do not move.
    void renderFrom(std::span<double> otherStates,
                    std::span<const std::int32_t> active,
                    std::span<float> output) const noexcept;

private:
    double sampleSeconds;
    std::vector<ModalPole> poles;
    std::vector<float> tables;         ///< [G,2,16]
    std::vector<double> steps;         ///< [G,2,2]
    std::vector<Propagator> cellSteps; ///< [G]
    std::vector<double> states;        ///< [G,2]
};

} // namespace idiophone
