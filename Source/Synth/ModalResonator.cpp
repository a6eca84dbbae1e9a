#include "Synth/ModalResonator.h"

#include "Synth/ModeCompression.h"
#include "Synth/TubeShares.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace idiophone {

namespace {

constexpr float faintEnergy = 1e-36f; // faintestVelocity²

} // namespace

ModalResonator::ModalResonator(SynthesiserSlot slot,
                               ModeWeights modeWeightsOfObject,
                               std::uint32_t seed,
                               std::size_t channels,
                               double sampleRateHz,
                               SynthesisScratch& sharedScratch)
    : object(slot.object ? std::move(slot.object) : std::make_shared<const ModalObject>()),
      slotSizeRatio(slot.sizeRatio), pitch(slot.pitch), outputChannels(channels),
      sampleRate(sampleRateHz), cellSeconds(cellSamples / sampleRateHz),
      modeWeights(std::move(modeWeightsOfObject)),
      bank(object->modeCount(), object->radiation.empty() ? 1 : channels, sampleRateHz),
      fader(bank, sampleRateHz), increments(bank.emptyIncrements()), scratch(sharedScratch) {
    const std::size_t modes = object->modeCount();
    groupStarts.resize(modes + 1);
    std::iota(groupStarts.begin(), groupStarts.end(), 0);
    modeEigenvalues = referenceEigenvalues = object->eigenvalues;
    groupDampings = dampings = object->dampings();
    pairs = modePairs(*object, seed);
    lostShares.resize(modes * (maximumGroup - 1) / 2); // for groups of the maximum size
    if (!object->radiation.empty())
        for (auto& weights : radiationWeights)
            weights.resize(modes);
    blocks.resize(bank.blockCount());
    activeBlocks.reserve(blocks.size());
    mixedModes.reserve(modes);
    mixedRuns.reserve(modes);
    contacts.reserve(contactCapacity);
    clicks.reserve(contactCapacity);
    rigidBody = rigidRadiator(*object);

    requestedSilences.reserve(modes);
    silencedModes.reserve(modes);
    bank.resize(modes);
    tubeShares = idiophone::tubeShares(*object);
    findTubeParts();
    applySettings({});
    movePoles();
}

void ModalResonator::setDamping(double dampingPerSecond) noexcept {
    if (!(dampingPerSecond >= 0) || !std::isfinite(dampingPerSecond) ||
        dampingPerSecond == requestedDamping)
        return;
    requestedDamping = dampingPerSecond;
    controlsChanged = true;
}

void ModalResonator::setFrequencyRatio(double newRatio) noexcept {
    if (!(newRatio > 0) || !std::isfinite(newRatio) || newRatio == requestedFrequencyRatio)
        return;
    requestedFrequencyRatio = newRatio;
    controlsChanged = true;
}

void ModalResonator::setMaterial(const std::optional<LiveMaterial>& material) noexcept {
    if (material == requestedMaterial)
        return;
    requestedMaterial = material;
    controlsChanged = true;
}

void ModalResonator::setSilencedModes(std::span<const std::uint8_t> silenced) noexcept {
    const bool any = std::ranges::any_of(silenced, [](std::uint8_t is) { return is != 0; });
    if (any && silenced.size() != object->modeCount())
        return;
    const auto wanted = any ? silenced : std::span<const std::uint8_t>();
    if (std::ranges::equal(wanted, requestedSilences))
        return;
    requestedSilences.assign(wanted.begin(), wanted.end());
    silencesChange = true;
    controlsChanged = true;
}

bool ModalResonator::beginSoundingCell(std::int64_t cell,
                                       const SynthesisSettings& settings,
                                       bool settingsChanged) noexcept {
    takeInIncrements(cell);
    cellIndex = cell;
    if (settingsChanged || controlsChanged)
        applySettings(settings);
    if (silent())
        return false;
    survey();
    return true;
}

// At t_c of Raghuvanshi & Lin 2006, eq. 14, the amplitude, which decays as e^{−αt}, reaches τ.
// Comparing the two at every grid point finds it without a logarithm per struck mode.
void ModalResonator::survey() noexcept {
    const EnergySurvey found =
        surveyEnergies(bank.energies(), bank.poles().audibleWeights(), tauEnergy(), faintEnergy,
                       activeBlocks, scratch.aboveTau.data());
    // During a contact the set of ringing modes stays fixed. During a continuous force modes may
    // join but not leave.
    const bool forced = forcedCell == cellIndex - 1;
    std::int32_t ringing = found.modes;
    for (const std::int32_t number : activeBlocks) {
        Block& block = blocks[static_cast<std::size_t>(number)];
        const std::uint16_t above = scratch.aboveTau[static_cast<std::size_t>(number)];
        if (block.rings == above)
            continue;
        const unsigned rings = contacts.empty() ? above | (forced ? block.rings : 0u) : block.rings;
        ringing += std::popcount(rings) - std::popcount(above);
        mixedIsRinging = mixedIsRinging && rings == block.rings;
        block.rings = static_cast<std::uint16_t>(rings);
    }
    if (found.faint)
        for (const std::int32_t b : activeBlocks)
            bank.clearFaint(static_cast<std::size_t>(b), faintestVelocity);
    demanded = {found.amplitudes, ringing};
}

void ModalResonator::chooseModes(std::int32_t share) noexcept {
    const bool all = share >= demanded.modes;
    if (all && mixedIsRinging)
        return;
    if (all)
        for (const std::int32_t b : activeBlocks)
            scratch.wanted[static_cast<std::size_t>(b)] = blocks[static_cast<std::size_t>(b)].rings;
    else
        selectStrongest(static_cast<std::size_t>(std::max(share, 0)));
    scratch.leaving.clear();
    scratch.joining.clear();
    for (const std::int32_t number : activeBlocks) {
        const auto b = static_cast<std::size_t>(number);
        const unsigned before = blocks[b].mixed;
        const unsigned now = scratch.wanted[b];
        forEachMode(b, static_cast<std::uint16_t>(before & ~now),
                    [&](std::int32_t g) { scratch.leaving.push_back(g); });
        forEachMode(b, static_cast<std::uint16_t>(now & ~before),
                    [&](std::int32_t g) { scratch.joining.push_back(g); });
        blocks[b].mixed = scratch.wanted[b];
    }
    mixedIsRinging = all;
    if (!scratch.leaving.empty() || !scratch.joining.empty()) {
        fade(scratch.leaving, 1);
        fade(scratch.joining, -1);
        listMixed();
    }
    retireBlocks(cellIndex);
}

void ModalResonator::selectStrongest(std::size_t most) noexcept {
    scratch.candidates.clear();
    for (const std::int32_t number : activeBlocks) {
        const auto b = static_cast<std::size_t>(number);
        scratch.wanted[b] = 0;
        forEachMode(b, blocks[b].rings, [&](std::int32_t g) { scratch.candidates.push_back(g); });
    }
    keepLoudest(scratch.candidates, bank.energies(), most);
    for (const std::int32_t g : scratch.candidates)
        scratch.wanted[static_cast<std::size_t>(g) / modeBlock] |=
            static_cast<std::uint16_t>(1u << (static_cast<std::size_t>(g) % modeBlock));
}

void ModalResonator::keepLoudest(std::vector<std::int32_t>& modes,
                                 const float* energies,
                                 std::size_t most) noexcept {
    if (modes.size() <= most)
        return;
    const auto cut = modes.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(modes.begin(), cut, modes.end(), [&](std::int32_t a, std::int32_t b) {
        return energies[a] != energies[b] ? energies[a] > energies[b] : a < b;
    });
    modes.erase(cut, modes.end());
}

void ModalResonator::listMixed() noexcept {
    mixedModes.clear();
    for (const std::int32_t number : activeBlocks) {
        const auto b = static_cast<std::size_t>(number);
        forEachMode(b, blocks[b].mixed, [&](std::int32_t g) { mixedModes.push_back(g); });
    }
    findRuns(mixedModes, mixedRuns);
    ++responseVersion;
}

void ModalResonator::retireBlocks(std::int64_t grid) noexcept {
    std::erase_if(activeBlocks, [&](std::int32_t number) {
        Block& block = blocks[static_cast<std::size_t>(number)];
        if ((block.rings | block.mixed) != 0)
            return false;
        block.active = false;
        block.restsSince = grid;
        block.restsAtDampingLog = dampingLog(grid);
        return true;
    });
}

/// Returns whether the block holds anything but zeros.
bool ModalResonator::bringUpToDate(std::size_t b, std::int64_t grid) noexcept {
    if (!(bank.energyOfLoudest(b) > 0))
        return false;
    Block& block = blocks[b];
    bank.advanceBlock(b, cellSeconds * static_cast<double>(grid - block.restsSince),
                      std::exp(block.restsAtDampingLog - dampingLog(grid)), faintestVelocity);
    block.restsSince = grid;
    block.restsAtDampingLog = dampingLog(grid);
    return bank.energyOfLoudest(b) > 0;
}

/// Activates all blocks that hold something above τ; the next survey finds the ringing modes.
void ModalResonator::wakeBlocks() noexcept {
    const float tau = tauEnergy();
    for (std::size_t b = 0; b < bank.blockCount(); ++b)
        if (!blocks[b].active && bank.energyOfLoudest(b) > tau && bringUpToDate(b, cellIndex) &&
            bank.energyOfLoudest(b) > tau)
            activate(b);
}

void ModalResonator::activate(std::size_t b) noexcept {
    if (blocks[b].active)
        return;
    blocks[b].active = true;
    mixedIsRinging = false;
    const auto number = static_cast<std::int32_t>(b);
    activeBlocks.insert(std::lower_bound(activeBlocks.begin(), activeBlocks.end(), number), number);
}

void ModalResonator::mix(std::int32_t share, const CellOutput& cell) noexcept {
    // During a contact or a force the mixed modes stay, whatever the share.
    if (contacts.empty() && forcedCell != cellIndex - 1)
        chooseModes(share);
    mixedLastCell = static_cast<std::int32_t>(mixedModes.size());

    if (damping > 0 || bank.channels() != cell.channels()) {
        alignas(64) std::array<std::array<float, cellSamples>, maximumChannels> sound{};
        const ChannelOutputs outputs{sound[0].data(), sound[1].data()};
        renderCell(outputs);
        addToCell(outputs, 0, cellSamples, cell);
    } else {
        renderCell({cell[0].data(), cell[bank.channels() - 1].data()});
    }
    if (tubesPulse())
        closeTubes(scratch.tubeSound, 0, cellSamples, cell);
    soundContacts(cell);
    soundClicks(cell);
}

void ModalResonator::renderCell(const ChannelOutputs& outputs) noexcept {
    const double fallen = damping > 0 ? std::exp(-damping * cellSeconds) : 1;
    const ChannelOutputs tube = outputsOf(scratch.tubeSound);
    if (tubesPulse())
        scratch.tubeSound = {};
    bank.render(activeBlocks, mixedRuns, fallen, outputs, pulsing(), tube);
    fader.addCell(outputs);
    if (damping > 0) {
        fadeByDamper(outputs, cellSamples);
        if (tubesPulse())
            fadeByDamper(tube, cellSamples);
        fader.scale(static_cast<float>(fallen));
    }
}

/// Applies the damper's decay to the first `count` samples.
void ModalResonator::fadeByDamper(const ChannelOutputs& sound, std::size_t count) const noexcept {
    const double fall = std::exp(-damping / sampleRate);
    double factor = 1;
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t c = 0; c < bank.channels(); ++c)
            sound[c][k] *= static_cast<float>(factor);
        factor *= fall;
    }
}

/// Adds `count` samples to the cell from sample `from` on. A mono sound goes to both channels.
void ModalResonator::addToCell(const ChannelOutputs& sound,
                               std::size_t from,
                               std::size_t count,
                               const CellOutput& cell) const noexcept {
    for (std::size_t c = 0; c < cell.channels(); ++c) {
        const float* heard = sound[std::min(c, bank.channels() - 1)];
        float* output = cell[c].data() + from;
        for (std::size_t k = 0; k < count; ++k)
            output[k] += heard[k];
    }
}

/// Removes the part of `tube` that the discs block; the cell holds the sound of open discs. States
/// ignore the discs, so that no gain steps.
void ModalResonator::closeTubes(CellSound& tube,
                                std::size_t from,
                                std::size_t count,
                                const CellOutput& cell) const noexcept {
    for (std::size_t c = 0; c < bank.channels(); ++c)
        for (std::size_t k = 0; k < count; ++k)
            tube[c][k] *= scratch.tubes.at(from + k) - 1;
    addToCell(outputsOf(tube), from, count, cell);
}

/// Returns the tube's parts of the modes in ascending runs, valid until the next call.
std::span<const ModePart>
ModalResonator::tubePartsOf(std::span<const ModeRun> runs) const noexcept {
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
float ModalResonator::openingNow(std::size_t g) const noexcept {
    const auto mode = static_cast<std::int32_t>(g);
    const auto part = std::ranges::lower_bound(tubeParts, mode, {}, &ModePart::mode);
    return part != tubeParts.end() && part->mode == mode ? 1 + part->share * (scratch.tubesNow - 1)
                                                         : 1;
}

/// Fades modes out (share 1) or in (share −1). The discs hardly move during the 3 ms of a fade.
void ModalResonator::fade(std::span<const std::int32_t> modes, float share) noexcept {
    for (std::size_t k = 0; k < modes.size(); ++k)
        scratch.fadingShares[k] = share * openingNow(static_cast<std::size_t>(modes[k]));
    fader.change(bank, modes, scratch.fadingShares);
}

void ModalResonator::reset() noexcept {
    bank.clear();
    bank.setChannels(1);
    std::fill(blocks.begin(), blocks.end(), Block{});
    activeBlocks.clear();
    mixedModes.clear();
    mixedRuns.clear();
    mixedIsRinging = true;
    contacts.clear();
    clicks.clear();
    keptIncrements.reset();
    forcedCell = never;
    ++responseVersion;
    fader.reset();
    demanded = {};
    mixedLastCell = 0;
}

} // namespace idiophone
