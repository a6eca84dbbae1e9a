// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModeFader.h"

#include "Synth/SynthesisSettings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

namespace {
constexpr double fadeSeconds = 0.003;
}

ModeFader::ModeFader(FadeRoom& sharedRoom, double sampleRateHz) : room(sharedRoom) {
    const double samples = std::max(1.0, fadeSeconds * sampleRateHz);
    const auto cells = static_cast<std::size_t>(std::ceil(samples / cellSamples));
    room.window.resize(cells * cellSamples);
    for (auto& tail : tails)
        tail.resize(room.window.size());
    for (std::size_t k = 0; k < room.window.size(); ++k) {
        const double part = std::min(static_cast<double>(k) / samples, 1.0);
        room.window[k] = static_cast<float>(0.5 * (1 + std::cos(std::numbers::pi * part)));
    }
}

void ModeFader::change(ModalBank& bank,
                       std::span<const std::int32_t> modes,
                       std::span<const float> shares) noexcept {
    if (modes.empty())
        return;
    channels = bank.channels();
    for (std::size_t k = 0; k < modes.size(); ++k)
        for (std::size_t c = 0; c < channels; ++c) {
            const auto share = static_cast<double>(shares[k]);
            const ModalState state = bank.state(index(modes[k]), c);
            room.states.set(index(modes[k]), c, {share * state.x, share * state.y});
        }
    findRuns(modes, room.runs);
    alignas(64) CellSound cell;
    for (std::size_t start = 0; start < room.window.size(); start += cellSamples) {
        cell = {};
        bank.renderFrom(room.states, room.runs, outputsOf(cell));
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t k = 0; k < cellSamples; ++k)
                tails[c][start + k] += room.window[start + k] * cell[c][k];
    }
    // Later renders also move the modes between two runs. They must not decay into denormals.
    for (std::size_t c = 0; c < channels; ++c)
        for (const std::int32_t mode : modes)
            room.states.set(index(mode), c, {});
    remaining = room.window.size();
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
