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
    runs.reserve(states.x[0].size());
    const double samples = std::max(1.0, fadeSeconds * sampleRateHz);
    const auto cells = static_cast<std::size_t>(std::ceil(samples / cellSamples));
    window.resize(cells * cellSamples);
    for (auto& tail : tails)
        tail.resize(window.size());
    for (std::size_t k = 0; k < window.size(); ++k) {
        const double part = std::min(static_cast<double>(k) / samples, 1.0);
        window[k] = static_cast<float>(0.5 * (1 + std::cos(std::numbers::pi * part)));
    }
}

void ModeFader::change(ModalBank& bank,
                       std::span<const std::int32_t> modes,
                       std::span<const float> shares) noexcept {
    for (std::size_t k = 0; k < modes.size(); ++k)
        take(bank, modes[k], static_cast<double>(shares[k]));
    fade(bank, modes);
}

void ModeFader::take(const ModalBank& bank, std::int32_t mode, double share) noexcept {
    const auto g = static_cast<std::size_t>(mode);
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        states.x[c][g] = share * bank.state(g, c).x;
        states.y[c][g] = share * bank.state(g, c).y;
    }
}

/// Adds the saved states of `modes`, under the window, to the fades.
void ModeFader::fade(ModalBank& bank, std::span<const std::int32_t> modes) noexcept {
    if (modes.empty())
        return;
    channels = bank.channels();
    findRuns(modes, runs);
    alignas(64) std::array<std::array<float, cellSamples>, maximumChannels> cell;
    for (std::size_t start = 0; start < window.size(); start += cellSamples) {
        cell = {};
        bank.renderFrom(states, runs, {cell[0].data(), cell[1].data()});
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t k = 0; k < cellSamples; ++k)
                tails[c][start + k] += window[start + k] * cell[c][k];
    }
    // Later renders also move the modes between two runs. They must not decay into denormals.
    for (std::size_t c = 0; c < channels; ++c)
        for (const std::int32_t mode : modes)
            states.x[c][static_cast<std::size_t>(mode)] =
                states.y[c][static_cast<std::size_t>(mode)] = 0;
    remaining = window.size();
}

void ModeFader::addCell(const ChannelOutputs& cell) noexcept {
    if (!active())
        return;
    for (std::size_t c = 0; c < channels; ++c) {
        auto& tail = tails[c];
        for (std::size_t k = 0; k < cellSamples; ++k)
            cell[c][k] += tail[k];
        std::copy(tail.begin() + cellSamples, tail.end(), tail.begin());
        std::fill(tail.end() - cellSamples, tail.end(), 0.0f);
    }
    remaining -= cellSamples;
}

void ModeFader::scale(float factor) noexcept {
    for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t k = 0; k < remaining; ++k)
            tails[c][k] *= factor;
}

void ModeFader::widen() noexcept {
    tails[1] = tails[0];
    channels = 2;
}

void ModeFader::reset() noexcept {
    for (auto& tail : tails)
        std::fill(tail.begin(), tail.end(), 0.0f);
    channels = 1;
    remaining = 0;
}

} // namespace idiophone
