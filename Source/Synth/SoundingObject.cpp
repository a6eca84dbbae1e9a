#include "Synth/SoundingObject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace idiophone {

namespace {

/// [M] mean over the vertices of |φ_i|².
std::vector<double> meanSquareShapes(const ModalObject& object) {
    std::vector<double> weights(object.modeCount());
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
        const auto shapes = object.shapesAt(row);
        for (std::size_t k = 0; k < shapes.size(); ++k)
            weights[k / 3] += static_cast<double>(shapes[k]) * static_cast<double>(shapes[k]);
    }
    return weights;
}

} // namespace

SoundingObject::SoundingObject(std::shared_ptr<const ModalObject> modalObject,
                               double sizeRatio,
                               double sampleRateHz)
    : object(modalObject ? std::move(modalObject) : std::make_shared<const ModalObject>()),
      slotSizeRatio(sizeRatio), sampleRate(sampleRateHz), cellSeconds(cellSamples / sampleRateHz),
      modeWeights(meanSquareShapes(*object)), bank(object->modeCount(), sampleRateHz),
      fader(object->modeCount(), sampleRateHz) {
    const std::size_t modes = object->modeCount();
    groupStarts.resize(modes + 1);
    groups.resize(modes);
    amplitudes.resize(modes);
    modeResidues.resize(modes);
    groupResidues.resize(modes);
    kicks.resize(modes);
    kickedStates.resize(2 * modes);
    audiblePoles.reserve(modes);
    for (auto* list : {&ringingModes, &mixedModes, &candidates, &joining, &leaving})
        list->reserve(modes);
    contacts.reserve(contactCapacity);
    applySettings({});
    regroup();
}

void SoundingObject::setDamping(double dampingPerSecond) noexcept {
    if (!(dampingPerSecond >= 0) || !std::isfinite(dampingPerSecond) ||
        dampingPerSecond == requestedDamping)
        return;
    requestedDamping = dampingPerSecond;
    controlsChanged = true;
}

void SoundingObject::setFrequencyRatio(double newRatio) noexcept {
    if (!(newRatio > 0) || !std::isfinite(newRatio) || newRatio == requestedFrequencyRatio)
        return;
    requestedFrequencyRatio = newRatio;
    controlsChanged = true;
}

bool SoundingObject::beginCell(std::int64_t cell,
                               const SynthesisSettings& settings,
                               bool settingsChanged) noexcept {
    cellIndex = cell;
    if (settingsChanged || controlsChanged)
        applySettings(settings);
    if (silent() && mixedModes.empty())
        return false;
    if (contacts.empty())
        dropEnded();
    measure();
    return true;
}

void SoundingObject::measure() noexcept {
    demanded = {};
    for (const std::int32_t g : ringingModes) {
        if (!groups[index(g)].audible)
            continue;
        amplitudes[index(g)] = bank.amplitude(index(g));
        demanded.amplitude += amplitudes[index(g)];
        ++demanded.modes;
    }
}

void SoundingObject::chooseModes(std::int32_t share) noexcept {
    candidates.clear();
    for (const std::int32_t g : ringingModes)
        if (groups[index(g)].audible)
            candidates.push_back(g);
    if (const auto most = index(std::max(share, 0)); candidates.size() > most) {
        const auto cut = candidates.begin() + static_cast<std::ptrdiff_t>(most);
        std::nth_element(candidates.begin(), cut, candidates.end(),
                         [&](std::int32_t a, std::int32_t b) {
                             const double left = amplitudes[index(a)];
                             const double right = amplitudes[index(b)];
                             return left != right ? left > right : a < b;
                         });
        candidates.erase(cut, candidates.end());
        std::sort(candidates.begin(), candidates.end());
    }
    leaving.clear();
    joining.clear();
    std::set_difference(mixedModes.begin(), mixedModes.end(), candidates.begin(), candidates.end(),
                        std::back_inserter(leaving));
    std::set_difference(candidates.begin(), candidates.end(), mixedModes.begin(), mixedModes.end(),
                        std::back_inserter(joining));
    for (const std::int32_t g : leaving)
        groups[index(g)].mixed = false;
    for (const std::int32_t g : joining)
        groups[index(g)].mixed = true;
    fader.leave(bank, leaving);
    fader.enter(bank, joining);
    std::swap(mixedModes, candidates);
}

void SoundingObject::mix(std::int32_t share, std::span<float, cellSamples> cell) noexcept {
    if (contacts.empty())
        chooseModes(share);
    mixedLastCell = static_cast<std::int32_t>(mixedModes.size());

    std::array<float, cellSamples> sound{};
    bank.render(mixedModes, sound);
    for (const std::int32_t g : ringingModes)
        if (!groups[index(g)].mixed)
            bank.advanceCell(index(g));
    fader.addCell(sound);
    if (damping > 0) {
        const double fall = std::exp(-damping / sampleRate);
        double factor = 1;
        for (float& sample : sound) {
            sample *= static_cast<float>(factor);
            factor *= fall;
        }
        for (const std::int32_t g : ringingModes)
            bank.scale(index(g), factor);
        fader.scale(static_cast<float>(factor));
    }
    for (std::size_t k = 0; k < cell.size(); ++k)
        cell[k] += sound[k];
    soundContacts(cell);
}

void SoundingObject::reset() noexcept {
    for (std::size_t g = 0; g < groupCount; ++g) {
        bank.setState(g, {});
        groups[g].rings = false;
        groups[g].mixed = false;
    }
    ringingModes.clear();
    mixedModes.clear();
    contacts.clear();
    fader.reset();
    faintUntil = 0;
    demanded = {};
    mixedLastCell = 0;
}

} // namespace idiophone
