// What the settings make of a sounding object's poles, and which of its modes ring.
#include "Synth/ModeCompression.h"
#include "Synth/SoundingObject.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

namespace {

constexpr double lowestHz = 20;
constexpr double highestShareOfSampleRate = 0.49;

// −360 dB of full scale, where a state becomes zero: 1e-18 is far above single-precision denormals.
constexpr double floorVelocity = 1e-18;

// Cells, centuries of them: stands for never where a mode has no damping.
constexpr double farAway = 1e13;

double ratio(double value, double reference) noexcept {
    return value > 0 && reference > 0 ? value / reference : 1;
}

} // namespace

void SoundingObject::applySettings(const SynthesisSettings& settings) noexcept {
    controlsChanged = false;
    const Material& reference = object->material;
    const LiveMaterial material = settings.material.value_or(
        LiveMaterial{reference.youngsModulusPa, reference.densityKgPerM3,
                     reference.fluidDampingPerSecond, reference.viscoelasticDampingSeconds});
    const double size = slotSizeRatio * settings.sizeRatio;
    const double tuning = settings.frequencyRatio * requestedFrequencyRatio / size;
    const double density = ratio(material.densityKgPerM3, reference.densityKgPerM3);
    const double stiffness = ratio(material.youngsModulusPa, reference.youngsModulusPa);
    const PoleLaw newLaw{stiffness / density * tuning * tuning, material.fluidDampingPerSecond,
                         material.viscoelasticDampingSeconds};
    const double newTau = std::max(settings.tau * metresPerSecondPerTau, floorVelocity);
    gainRatio = 1 / (density * size * size * size);
    compression = settings.compression;

    const bool polesMove = newLaw != law;
    const bool dampingMoves = requestedDamping != damping;
    const bool tauFalls = newTau < tauVelocity;
    if (!polesMove && !dampingMoves && newTau == tauVelocity)
        return;
    // A contact's forced part belongs to the poles it was computed for: it is made free motion, and
    // taken out again with the poles and the damping that hold from here on.
    if (polesMove || dampingMoves)
        for (Contact& contact : contacts)
            moveContact(contact, 1);
    dampingLogBase = dampingLog(cellIndex);
    dampingSince = cellIndex;
    damping = requestedDamping;
    tauVelocity = newTau;
    if (polesMove)
        movePoles(newLaw);
    if (polesMove || dampingMoves)
        for (Contact& contact : contacts)
            moveContact(contact, -1);
    for (const std::int32_t g : ringingModes)
        updateEnd(index(g), cellIndex);
    if (tauFalls && cellIndex < faintUntil)
        reviveTruncated();
}

void SoundingObject::movePoles(const PoleLaw& newLaw) noexcept {
    law = newLaw;
    ++poleVersion;
    // What leaves the band fades with the pole it had: the new one would alias.
    leaving.clear();
    for (const std::int32_t g : mixedModes) {
        Group& group = groups[index(g)];
        const double hz = naturalFrequencyHz(law.pole(group.referenceEigenvalue));
        if (hz < lowestHz || hz >= highestShareOfSampleRate * sampleRate) {
            leaving.push_back(g);
            group.mixed = false;
        }
    }
    fader.leave(bank, leaving);
    std::erase_if(mixedModes, [&](std::int32_t g) { return !groups[index(g)].mixed; });
    for (const std::int32_t g : ringingModes)
        bringUpToDate(index(g), cellIndex);
}

void SoundingObject::regroup() noexcept {
    groupedLaw = law;
    groupedCompression = compression;
    groupCount = groupModes(object->eigenvalues, law, compression, groupStarts);
    faintUntil = 0;
    for (std::size_t g = 0; g < groupCount; ++g) {
        const auto first = index(groupStarts[g]);
        const auto count = index(groupStarts[g + 1]) - first;
        groups[g] = Group{};
        groups[g].referenceEigenvalue =
            mergedEigenvalue(std::span(object->eigenvalues).subspan(first, count),
                             std::span(modeWeights).subspan(first, count));
        bank.setState(g, {});
    }
}

double SoundingObject::dampingLog(std::int64_t grid) const noexcept {
    return dampingLogBase + damping * cellSeconds * static_cast<double>(grid - dampingSince);
}

void SoundingObject::bringUpToDate(std::size_t g, std::int64_t grid) noexcept {
    Group& group = groups[g];
    const ModalState state = bank.state(g);
    if (!group.rings && (state.x != 0 || state.y != 0)) {
        bank.advance(g, cellSeconds * static_cast<double>(grid - group.stateCell));
        bank.scale(g, std::exp(group.stateDampingLog - dampingLog(grid)));
        if (!(bank.amplitude(g) > floorVelocity))
            bank.setState(g, {});
        group.stateCell = grid;
        group.stateDampingLog = dampingLog(grid);
    }
    if (group.poleVersion == poleVersion)
        return;
    group.poleVersion = poleVersion;
    bank.setPole(g, law.pole(group.referenceEigenvalue));
    const double hz = naturalFrequencyHz(bank.pole(g));
    group.audible = hz >= lowestHz && hz < highestShareOfSampleRate * sampleRate;
}

void SoundingObject::updateEnd(std::size_t g, std::int64_t grid) noexcept {
    Group& group = groups[g];
    const double amplitude = bank.amplitude(g);
    if (!(amplitude > floorVelocity) || !std::isfinite(amplitude)) {
        bank.setState(g, {});
        group.endCell = grid;
        return;
    }
    group.stateLog = std::log(amplitude);
    group.stateCell = grid;
    group.stateDampingLog = dampingLog(grid);
    const double rate = (decayBound(bank.pole(g)) + damping) * cellSeconds;
    const double excess = group.stateLog - std::log(tauVelocity);
    const double cells = excess > 0 ? std::min(farAway, std::ceil(excess / rate)) : 0;
    group.endCell = grid + static_cast<std::int64_t>(cells);
}

void SoundingObject::reviveTruncated() noexcept {
    const double tauLog = std::log(tauVelocity);
    for (std::size_t g = 0; g < groupCount; ++g) {
        Group& group = groups[g];
        const ModalState state = bank.state(g);
        if (group.rings || (state.x == 0 && state.y == 0))
            continue;
        const double rate = decayBound(bank.pole(g)) * cellSeconds;
        const double cells = static_cast<double>(cellIndex - group.stateCell);
        const double fallen = rate * cells + dampingLog(cellIndex) - group.stateDampingLog;
        if (group.stateLog - fallen <= tauLog)
            continue;
        bringUpToDate(g, cellIndex);
        updateEnd(g, cellIndex);
        group.rings = group.endCell > cellIndex;
    }
    listRinging();
}

void SoundingObject::listRinging() noexcept {
    ringingModes.clear();
    for (std::size_t g = 0; g < groupCount; ++g)
        if (groups[g].rings)
            ringingModes.push_back(static_cast<std::int32_t>(g));
}

void SoundingObject::dropEnded() noexcept {
    std::erase_if(ringingModes, [&](std::int32_t mode) {
        const std::size_t g = index(mode);
        Group& group = groups[g];
        if (group.endCell > cellIndex)
            return false;
        updateEnd(g, cellIndex);
        group.rings = group.endCell > cellIndex;
        if (!group.rings)
            noteFaint(g, cellIndex);
        return !group.rings;
    });
}

void SoundingObject::noteFaint(std::size_t g, std::int64_t grid) noexcept {
    const ModalState state = bank.state(g);
    if (state.x == 0 && state.y == 0)
        return;
    const double rate = decayBound(bank.pole(g)) * cellSeconds;
    const double cells = (groups[g].stateLog - std::log(floorVelocity)) / rate;
    faintUntil =
        std::max(faintUntil, grid + static_cast<std::int64_t>(std::min(farAway, cells)) + 1);
}

} // namespace idiophone
