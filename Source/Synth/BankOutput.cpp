// SPDX-License-Identifier: Apache-2.0
#include "Synth/BankOutput.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {

BankOutput::BankOutput(ModalBank& ownBank,
                       std::vector<float> sharesOfTube,
                       double sampleRateHz,
                       SynthesisScratch& sharedScratch)
    : bank(ownBank), scratch(sharedScratch), fader(sharedScratch.fades, sampleRateHz),
      rateHz(sampleRateHz), secondsPerCell(cellSamples / sampleRateHz),
      tubeShares(std::move(sharesOfTube)) {
    tubeParts.reserve(tubeShares.size());
}

void BankOutput::setDamping(double perSecond, std::int64_t grid) noexcept {
    dampingLogBase = dampingLog(grid);
    dampingSince = grid;
    dampingPerSecond = perSecond;
}

void BankOutput::fadeByDamper(const ChannelOutputs& sound, std::size_t count) const noexcept {
    if (dampingPerSecond == 0)
        return;
    const double fall = std::exp(-dampingPerSecond / rateHz);
    double factor = 1;
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t c = 0; c < bank.channels(); ++c)
            sound[c][k] *= static_cast<float>(factor);
        factor *= fall;
    }
}

void BankOutput::findTubeParts(std::span<const std::int32_t> groupStarts) noexcept {
    constexpr float smallestShare = 1e-3f; // a smaller pulsation is inaudible
    tubeParts.clear();
    for (std::size_t g = 0; !tubeShares.empty() && g + 1 < groupStarts.size(); ++g) {
        const float share = tubeShares[index(groupStarts[g])];
        if (std::abs(share) > smallestShare)
            tubeParts.push_back({static_cast<std::int32_t>(g), share});
    }
}

std::span<const ModePart> BankOutput::tubePartsOf(std::span<const ModeRun> runs) const noexcept {
    scratch.tubeParts.clear();
    for (const ModePart& part : tubeParts) {
        while (!runs.empty() && runs.front().first + runs.front().count <= part.mode)
            runs = runs.subspan(1);
        if (!runs.empty() && runs.front().first <= part.mode)
            scratch.tubeParts.push_back(part);
    }
    return scratch.tubeParts;
}

/// Returns the gain of a group by the discs at the grid point where the states hold.
float BankOutput::openingNow(std::size_t g) const noexcept {
    const auto mode = static_cast<std::int32_t>(g);
    const auto part = std::ranges::lower_bound(tubeParts, mode, {}, &ModePart::mode);
    return part != tubeParts.end() && part->mode == mode ? 1 + part->share * (scratch.tubesNow - 1)
                                                         : 1;
}

void BankOutput::fade(std::span<const std::int32_t> modes, float share) noexcept {
    const auto shares = std::span(scratch.fadingShares).first(modes.size());
    std::ranges::fill(shares, share);
    fade(modes, shares);
}

/// The discs hardly move during the 3 ms of a fade.
void BankOutput::fade(std::span<const std::int32_t> modes, std::span<float> shares) noexcept {
    for (std::size_t k = 0; k < modes.size(); ++k)
        shares[k] *= openingNow(index(modes[k]));
    fader.change(bank, modes, shares);
}

void BankOutput::add(const CellSound& sound,
                     std::size_t from,
                     std::size_t count,
                     const CellOutput& cell) const noexcept {
    for (std::size_t c = 0; c < cell.channels(); ++c) {
        const auto& added = sound[std::min(c, bank.channels() - 1)];
        float* output = cell[c].data() + from;
        for (std::size_t k = 0; k < count; ++k)
            output[k] += added[k];
    }
}

void BankOutput::closeTubes(CellSound& tube,
                            std::size_t from,
                            std::size_t count,
                            const CellOutput& cell) const noexcept {
    for (std::size_t c = 0; c < bank.channels(); ++c)
        for (std::size_t k = 0; k < count; ++k)
            tube[c][k] *= scratch.tubes.at(from + k) - 1;
    add(tube, from, count, cell);
}

void BankOutput::render(std::span<const std::int32_t> blocks,
                        std::span<const ModeRun> runs,
                        const CellOutput& cell) noexcept {
    if (dampingPerSecond > 0 || bank.channels() != cell.channels()) {
        alignas(64) CellSound sound{};
        renderTo(outputsOf(sound), blocks, runs);
        add(sound, 0, cellSamples, cell);
    } else {
        renderTo({cell[0].data(), cell[bank.channels() - 1].data()}, blocks, runs);
    }
    if (tubesPulse())
        closeTubes(scratch.tubeSound, 0, cellSamples, cell);
}

void BankOutput::renderTo(const ChannelOutputs& outputs,
                          std::span<const std::int32_t> blocks,
                          std::span<const ModeRun> runs) noexcept {
    const double fallen = dampingPerSecond > 0 ? std::exp(-dampingPerSecond * secondsPerCell) : 1;
    const ChannelOutputs tube = outputsOf(scratch.tubeSound);
    if (tubesPulse())
        scratch.tubeSound = {};
    bank.render(blocks, runs, fallen, outputs, pulsing(runs), tube);
    fader.addCell(outputs);
    if (dampingPerSecond == 0)
        return;
    fadeByDamper(outputs, cellSamples);
    if (tubesPulse())
        fadeByDamper(tube, cellSamples);
    fader.scale(static_cast<float>(fallen));
}

} // namespace idiophone
