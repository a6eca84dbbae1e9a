// Strikes and contacts of a resonator.
#include "Synth/AllFinite.h"
#include "Synth/ContactPulse.h"
#include "Synth/ModalResonator.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone {

namespace {

/// Within the band shorter contacts equal impulses, and their force would alias.
constexpr double shortestContactSamples = 2;

int firstSampleFrom(double time) noexcept {
    return static_cast<int>(std::ceil(time));
}

} // namespace

bool ModalResonator::valid(const StrikePoint& point) const noexcept {
    const auto rows = static_cast<std::int64_t>(object->shapeVertexCount());
    for (std::size_t k = 0; k < point.weights.size(); ++k) {
        const std::int64_t row = point.shapeRows[k];
        if (point.weights[k] != 0 && (row < 0 || row >= rows))
            return false;
    }
    const auto directions = static_cast<std::int64_t>(object->radiation.directions.size());
    if (point.radiationDirection < -1 || point.radiationDirection >= directions)
        return false;
    return object->modeCount() > 0 && allFinite(point.weights) && allFinite(point.normal);
}

bool ModalResonator::valid(const Strike& strike, double sampleInCell) const noexcept {
    return valid(strike.point) && allFinite(strike.impulseNewtonSeconds) &&
           std::isfinite(strike.durationSeconds) && strike.durationSeconds >= 0 &&
           sampleInCell >= 0 && sampleInCell < cellSamples;
}

/// Updates groups and poles to the settings. A silent resonator starts again in one channel.
void ModalResonator::prepareBank() noexcept {
    if (silent())
        bank.setChannels(1);
    if (polesBehind)
        movePoles();
}

/// Opens the second channel at the first strike that is heard far.
void ModalResonator::widen(double farShare) noexcept {
    if (!(farShare > 0) || outputChannels == 1 || bank.channels() == maximumChannels)
        return;
    bank.setChannels(maximumChannels);
    ++responseVersion;
    fader.widen();
    for (Contact& contact : contacts)
        for (ForcedMotion* motion : {&contact.mixed, &contact.tube}) {
            motion->steadyVelocity[1] = motion->steadyVelocity[0];
            motion->swing[1] = motion->swing[0];
        }
}

bool ModalResonator::computeForced(const Contact& contact) noexcept {
    const bool reasonable = computeResidues(contact);
    scratch.contact.setForced(bank.poles(), {.contactSeconds = contact.strike.durationSeconds,
                                             .dampingPerSecond = damping});
    return reasonable;
}

bool ModalResonator::strike(const Strike& asked,
                            double sampleInCell,
                            std::int32_t allowance,
                            const CellOutput& cell) noexcept {
    const bool isPulse = asked.durationSeconds * sampleRate >= shortestContactSamples;
    if (!valid(asked, sampleInCell) || (isPulse && contacts.size() == contactCapacity))
        return false;
    takeInIncrements(cellIndex + 1);
    prepareBank();
    Contact contact{
        .strike = asked, .heard = listening, .startCell = cellIndex, .startSample = sampleInCell};
    widen(listening.farShare);
    double& seconds = contact.strike.durationSeconds;
    seconds = isPulse ? contactSecondsClearOf(bank.poles().resonances(), seconds) : 0;

    if (!(isPulse ? computeForced(contact) : computeResidues(contact)))
        return false;
    if (isPulse) {
        startIncrements(-1, sampleInCell);
    } else {
        scratch.contact.setImpulse(bank.poles());
        startIncrements(1, sampleInCell);
    }
    joinStruck(allowance);
    if (isPulse && !contacts.empty())
        computeForced(contact); // joinStruck used the scratch for the other contacts

    int from = firstSampleFrom(sampleInCell);
    if (isPulse) {
        hold(contact, mixedRuns, 1);
        const double end = addForced(contact, cell);
        if (end <= cellSamples) {
            addIncrements(from, firstSampleFrom(end), cell);
            finishIncrements(contact, end);
            from = firstSampleFrom(end);
        } else {
            contacts.push_back(contact);
        }
    }
    addIncrements(from, cellSamples, cell);
    keepIncrements(from);
    addClick(contact, cell);
    return true;
}

/// Starts the click of the rigid body, which is only heard far.
void ModalResonator::addClick(const Contact& struck, const CellOutput& cell) noexcept {
    if (!(struck.heard.farShare > 0) || !(rigidBody.massKg > 0) || clicks.size() == contactCapacity)
        return;
    Contact click = struck;
    const auto& directions = object->radiation.directions;
    const std::int32_t from = click.strike.point.radiationDirection;
    const std::size_t left = from < 0 ? 0 : static_cast<std::size_t>(from);
    const std::size_t right = from < 0 ? std::min(directions.size(), maximumChannels) - 1 : left;
    auto [seconds, pascals] =
        rigidClick(rigidBody, click.strike.impulseNewtonSeconds, click.strike.durationSeconds,
                   sizeNow, sampleRate, {directions[left], directions[right]});
    click.strike.durationSeconds = seconds;
    for (double& channel : pascals) // farGain is proportional to 1/size²
        channel *= struck.heard.farShare * struck.heard.farGain * sizeNow * sizeNow;
    if (outputChannels == 1)
        pascals[0] = (pascals[0] + pascals[1]) / 2;
    click.mixed = {};
    click.tube = {};
    for (std::size_t c = 0; c < maximumChannels; ++c) {
        if (!(std::abs(pascals[c]) <= static_cast<double>(largestResidue)))
            return;
        click.mixed.swing[c] = {0, -pascals[c]}; // Re(−i P e^{iΩt}) = P sin Ωt
    }
    if (addForced(click, cell) > cellSamples)
        clicks.push_back(click);
}

void ModalResonator::soundClicks(const CellOutput& cell) noexcept {
    std::erase_if(clicks,
                  [&](const Contact& click) { return addForced(click, cell) <= cellSamples; });
}

BeforeSample ModalResonator::beforeSample(double at) const noexcept {
    const double samples = firstSampleFrom(at) - at;
    return {samples, damping > 0 ? std::exp(-damping * samples / sampleRate) : 1};
}

IncrementMove ModalResonator::incrementMove(double seconds) const noexcept {
    return {seconds, seconds * sampleRate, damping * seconds * std::numbers::log2e};
}

/// Sets the increments to the contact's states, which hold at time `at`, moved to the next whole
/// sample.
void ModalResonator::startIncrements(double sign, double at) noexcept {
    const BeforeSample before = beforeSample(at);
    increments.start(bank, scratch.contact, scratch.groupResidues,
                     {before.samples, sign * before.factor});
}

/// Sets the increments of a contact that started in this cell and ended at `end`, moved to the next
/// whole sample.
void ModalResonator::finishIncrements(const Contact& contact, double end) noexcept {
    increments.finish(bank, scratch.contact, scratch.groupResidues, beforeSample(end),
                      incrementMove(contact.strike.durationSeconds));
}

void ModalResonator::joinStruck(std::int32_t allowance) noexcept {
    if (allMixed())
        return;
    surveyEnergies(increments.energies.data(), bank.poles().audibleWeights(), tauEnergy(), 0,
                   bank.allBlocks(), scratch.wanted.data());
    admitWanted(allowance);
}

/// Mixes the wanted modes. If the allowance is too small for all, takes those with the largest
/// increments.
void ModalResonator::admitWanted(std::int32_t allowance) noexcept {
    // A ringing mode that the budget left out cannot join a contact under way, as its forced part
    // would step. A mode below τ can.
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        const unsigned barred = blocks[b].mixed | (contacts.empty() ? 0u : blocks[b].rings);
        scratch.wanted[b] = static_cast<std::uint16_t>(scratch.wanted[b] & ~barred);
    }
    const auto mixed = static_cast<std::int32_t>(mixedModes.size());
    listWanted(static_cast<std::size_t>(std::max(allowance - mixed, 0)));
    if (scratch.joining.empty())
        return;
    scratch.leaving.clear();
    for (const std::int32_t mode : scratch.joining)
        admit(static_cast<std::size_t>(mode));
    // Modes that the budget had left out fade in from the next grid point on.
    fade(scratch.leaving, -1);
    findRuns(scratch.joining, scratch.joiningRuns);
    for (Contact& contact : contacts) {
        computeForced(contact);
        hold(contact, scratch.joiningRuns, 1);
    }
    listMixed();
    mixedIsRinging = false;
}

/// Lists the wanted modes in ascending order, at most the loudest `most` of them.
void ModalResonator::listWanted(std::size_t most) noexcept {
    scratch.joining.clear();
    for (std::size_t b = 0; b < bank.blockCount(); ++b)
        forEachMode(b, scratch.wanted[b], [&](std::int32_t g) { scratch.joining.push_back(g); });
    if (scratch.joining.size() <= most)
        return;
    keepLoudest(scratch.joining, increments.energies.data(), most);
    std::sort(scratch.joining.begin(), scratch.joining.end());
}

/// Mixes a struck mode. Earlier motion that τ had cut stays cut.
void ModalResonator::admit(std::size_t g) noexcept {
    const std::size_t b = g / modeBlock;
    const auto bit = static_cast<std::uint16_t>(1u << (g % modeBlock));
    if (!blocks[b].active) {
        bringUpToDate(b, cellIndex + 1);
        activate(b);
    }
    if ((blocks[b].rings & bit) != 0)
        scratch.leaving.push_back(static_cast<std::int32_t>(g));
    else
        bank.silence(g);
    blocks[b].rings |= bit;
    blocks[b].mixed |= bit;
}

double ModalResonator::addForced(const Contact& contact, const CellOutput& cell) const noexcept {
    const double cells = static_cast<double>(cellIndex - contact.startCell);
    const double end =
        contact.startSample + contact.strike.durationSeconds * sampleRate - cells * cellSamples;
    const int from = cells > 0 ? 0 : firstSampleFrom(contact.startSample);
    const int until = firstSampleFrom(std::min(end, double(cellSamples)));
    if (from >= until)
        return end;
    const auto first = static_cast<std::size_t>(from);
    const auto samples = static_cast<std::size_t>(until - from);
    alignas(64) CellSound sound;
    soundForced(contact, contact.mixed, from, samples, sound);
    addToCell(outputsOf(sound), first, samples, cell);
    if (tubesPulse()) {
        soundForced(contact, contact.tube, from, samples, sound);
        closeTubes(sound, first, samples, cell);
    }
    return end;
}

void ModalResonator::soundForced(const Contact& contact,
                                 const ForcedMotion& motion,
                                 int from,
                                 std::size_t samples,
                                 CellSound& sound) const noexcept {
    const std::complex<double> phase = phaseAt(contact, cellIndex, from);
    const double radians = 2 * std::numbers::pi / (sampleRate * contact.strike.durationSeconds);
    for (std::size_t c = 0; c < bank.channels(); ++c)
        raisedCosine(motion.steadyVelocity[c], motion.swing[c] * phase, radians, samples,
                     sound[c].data());
}

/// Adds the sound of the increments, which hold at sample `from`, up to `until`.
void ModalResonator::addIncrements(int from, int until, const CellOutput& cell) noexcept {
    if (from >= until)
        return;
    const auto first = static_cast<std::size_t>(from);
    const auto samples = static_cast<std::size_t>(until - from);
    alignas(64) CellSound sound;
    for (std::size_t c = 0; c < bank.channels(); ++c)
        sound[c].fill(0);
    const bool pulses = tubesPulse();
    const ChannelOutputs tube = outputsOf(scratch.tubeSound);
    if (pulses)
        scratch.tubeSound = {};
    increments.sound(bank, mixedRuns, (samples + subBlockSamples - 1) / subBlockSamples,
                     outputsOf(sound), pulsing(), tube);
    if (damping > 0)
        fadeByDamper(outputsOf(sound), samples);
    if (damping > 0 && pulses)
        fadeByDamper(tube, samples);
    addToCell(outputsOf(sound), first, samples, cell);
    if (pulses)
        closeTubes(scratch.tubeSound, first, samples, cell);
}

/// Keeps the increments, which hold at sample `from`, until the next grid point. Joining them at
/// once would make cells with many strikes too slow.
void ModalResonator::keepIncrements(int from) noexcept {
    keptIncrements = incrementMove((cellSamples - from) / sampleRate);
}

/// Adds pending increments to the states, which hold at `grid`, the end of their cell.
void ModalResonator::takeInIncrements(std::int64_t grid) noexcept {
    if (!keptIncrements)
        return;
    bringRestingUpToDate(grid);
    bank.join(increments, *keptIncrements);
    keptIncrements.reset();
    if (!allMixed())
        listWhatRings();
}

/// Call it before adding to the states at a grid point.
void ModalResonator::bringRestingUpToDate(std::int64_t grid) noexcept {
    for (std::size_t b = 0; b < bank.blockCount(); ++b)
        if (!blocks[b].active && !bringUpToDate(b, grid)) {
            blocks[b].restsSince = grid;
            blocks[b].restsAtDampingLog = dampingLog(grid);
        }
}

/// Call it after adding to the states.
void ModalResonator::listWhatRings() noexcept {
    surveyEnergies(bank.energies(), bank.poles().audibleWeights(), tauEnergy(), 0, bank.allBlocks(),
                   scratch.aboveTau.data());
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        blocks[b].rings = scratch.aboveTau[b] | blocks[b].mixed;
        if (blocks[b].rings != 0)
            activate(b);
    }
    mixedIsRinging = false;
}

void ModalResonator::soundContacts(const CellOutput& cell) noexcept {
    for (std::size_t c = 0; c < contacts.size();) {
        const Contact contact = contacts[c];
        const double end = addForced(contact, cell);
        if (end >= cellSamples) {
            ++c;
            continue;
        }
        contacts.erase(contacts.begin() + static_cast<std::ptrdiff_t>(c));
        takeInIncrements(cellIndex + 1);
        computeForced(contact);
        startIncrements(1, end);
        addIncrements(firstSampleFrom(end), cellSamples, cell);
        keepIncrements(firstSampleFrom(end));
    }
}

} // namespace idiophone
