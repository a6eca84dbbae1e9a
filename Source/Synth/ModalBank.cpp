#include "Synth/ModalBank.h"

#include "Synth/PoleKernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace idiophone {

namespace {

constexpr std::size_t cellSize = subBlocks * subBlockSamples;

// Far below the rounding of a table, far above denormals even when multiplied by a faint state.
constexpr double faintestTableEntry = 1e-15;

// What no object that makes sense reaches; beyond, squares would overflow.
constexpr float largestEnergy = 1e36f;

float tableEntry(double value) noexcept {
    return std::abs(value) < faintestTableEntry ? 0.0f : static_cast<float>(value);
}

std::size_t index(std::int32_t number) noexcept {
    return static_cast<std::size_t>(number);
}

} // namespace

void findRuns(std::span<const std::int32_t> modes, std::vector<ModeRun>& runs) noexcept {
    runs.clear();
    for (const std::int32_t mode : modes)
        if (!runs.empty() && runs.back().first + runs.back().count == mode)
            ++runs.back().count;
        else
            runs.push_back({mode, 1});
}

ModalBank::ModalBank(std::size_t capacity, double sampleRateHz) : sampleSeconds(1 / sampleRateHz) {
    const std::size_t padded = (capacity + modeBlock - 1) / modeBlock * modeBlock;
    for (auto* array : {&stiffness, &damping, &decay, &frequency, &displacementShare,
                        &velocityShare, &resonance, &cellRe, &cellIm, &states.x, &states.y})
        array->resize(padded);
    for (auto* array : {&audibles, &turnRe, &turnIm, &energy})
        array->resize(padded);
    tables.resize(2 * subBlockSamples * padded);
    heavyModes.reserve(capacity);
    allBlocks.resize(padded / modeBlock);
    std::iota(allBlocks.begin(), allBlocks.end(), 0);
    count = capacity;
}

ModeStates ModalBank::emptyStates() const {
    ModeStates empty;
    empty.x.resize(states.x.size());
    empty.y.resize(states.y.size());
    return empty;
}

void ModalBank::resize(std::size_t modes) noexcept {
    count = modes;
    heavyModes.clear();
    std::fill(audibles.begin(), audibles.end(), 0.0f);
    std::fill(resonance.begin(), resonance.end(), 0.0);
    // Padding and modes to come are oscillating modes at rest.
    std::fill(stiffness.begin(), stiffness.end(), 1.0);
    std::fill(damping.begin(), damping.end(), 0.0);
    clear();
}

void ModalBank::clear() noexcept {
    std::fill(states.x.begin(), states.x.end(), 0.0);
    std::fill(states.y.begin(), states.y.end(), 0.0);
    std::fill(energy.begin(), energy.end(), 0.0f);
}

void ModalBank::movePoles(std::span<const double> referenceEigenvalues,
                          const PoleLaw& law,
                          double lowestHz,
                          double highestHz) noexcept {
    heavyModes.clear();
    for (std::size_t g = 0; g < count; ++g) {
        const ModalPole moved = law.pole(referenceEigenvalues[g]);
        const bool oscillates = isOscillating(moved);
        if (oscillates != isOscillating(pole(g)) && energy[g] > 0) {
            const ModalState changed = stateOf(moved, motionOf(pole(g), state(g)));
            states.x[g] = changed.x;
            states.y[g] = changed.y;
        }
        stiffness[g] = moved.stiffness;
        damping[g] = moved.damping;
        const double hz = naturalFrequencyHz(moved);
        const bool inBand = hz >= lowestHz && hz < highestHz;
        const bool light = moved.damping * moved.damping < 4e-4 * moved.stiffness;
        audibles[g] = inBand ? 1.0f : 0.0f;
        resonance[g] = inBand && light ? hz : 0;
        if (!oscillates)
            heavyModes.emplace_back().mode = static_cast<std::int32_t>(g);
    }
    rotationsOfPoles({stiffness.data(), damping.data(), decay.data(), frequency.data(),
                      displacementShare.data(), velocityShare.data(), turnRe.data(), turnIm.data(),
                      cellRe.data(), cellIm.data(), tables.data()},
                     paddedSize(), sampleSeconds);
    for (HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        heavy.turn = propagator(pole(g), sampleSeconds * subBlockSamples);
        heavy.cell = propagator(pole(g), sampleSeconds * cellSize);
        correctHeavy(g);
        measure(g);
    }
}

void ModalBank::correctHeavy(std::size_t g) noexcept {
    displacementShare[g] = std::sqrt(stiffness[g]);
    velocityShare[g] = 0;
    turnRe[g] = 0;
    turnIm[g] = 0;
    cellRe[g] = 0;
    cellIm[g] = 0;
    const Propagator sample = propagator(pole(g), sampleSeconds);
    Propagator power;
    float* table = tables.data() + 2 * subBlockSamples * g;
    for (std::size_t k = 0; k < subBlockSamples; ++k) {
        table[k] = tableEntry(power.xx);
        table[subBlockSamples + k] = tableEntry(power.xy);
        power = power * sample;
    }
}

void ModalBank::measure(std::size_t g) noexcept {
    const double size = amplitude(g);
    energy[g] = static_cast<float>(size * size);
}

void ModalBank::setState(std::size_t g, const ModalState& state) noexcept {
    states.x[g] = state.x;
    states.y[g] = state.y;
    measure(g);
}

void ModalBank::add(std::size_t g, const ModalState& state) noexcept {
    states.x[g] += state.x;
    states.y[g] += state.y;
    measure(g);
}

float ModalBank::energyOfLoudest(std::size_t block) const noexcept {
    const float* first = energy.data() + block * modeBlock;
    return *std::max_element(first, first + modeBlock);
}

void ModalBank::advanceBlock(std::size_t block,
                             double seconds,
                             double factor,
                             double floor) noexcept {
    const std::size_t first = block * modeBlock;
    for (HeavyMode& heavy : heavyModes)
        heavy.aside = state(index(heavy.mode));
    rotateModes(decay.data() + first, frequency.data() + first, modeBlock, seconds, factor,
                states.x.data() + first, states.y.data() + first);
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        if (g / modeBlock != block)
            continue;
        const ModalState moved = propagator(pole(g), seconds) * heavy.aside;
        states.x[g] = factor * moved.x;
        states.y[g] = factor * moved.y;
    }
    for (std::size_t g = first; g < first + modeBlock; ++g)
        measure(g);
    clearFaint(block, floor);
}

void ModalBank::clearFaint(std::size_t block, double floor) noexcept {
    for (std::size_t g = block * modeBlock; g < (block + 1) * modeBlock; ++g)
        if (!(static_cast<double>(energy[g]) > floor * floor && energy[g] < largestEnergy))
            states.x[g] = states.y[g] = energy[g] = 0;
}

void ModalBank::render(std::span<const std::int32_t> blocks,
                       std::span<const ModeRun> runs,
                       double scale,
                       float* output) noexcept {
    renderStates(states.x.data(), states.y.data(), energy.data(), blocks, runs, subBlocks, scale,
                 output);
}

void ModalBank::renderFrom(ModeStates& from,
                           std::span<const ModeRun> runs,
                           std::size_t subBlockCount,
                           float* output) noexcept {
    if (runs.empty())
        return;
    const std::size_t first = index(runs.front().first) / modeBlock;
    const std::size_t last = index(runs.back().first + runs.back().count - 1) / modeBlock;
    renderStates(from.x.data(), from.y.data(), nullptr,
                 std::span(allBlocks).subspan(first, last - first + 1), runs, subBlockCount, 1,
                 output);
}

void ModalBank::renderStates(double* x,
                             double* y,
                             float* energies,
                             std::span<const std::int32_t> blocks,
                             std::span<const ModeRun> runs,
                             std::size_t subBlockCount,
                             double scale,
                             float* output) noexcept {
    SubBlockStates ahead;
    alignas(64) std::array<float, batchModes> unused;
    std::size_t run = 0;
    for (std::size_t b = 0; b < blocks.size();) {
        // A batch is as many consecutive blocks as it holds.
        const std::size_t firstBlock = index(blocks[b]);
        std::size_t blocksHere = 1;
        while (b + blocksHere < blocks.size() && blocksHere < batchModes / modeBlock &&
               index(blocks[b + blocksHere]) == firstBlock + blocksHere)
            ++blocksHere;
        b += blocksHere;
        const std::size_t first = firstBlock * modeBlock;
        const std::size_t modes = blocksHere * modeBlock;
        const auto isHere = [&](const HeavyMode& heavy) {
            return index(heavy.mode) >= first && index(heavy.mode) < first + modes;
        };
        const auto heavyBegin = std::find_if(heavyModes.begin(), heavyModes.end(), isHere);
        auto heavyEnd = heavyBegin;
        for (; heavyEnd != heavyModes.end() && isHere(*heavyEnd); ++heavyEnd) {
            const std::size_t g = index(heavyEnd->mode);
            heavyEnd->aside = {x[g], y[g]};
        }

        float* energyHere = energies != nullptr ? energies + first : unused.data();
        advanceModes({turnRe.data() + first, turnIm.data() + first, cellRe.data() + first,
                      cellIm.data() + first},
                     modes, scale, x + first, y + first, energyHere, ahead);
        for (auto heavy = heavyBegin; heavy != heavyEnd; ++heavy) {
            const std::size_t g = index(heavy->mode);
            ModalState moving = heavy->aside;
            const ModalState next = heavy->cell * moving;
            for (std::size_t k = 0; k < subBlocks; ++k) {
                ahead.x[k][g - first] = static_cast<float>(moving.x);
                ahead.y[k][g - first] = static_cast<float>(moving.y);
                moving = heavy->turn * moving;
            }
            x[g] = scale * next.x;
            y[g] = scale * next.y;
            const double size = amplitudeBound(pole(g), {x[g], y[g]});
            energyHere[g - first] = static_cast<float>(size * size);
        }

        for (; run < runs.size() && index(runs[run].first) < first + modes; ++run) {
            const std::size_t runFirst = index(runs[run].first);
            const std::size_t runEnd = runFirst + index(runs[run].count);
            const std::size_t from = std::max(runFirst, first);
            const std::size_t end = std::min(runEnd, first + modes);
            mixModes(tables.data() + 2 * subBlockSamples * from, ahead, from - first, end - from,
                     subBlockCount, output);
            if (runEnd > first + modes)
                break;
        }
    }
}

void ModalBank::addMoved(const ModeStates& others,
                         std::size_t samples,
                         double factor,
                         ModeStates& sum) noexcept {
    for (HeavyMode& heavy : heavyModes)
        heavy.aside = {sum.x[index(heavy.mode)], sum.y[index(heavy.mode)]};
    if (samples == cellSize) {
        for (std::size_t g = 0; g < paddedSize(); ++g) {
            sum.x[g] += factor * (cellRe[g] * others.x[g] - cellIm[g] * others.y[g]);
            sum.y[g] += factor * (cellRe[g] * others.y[g] + cellIm[g] * others.x[g]);
        }
    } else {
        const float* table = tables.data() + samples % subBlockSamples;
        for (std::size_t g = 0; g < paddedSize(); ++g, table += 2 * subBlockSamples) {
            float re = table[0];
            float im = -table[subBlockSamples];
            for (std::size_t turns = samples / subBlockSamples; turns > 0; --turns) {
                const float turned = re * turnRe[g] - im * turnIm[g];
                im = re * turnIm[g] + im * turnRe[g];
                re = turned;
            }
            const double moveRe = factor * static_cast<double>(re);
            const double moveIm = factor * static_cast<double>(im);
            sum.x[g] += moveRe * others.x[g] - moveIm * others.y[g];
            sum.y[g] += moveRe * others.y[g] + moveIm * others.x[g];
        }
    }
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        const ModalState moved = propagator(pole(g), static_cast<double>(samples) * sampleSeconds) *
                                 ModalState{others.x[g], others.y[g]};
        sum.x[g] = heavy.aside.x + factor * moved.x;
        sum.y[g] = heavy.aside.y + factor * moved.y;
    }
}

void ModalBank::join(const ModeStates& others, std::size_t samples, double factor) noexcept {
    addMoved(others, samples, factor, states);
    measureStates(states, energy.data());
}

void ModalBank::statesOfImpulse(ModeStates& velocities) const noexcept {
    for (std::size_t g = 0; g < paddedSize(); ++g)
        velocities.y[g] = velocityShare[g] * velocities.x[g];
}

void ModalBank::measureStates(const ModeStates& others, float* energies) const noexcept {
    for (std::size_t g = 0; g < paddedSize(); ++g)
        energies[g] = static_cast<float>(others.x[g] * others.x[g] + others.y[g] * others.y[g]);
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        const double size = amplitudeBound(pole(g), {others.x[g], others.y[g]});
        energies[g] = static_cast<float>(size * size);
    }
}

void ModalBank::rotate(ModeStates& from, double seconds, double factor) noexcept {
    for (HeavyMode& heavy : heavyModes)
        heavy.aside = {from.x[index(heavy.mode)], from.y[index(heavy.mode)]};
    turnModes(decay.data(), frequency.data(), paddedSize(), seconds, factor, from.x.data(),
              from.y.data());
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        const ModalState moved = propagator(pole(g), seconds) * heavy.aside;
        from.x[g] = factor * moved.x;
        from.y[g] = factor * moved.y;
    }
}

void ModalBank::forcedStates(const PulseInstant& pulse,
                             ModeStates& forced,
                             double* steady,
                             double* swingRe,
                             double* swingIm) const noexcept {
    idiophone::forcedStates(pulse,
                            {stiffness.data(), damping.data(), displacementShare.data(),
                             velocityShare.data(), forced.x.data(), forced.y.data(), steady,
                             swingRe, swingIm},
                            paddedSize());
}

} // namespace idiophone
