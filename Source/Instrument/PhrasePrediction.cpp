#include "Instrument/PhrasePrediction.h"

#include "Instrument/DraggedForce.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/RollCoupling.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double slowestDecay = 1e-3; // [1/s] far slower than the phrase

std::complex<double> quotient(std::complex<double> a, std::complex<double> b) noexcept {
    return product(a, std::conj(b)) / std::norm(b);
}

} // namespace

PhrasePrediction::Loudness
predictedLoudness(const Phrase& phrase, const ParameterValues& values, int wheel) noexcept {
    return PhrasePrediction(phrase, values, wheel).lufs();
}

PhrasePrediction::PhrasePrediction(const Phrase& played,
                                   const ParameterValues& values,
                                   int wheelPosition) noexcept
    : phrase(played), presetValues(values), parameters(values), wheel(wheelPosition) {
    while (beginObject()) {
        addModes();
        endObject();
    }
}

PhrasePrediction::Loudness PhrasePrediction::lufs() const noexcept {
    Loudness result{};
    for (std::size_t level = 0; level < levels; ++level)
        result[level] = meters[level].integratedLufs();
    return result;
}

const SynthesiserSlot& PhrasePrediction::slot() const noexcept {
    return phrase.instrument->slots()[static_cast<std::size_t>(phrase.notes[firstNote].key.slot)];
}

const LowestModes& PhrasePrediction::lowestModes() const noexcept {
    return phrase.instrument->lowestModes(
        static_cast<std::size_t>(phrase.notes[firstNote].key.slot));
}

/// Begins the next object, with the consecutive notes that play it. Returns false after the last.
bool PhrasePrediction::beginObject() noexcept {
    const auto& notes = phrase.notes;
    firstNote = endNote;
    while (firstNote < notes.size() && notes[firstNote].key.slot < 0)
        ++firstNote;
    if (firstNote == notes.size())
        return false;
    endNote = firstNote + 1;
    while (endNote < notes.size() && notes[endNote].key.slot == notes[firstNote].key.slot)
        ++endNote;
    const auto* part = notes[firstNote].key.part;
    parameters = part != nullptr ? withPart(presetValues, *part) : presetValues;
    const auto settings = synthesisSettings(parameters);
    hearing = SlotHearing(slot(), settings);
    // If several notes share the object, the next key holds it, so that it rings on.
    const bool rings = parameters[letRing] != 0 || endNote - firstNote > 1;
    release = rings ? 0 : decayPerSecond(parameters[releaseTime]);
    nearModes = {};
    held = !strikes(parameters);
    if (held)
        beginForce(settings);
    else
        beginStrikes();
    return true;
}

void PhrasePrediction::beginStrikes() noexcept {
    for (std::size_t note = firstNote; note < endNote; ++note) {
        const auto& noteKey = phrase.notes[note].key;
        const auto place = aimedPlace(noteKey.along, parameters);
        auto& [point, push] = points[note];
        point = noteKey.strip->between(place.along, place.across).point;
        push = listeningDirection(point);
    }
    const auto modes = lowestModes()
                           .atThickness(hearing.thicknessRatio)
                           .moved(hearing.conditions.frequencyRatio());
    for (std::size_t note = firstNote; note < endNote; ++note)
        for (std::size_t level = 0; level < levels; ++level) {
            const auto& mallet = phrase.notes[note].key.mallet;
            const auto strike =
                malletStrike(points[note].point, velocities[level], mallet, parameters, slot());
            const auto train = contactTrain(strike, mallet.scale, parameters[chatter],
                                            static_cast<std::uint32_t>(note));
            trains[level][note] =
                asPlayed(parameters[modalPulse] != 0 ? withModalPulses(train, modes.span())
                                                     : withFilledNulls(train),
                         phrase.sampleRateHz);
            pressed[level][note] = PressedMotion(strike, phrase.sampleRateHz);
            const auto& [seconds, pascals] = clicks[level][note] = clickOf(strike);
            pressedVelocities[level][note] = 0;
            impulsesDuringClick[level][note] =
                seconds < 1.3 * strike.durationSeconds ? impulseOf(strike) : 0;
            // Most of a click's energy lies near the maximum of its spectrum, at 0.84/T.
            clickEnergies[level][note] = (pascals[0] * pascals[0] + pascals[1] * pascals[1]) / 4 *
                                         seconds * kWeightingPower(0.84 / seconds);
        }
}

RigidClick PhrasePrediction::clickOf(const Strike& strike) const noexcept {
    const auto& body = phrase.notes[firstNote].rigidBody;
    const auto& conditions = hearing.conditions;
    if (!(hearing.farShare > 0) || !(body.massKg > 0))
        return {};
    const double size = conditions.radiationGainRatio / conditions.gainRatio;
    const auto& directions = slot().object->radiation.directions;
    const std::size_t right = std::min<std::size_t>(directions.size(), 2) - 1;
    auto click = rigidClick(body, strike.impulseNewtonSeconds, strike.durationSeconds, size,
                            phrase.sampleRateHz, {directions[0], directions[right]});
    for (double& channel : click.pascalMetres)
        channel *= hearing.farShare * conditions.radiationGainRatio * size * size;
    return click;
}

/// Adds the energy of the clicks' interference with a mode: 2 ∫ P sin Ωt v(t) dt. If the mode rings
/// from the start, v = Re(A e^{pt}) gives ∫ sin Ωt e^{pt} dt = Ω (1 − e^{pT})/(p² + Ω²) = E. If the
/// force (J/T)(1 − cos Ωt) acts as long as the click, v is its response, and the integral J (E
/// Ω²/(T p (p² + Ω²)) − Ω/(2 (p² + Ω²))).
void PhrasePrediction::addClick(const RingingMode<levels>& mode, double weighting) noexcept {
    constexpr double beyond = 4; // Ω: the free motion e^{pT} of many modes cancels out
    const std::complex<double> pole(-mode.decay, mode.omega);
    const auto square = product(pole, pole);
    for (std::size_t level = 0; level < levels; ++level)
        for (std::size_t note = firstNote; note < endNote; ++note) {
            const auto& [seconds, pascals] = clicks[level][note];
            if (pascals[0] == 0 && pascals[1] == 0)
                continue;
            const double omega = 2 * std::numbers::pi / seconds;
            const auto inverse = quotient(omega, square + omega * omega);
            const auto freed = mode.omega < beyond * omega ? std::exp(pole * seconds) : 0.0;
            auto overlap = product(inverse, 1.0 - freed);
            if (const double impulse = impulsesDuringClick[level][note]; impulse > 0)
                overlap = impulse *
                          (weighting * product(overlap, quotient(inverse, pole)) * omega / seconds -
                           kWeightingPower(0.84 / seconds) * inverse / 2.0);
            else
                overlap = std::sqrt(weighting) * product(overlap, mode.velocities[level][note]);
            for (std::size_t channel = 0; channel < pascals.size(); ++channel)
                clickEnergies[level][note] +=
                    pascals[channel] * product(overlap, mode.residues[note][channel]).real();
        }
}

void PhrasePrediction::beginForce(const SynthesisSettings& settings) noexcept {
    const double friction = contactMaterial(parameters, slot().object->material).friction;
    for (std::size_t note = firstNote; note < endNote; ++note) {
        const auto& noteKey = phrase.notes[note].key;
        const auto aimed = aimedPlace(noteKey.along, parameters);
        const auto place = noteKey.strip->between(aimed.along, aimed.across);
        points[note] = {place.point,
                        draggedForce(place.point, place.direction, friction).direction};
        for (float& component : points[note].push)
            component *= static_cast<float>(forceScale(noteKey.mallet));
    }
    const bool rolls = static_cast<int>(parameters[contact]) == rollContact;
    const ContactForceSettings kind{.kind = rolls ? ContactKind::roll : ContactKind::scrape,
                                    .rollModalCoupling =
                                        rolls ? parameters[rollCoupling] / 100 : 0};
    const double speed = parameters[contactSpeed] * wheel / 127.0;
    const auto coupled = coupledModes(lowestModes(), slot(), settings);
    force = HeldForceSpectrum(phrase.surface, speed, kind, coupled.span(), phrase.sampleRateHz);
    stiff = StiffMotion(phrase.sampleRateHz);
}

void PhrasePrediction::endObject() noexcept {
    if (held) {
        for (auto& meter : meters)
            meter.addSteady(stiff.powers(force));
        return;
    }
    for (std::size_t level = 0; level < levels; ++level) {
        PhraseMeter::NoteFigures energies{};
        for (std::size_t note = firstNote; note < endNote; ++note)
            energies[note] = pressed[level][note].energy(std::abs(pressedVelocities[level][note])) +
                             clickEnergies[level][note];
        meters[level].addTransients(energies);
    }
}

void PhrasePrediction::addModes() noexcept {
    forEachHeardMode<PhraseMeter::notes>(
        *slot().object, hearing, std::span(points).subspan(firstNote, endNote - firstNote),
        phrase.sampleRateHz, [&](const ModalPole& pole, const auto& residues) {
            RingingMode<levels> mode{.omega = dampedFrequency(pole),
                                     .decay = std::max(pole.damping / 2, slowestDecay)};
            std::copy_n(residues.begin(), endNote - firstNote, mode.residues.begin() + firstNote);
            addMode(mode, pole);
        });
    nearModes.takeAll(meterOf());
}

void PhrasePrediction::addMode(RingingMode<levels>& mode, const ModalPole& pole) noexcept {
    const double weighting = kWeightingPower(naturalFrequencyHz(pole));
    if (held) {
        const double velocity =
            std::sqrt(weighting * force.powerTakenBy(mode.omega, mode.decay, release) / 2);
        for (auto& ofNotes : mode.velocities)
            ofNotes.fill(velocity);
        stiff.add(std::sqrt(pole.stiffness), mode.residues);
    } else {
        for (std::size_t level = 0; level < levels; ++level)
            for (std::size_t note = firstNote; note < endNote; ++note) {
                const auto& [left, right] = mode.residues[note];
                const auto& press = pressed[level][note];
                pressedVelocities[level][note] += press.velocity(pole, (left + right) / 2.0);
                if (!press.holds(pole))
                    mode.velocities[level][note] =
                        std::sqrt(weighting) *
                        ringingVelocity(trains[level][note], mode.decay, mode.omega);
            }
        addClick(mode, weighting);
    }
    nearModes.add(mode, firstNote, endNote, meterOf());
}

} // namespace idiophone
