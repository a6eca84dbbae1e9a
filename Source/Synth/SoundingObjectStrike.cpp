// Strikes and contacts of a sounding object.
#include "Synth/ContactPulse.h"
#include "Synth/Listening.h"
#include "Synth/ModeCompression.h"
#include "Synth/SoundingObject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {

namespace {

constexpr double shortestContactSamples = 1e-3;

bool finite(std::span<const float> values) noexcept {
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

int firstSampleFrom(double time) noexcept {
    return static_cast<int>(std::ceil(time));
}

} // namespace

bool SoundingObject::valid(const Strike& strike, double sampleInCell) const noexcept {
    const auto rows = static_cast<std::int64_t>(object->shapeVertexCount());
    for (std::size_t k = 0; k < strike.point.weights.size(); ++k) {
        const std::int64_t row = strike.point.shapeRows[k];
        if (strike.point.weights[k] != 0 && (row < 0 || row >= rows))
            return false;
    }
    return object->modeCount() > 0 && finite(strike.point.weights) && finite(strike.point.normal) &&
           finite(strike.impulseNewtonSeconds) && std::isfinite(strike.durationSeconds) &&
           strike.durationSeconds >= 0 && sampleInCell >= 0 && sampleInCell < cellSamples;
}

void SoundingObject::computeResidues(const Strike& strike, double gain) noexcept {
    const std::array<double, 3> heard = listeningDirection(strike.point);
    const auto& impulse = strike.impulseNewtonSeconds;
    std::array<const float*, 3> rows{};
    std::array<double, 3> weights{};
    std::size_t used = 0;
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (strike.point.weights[k] != 0) {
            rows[used] = object->shapesAt(index(strike.point.shapeRows[k])).data();
            weights[used++] = strike.point.weights[k];
        }
    for (std::size_t i = 0; i < modeResidues.size(); ++i) {
        double struckGain = 0;
        double heardGain = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double shape = 0;
            for (std::size_t k = 0; k < used; ++k)
                shape += weights[k] * static_cast<double>(rows[k][3 * i + axis]);
            struckGain += shape * static_cast<double>(impulse[axis]);
            heardGain += shape * heard[axis];
        }
        modeResidues[i] = gain * struckGain * heardGain;
    }
    for (std::size_t g = 0; g < groupCount; ++g) {
        const auto first = index(groupStarts[g]);
        const auto count = index(groupStarts[g + 1]) - first;
        groupResidues[g] =
            count == 1 ? modeResidues[first]
                       : mergedResidue(std::span(modeResidues).subspan(first, count),
                                       std::span(object->eigenvalues).subspan(first, count), law);
    }
}

bool SoundingObject::strike(const Strike& asked,
                            double sampleInCell,
                            std::int32_t allowance,
                            std::span<float, cellSamples> cell) noexcept {
    const bool isPulse = asked.durationSeconds * sampleRate >= shortestContactSamples;
    if (!valid(asked, sampleInCell) || (isPulse && contacts.size() == contactCapacity))
        return false;
    if (!ringing() && (groupedLaw != law || groupedCompression != compression))
        regroup();
    const std::int64_t grid = cellIndex + 1;
    audiblePoles.clear();
    for (std::size_t g = 0; g < groupCount; ++g) {
        bringUpToDate(g, grid);
        if (groups[g].audible)
            audiblePoles.push_back(bank.pole(g));
    }
    Contact contact{asked, gainRatio, cellIndex, sampleInCell, 0, 0};
    double& seconds = contact.strike.durationSeconds;
    seconds = isPulse ? contactSecondsClearOfModes(seconds, audiblePoles) : 0;

    computeResidues(asked, gainRatio);
    for (std::size_t g = 0; g < groupCount; ++g) {
        const ModalPole& pole = bank.pole(g);
        Motion kick{groupResidues[g], 0};
        if (isPulse) {
            const Motion forced = ForcedResponse(pole, seconds, damping).motion(1);
            kick = {-groupResidues[g] * forced.velocity, -groupResidues[g] * forced.displacement};
        }
        kicks[g] = stateOf(pole, kick);
    }
    joinStruck(allowance);

    double time = sampleInCell;
    if (isPulse) {
        computeResidues(asked, gainRatio);
        hold(contact, mixedModes);
        const double end = addForced(contact, cell);
        addKicks(time, std::min(end, double(cellSamples)), cell);
        if (end < cellSamples) {
            const double elapsed = (end - time) / sampleRate;
            for (std::size_t g = 0; g < groupCount; ++g) {
                const ModalPole& pole = bank.pole(g);
                const Motion forced = ForcedResponse(pole, seconds, damping).motion(1);
                const ModalState again = stateOf(pole, {groupResidues[g] * forced.velocity,
                                                        groupResidues[g] * forced.displacement});
                const ModalState left = propagator(pole, elapsed) * kicks[g];
                const double factor = std::exp(-damping * elapsed);
                kicks[g] = {factor * left.x + again.x, factor * left.y + again.y};
            }
            time = end;
            addKicks(time, cellSamples, cell);
        } else {
            contacts.push_back(contact);
        }
    } else {
        addKicks(time, cellSamples, cell);
    }
    joinKicks(time);
    return true;
}

void SoundingObject::joinStruck(std::int32_t allowance) noexcept {
    candidates.clear();
    for (std::size_t g = 0; g < groupCount; ++g) {
        amplitudes[g] = amplitudeBound(bank.pole(g), kicks[g]);
        // A mode that the budget left out cannot join a contact under way: its forced part would
        // step. One below τ can.
        const bool free = contacts.empty() || !groups[g].rings;
        if (groups[g].audible && !groups[g].mixed && free && amplitudes[g] > tauVelocity)
            candidates.push_back(static_cast<std::int32_t>(g));
    }
    const auto mixed = static_cast<std::int32_t>(mixedModes.size());
    const auto room = index(std::max(allowance - mixed, 0));
    if (candidates.size() > room) {
        const auto cut = candidates.begin() + static_cast<std::ptrdiff_t>(room);
        std::nth_element(candidates.begin(), cut, candidates.end(),
                         [&](std::int32_t a, std::int32_t b) {
                             const double left = amplitudes[index(a)];
                             const double right = amplitudes[index(b)];
                             return left != right ? left > right : a < b;
                         });
        candidates.erase(cut, candidates.end());
    }
    if (candidates.empty())
        return;
    // What they still carry from before comes back under a fade from the next grid point on.
    leaving.clear();
    for (const std::int32_t g : candidates) {
        groups[index(g)].mixed = true;
        if (bank.amplitude(index(g)) > 0)
            leaving.push_back(g);
    }
    fader.enter(bank, leaving);
    for (Contact& contact : contacts) {
        computeResidues(contact.strike, contact.gainRatio);
        hold(contact, candidates);
    }
    mixedModes.clear();
    for (std::size_t g = 0; g < groupCount; ++g)
        if (groups[g].mixed)
            mixedModes.push_back(static_cast<std::int32_t>(g));
}

void SoundingObject::hold(Contact& contact, std::span<const std::int32_t> modes) noexcept {
    for (const std::int32_t g : modes) {
        const ForcedResponse forced(bank.pole(index(g)), contact.strike.durationSeconds, damping);
        contact.steadyVelocity += groupResidues[index(g)] * forced.steadyVelocity();
        contact.swing += groupResidues[index(g)] * forced.swingVelocity();
    }
}

std::complex<double>
SoundingObject::phaseAt(const Contact& contact, std::int64_t cell, double sample) const noexcept {
    const double cells = static_cast<double>(cell - contact.startCell);
    const double samples = cells * cellSamples + sample - contact.startSample;
    const double turns = samples / (sampleRate * contact.strike.durationSeconds);
    return std::polar(1.0, 2 * std::numbers::pi * turns);
}

void SoundingObject::moveContact(Contact& contact, double sign) noexcept {
    computeResidues(contact.strike, contact.gainRatio);
    const std::complex<double> phase = phaseAt(contact, cellIndex, 0);
    for (const std::int32_t mode : ringingModes) {
        const std::size_t g = index(mode);
        const ModalPole& pole = bank.pole(g);
        const Motion forced =
            ForcedResponse(pole, contact.strike.durationSeconds, damping).motion(phase);
        const double residue = sign * groupResidues[g];
        bank.add(g, stateOf(pole, {residue * forced.velocity, residue * forced.displacement}));
    }
    contact.steadyVelocity = 0;
    contact.swing = 0;
    hold(contact, mixedModes);
}

double SoundingObject::addForced(const Contact& contact,
                                 std::span<float, cellSamples> cell) const noexcept {
    const double cells = static_cast<double>(cellIndex - contact.startCell);
    const double end =
        contact.startSample + contact.strike.durationSeconds * sampleRate - cells * cellSamples;
    const int from = cells > 0 ? 0 : firstSampleFrom(contact.startSample);
    const int until = firstSampleFrom(std::min(end, double(cellSamples)));
    std::complex<double> swing = contact.swing * phaseAt(contact, cellIndex, from);
    const std::complex<double> turn =
        std::polar(1.0, 2 * std::numbers::pi / (sampleRate * contact.strike.durationSeconds));
    for (int k = from; k < until; ++k) {
        cell[index(k)] += static_cast<float>(contact.steadyVelocity + swing.real());
        swing = {swing.real() * turn.real() - swing.imag() * turn.imag(),
                 swing.real() * turn.imag() + swing.imag() * turn.real()};
    }
    return end;
}

void SoundingObject::addKicks(double at,
                              double until,
                              std::span<float, cellSamples> cell) noexcept {
    const int from = firstSampleFrom(at);
    const int end = firstSampleFrom(until);
    if (from >= end)
        return;
    const double wait = (from - at) / sampleRate;
    for (const std::int32_t mode : mixedModes) {
        const std::size_t g = index(mode);
        const ModalState state = wait > 0 ? propagator(bank.pole(g), wait) * kicks[g] : kicks[g];
        kickedStates[2 * g] = state.x;
        kickedStates[2 * g + 1] = state.y;
    }
    std::array<float, cellSamples> sound{};
    bank.renderFrom(kickedStates, mixedModes, sound);
    for (int k = from; k < end; ++k) {
        const double factor = damping > 0 ? std::exp(-damping * (k - at) / sampleRate) : 1;
        cell[index(k)] += static_cast<float>(factor) * sound[index(k - from)];
    }
}

void SoundingObject::joinKicks(double at) noexcept {
    const std::int64_t grid = cellIndex + 1;
    const double wait = (cellSamples - at) / sampleRate;
    const double factor = std::exp(-damping * wait);
    for (std::size_t g = 0; g < groupCount; ++g) {
        const ModalState state = propagator(bank.pole(g), wait) * kicks[g];
        bank.add(g, {factor * state.x, factor * state.y});
        updateEnd(g, grid);
        groups[g].rings = groups[g].mixed || groups[g].endCell > grid;
        if (!groups[g].rings)
            noteFaint(g, grid);
    }
    listRinging();
}

void SoundingObject::soundContacts(std::span<float, cellSamples> cell) noexcept {
    for (std::size_t c = 0; c < contacts.size();) {
        const Contact contact = contacts[c];
        const double end = addForced(contact, cell);
        if (end >= cellSamples) {
            ++c;
            continue;
        }
        contacts.erase(contacts.begin() + static_cast<std::ptrdiff_t>(c));
        computeResidues(contact.strike, contact.gainRatio);
        for (std::size_t g = 0; g < groupCount; ++g) {
            bringUpToDate(g, cellIndex + 1);
            const ModalPole& pole = bank.pole(g);
            const Motion forced =
                ForcedResponse(pole, contact.strike.durationSeconds, damping).motion(1);
            kicks[g] = stateOf(
                pole, {groupResidues[g] * forced.velocity, groupResidues[g] * forced.displacement});
        }
        addKicks(end, cellSamples, cell);
        joinKicks(end);
    }
}

} // namespace idiophone
