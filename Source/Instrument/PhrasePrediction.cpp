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
    const auto strikeOf = [&](std::size_t note, int velocity) {
        return malletStrike(points[note].point, velocity, phrase.notes[note].key.mallet, parameters,
                            slot());
    };
    const auto trainOf = [&](const Strike& strike, std::size_t note) {
        const auto train = contactTrain(strike, phrase.notes[note].key.mallet.scale,
                                        parameters[chatter], static_cast<std::uint32_t>(firstNote));
        return parameters[modalPulse] != 0 ? withModalPulses(train, modes.span())
                                           : withFilledNulls(train);
    };
    middleNote = (firstNote + endNote) / 2;
    for (std::size_t level = 0; level < levels; ++level) {
        const auto strike = strikeOf(middleNote, velocities[level]);
        trains[level] = trainOf(strike, middleNote);
        pressed[level] = PressedMotion(strike);
        pressedVelocities[level] = {};
        clicks[level] = clickOf(strike);
    }
    clickShares = {};
    const double middleClick =
        std::hypot(clicks[middleVelocity].pascalMetres[0], clicks[middleVelocity].pascalMetres[1]);
    for (std::size_t note = firstNote; note < endNote; ++note) {
        const auto strike = strikeOf(note, velocities[middleVelocity]);
        noteTrains[note] = note == middleNote ? trains[middleVelocity] : trainOf(strike, note);
        const auto click = clickOf(strike);
        if (middleClick > 0)
            clickShares[note] =
                std::hypot(click.pascalMetres[0], click.pascalMetres[1]) / middleClick;
    }
    // Most of a click's energy lies near the maximum of its spectrum, at 0.84/T.
    for (std::size_t level = 0; level < levels; ++level)
        for (std::size_t note = 0; note < PhraseMeter::notes; ++note) {
            const auto& [seconds, pascals] = clicks[level];
            const double amplitude = clickShares[note] * std::hypot(pascals[0], pascals[1]);
            clickEnergies[level][note] =
                amplitude * amplitude / 2 * seconds / 2 * kWeightingPower(0.84 / seconds);
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

/// Adds the energy of a click's interference with a mode Re(A e^{pt}): 2 ∫ P sin Ωt Re(A e^{pt}) dt
/// = 2 P Re(A Ω (1 − e^{pT})/(p² + Ω²)).
void PhrasePrediction::addClick(const RingingMode<levels>& mode, double weighting) noexcept {
    const std::complex<double> pole(-mode.decay, mode.omega);
    for (std::size_t level = 0; level < levels; ++level) {
        const auto& [seconds, pascals] = clicks[level];
        const double omega = 2 * std::numbers::pi / seconds;
        const auto overlap = omega * (1.0 - std::exp(pole * seconds)) /
                             (pole * pole + omega * omega) * mode.velocities[level];
        for (std::size_t note = firstNote; note < endNote; ++note)
            for (std::size_t channel = 0; channel < pascals.size(); ++channel)
                clickEnergies[level][note] += std::sqrt(weighting) * clickShares[note] *
                                              pascals[channel] *
                                              product(overlap, mode.residues[note][channel]).real();
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
        PhraseMeter::NoteFigures energies;
        for (std::size_t note = 0; note < energies.size(); ++note)
            energies[note] = pressed[level].energy(std::abs(pressedVelocities[level][note])) +
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
}

void PhrasePrediction::addMode(RingingMode<levels>& mode, const ModalPole& pole) noexcept {
    const double weighting = kWeightingPower(naturalFrequencyHz(pole));
    if (held) {
        mode.velocities.fill(
            std::sqrt(weighting * force.powerTakenBy(mode.omega, mode.decay, release) / 2));
        stiff.add(std::sqrt(pole.stiffness), mode.residues);
    } else {
        for (std::size_t note = firstNote; note < endNote; ++note)
            if (note != middleNote)
                for (auto& residue : mode.residues[note])
                    residue *=
                        std::abs(ringingVelocity(noteTrains[note], mode.decay, mode.omega)) /
                        std::abs(ringingVelocity(trains[middleVelocity], mode.decay, mode.omega));
        for (std::size_t level = 0; level < levels; ++level) {
            mode.velocities[level] =
                std::sqrt(weighting) * ringingVelocity(trains[level], mode.decay, mode.omega);
            const std::complex<double> velocity =
                pressed[level].velocity(pole.stiffness, mode.omega);
            for (std::size_t note = firstNote; note < endNote; ++note) {
                const auto mean = (mode.residues[note][0] + mode.residues[note][1]) / 2.0;
                pressedVelocities[level][note] += velocity.real() * mean.real() +
                                                  std::complex(0.0, velocity.imag()) * mean.imag();
            }
        }
        addClick(mode, weighting);
    }
    const auto powers = nearModes.add(mode, firstNote, endNote);
    for (std::size_t level = 0; level < levels; ++level)
        meters[level].addMode(held ? PhraseMeter::Note::sustained : PhraseMeter::Note::struck,
                              powers[level], mode.decay, release);
}

} // namespace idiophone
