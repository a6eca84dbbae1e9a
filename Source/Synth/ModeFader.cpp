#include "Synth/ModeFader.h"

#include "Synth/SynthesisSettings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

namespace {
constexpr double fadeSeconds = 0.003;
}

ModeFader::ModeFader(std::size_t modeCapacity, double sampleRateHz) : states(2 * modeCapacity) {
    const double samples = std::max(1.0, fadeSeconds * sampleRateHz);
    const auto cells = static_cast<std::size_t>(std::ceil(samples / cellSamples));
    window.resize(cells * cellSamples);
    tail.resize(window.size());
    scratch.resize(window.size());
    for (std::size_t k = 0; k < window.size(); ++k) {
        const double part = std::min(static_cast<double>(k) / samples, 1.0);
        window[k] = static_cast<float>(0.5 * (1 + std::cos(std::numbers::pi * part)));
    }
}

void ModeFader::leave(const ModalBank& bank, std::span<const std::int32_t> modes) noexcept {
    fade(bank, modes, 1);
}

void ModeFader::enter(const ModalBank& bank, std::span<const std::int32_t> modes) noexcept {
    fade(bank, modes, -1);
}

void ModeFader::fade(const ModalBank& bank,
                     std::span<const std::int32_t> modes,
                     float sign) noexcept {
    if (modes.empty())
        return;
    for (const std::int32_t mode : modes) {
        const auto g = static_cast<std::size_t>(mode);
        states[2 * g] = bank.state(g).x;
        states[2 * g + 1] = bank.state(g).y;
    }
    std::fill(scratch.begin(), scratch.end(), 0.0f);
    bank.renderFrom(states, modes, scratch);
    for (std::size_t k = 0; k < tail.size(); ++k)
        tail[k] += sign * window[k] * scratch[k];
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
