#include "Synth/ModeFader.h"

#include "Synth/SynthesisSettings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {

namespace {
constexpr double fadeSeconds = 0.003;
}

ModeFader::ModeFader(const ModalBank& bank, double sampleRateHz) : states(bank.emptyStates()) {
    runs.reserve(states.x.size());
    const double samples = std::max(1.0, fadeSeconds * sampleRateHz);
    const auto cells = static_cast<std::size_t>(std::ceil(samples / cellSamples));
    window.resize(cells * cellSamples);
    tail.resize(window.size());
    for (std::size_t k = 0; k < window.size(); ++k) {
        const double part = std::min(static_cast<double>(k) / samples, 1.0);
        window[k] = static_cast<float>(0.5 * (1 + std::cos(std::numbers::pi * part)));
    }
}

void ModeFader::leave(ModalBank& bank, std::span<const std::int32_t> modes) noexcept {
    fade(bank, modes, 1);
}

void ModeFader::enter(ModalBank& bank, std::span<const std::int32_t> modes) noexcept {
    fade(bank, modes, -1);
}

void ModeFader::fade(ModalBank& bank, std::span<const std::int32_t> modes, float sign) noexcept {
    if (modes.empty())
        return;
    for (const std::int32_t mode : modes) {
        const auto g = static_cast<std::size_t>(mode);
        states.x[g] = bank.state(g).x;
        states.y[g] = bank.state(g).y;
    }
    findRuns(modes, runs);
    alignas(64) std::array<float, cellSamples> cell;
    for (std::size_t start = 0; start < tail.size(); start += cellSamples) {
        cell.fill(0);
        bank.renderFrom(states, runs, subBlocks, cell.data());
        for (std::size_t k = 0; k < cell.size(); ++k)
            tail[start + k] += sign * window[start + k] * cell[k];
    }
    // The modes between them are carried along, and must not fade into denormals.
    for (const std::int32_t mode : modes)
        states.x[static_cast<std::size_t>(mode)] = states.y[static_cast<std::size_t>(mode)] = 0;
    remaining = tail.size();
}

void ModeFader::addCell(std::span<float> cell) noexcept {
    if (!active())
        return;
    for (std::size_t k = 0; k < cell.size(); ++k)
        cell[k] += tail[k];
    std::copy(tail.begin() + cellSamples, tail.end(), tail.begin());
    std::fill(tail.end() - cellSamples, tail.end(), 0.0f);
    remaining -= cellSamples;
}

void ModeFader::scale(float factor) noexcept {
    for (std::size_t k = 0; k < remaining; ++k)
        tail[k] *= factor;
}

void ModeFader::reset() noexcept {
    std::fill(tail.begin(), tail.end(), 0.0f);
    remaining = 0;
}

} // namespace idiophone
