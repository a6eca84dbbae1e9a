#include "Instrument/LoudnessMatch.h"

#include "Instrument/ContactTrain.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/SettingsOfParameters.h"
#include "Synth/Listening.h"
#include "Synth/ModalPole.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;
using NoteFigures = PhraseMeter::NoteFigures;

constexpr int phraseVelocity = 100;
constexpr double largestGainDb = 40;
constexpr double decibels60 = 6.907755278982137; // ln(1000)
constexpr double lowestHz = 20;
constexpr double highestShareOfSampleRate = 0.49;
constexpr double slowestDecay = 1e-3; // [1/s] far slower than the phrase

/// What the settings make of an object (SynthesisSettings.h).
struct Conditions {
    PoleLaw law;
    double gainRatio;      ///< 1/mass ratio
    double radiationRatio; ///< RadiationTable.h
    double listening;      ///< 0 where struck, 1 from afar

    Conditions(const SynthesiserSlot& slot, const SynthesisSettings& settings) {
        const Material& own = slot.object->material;
        const auto material = settings.material.value_or(
            LiveMaterial{own.youngsModulusPa, own.densityKgPerM3, own.fluidDampingPerSecond,
                         own.viscoelasticDampingSeconds});
        const double size = slot.sizeRatio * settings.sizeRatio;
        const double density = material.densityKgPerM3 / own.densityKgPerM3;
        const double tuning = settings.frequencyRatio / size;
        law = {material.youngsModulusPa / own.youngsModulusPa / density * tuning * tuning,
               material.fluidDampingPerSecond, material.viscoelasticDampingSeconds};
        gainRatio = 1 / (density * size * size * size);
        radiationRatio = std::sqrt(law.eigenvalueRatio) * size;
        listening = slot.object->radiation.empty() ? 0 : settings.radiation;
    }
};

/// What RadiationTable::weightsAt gives, mode by mode: no place for all modes is needed.
class ModeRadiation {
public:
    ModeRadiation(const ModalObject& object, double frequencyRatio)
        : table(object.radiation), modes(object.modeCount()) {
        const auto& ratios = table.frequencyRatios;
        if (ratios.empty())
            return;
        const auto above = std::ranges::upper_bound(ratios, frequencyRatio) - ratios.begin();
        upper = std::min(static_cast<std::size_t>(above), ratios.size() - 1);
        lower = above == 0 ? 0 : static_cast<std::size_t>(above) - 1;
        if (lower < upper)
            share =
                std::log(frequencyRatio / ratios[lower]) / std::log(ratios[upper] / ratios[lower]);
    }

    double weight(std::size_t channel, std::size_t mode) const noexcept {
        const auto direction = std::min(channel, table.directions.size() - 1);
        const auto* rows = &table.weights[direction * table.frequencyRatios.size() * modes + mode];
        const double from = rows[lower * modes], to = rows[upper * modes];
        return from + share * (to - from);
    }

private:
    const RadiationTable& table;
    std::size_t modes;
    std::size_t lower = 0, upper = 0;
    double share = 0;
};

double impulseOf(const Strike& strike) noexcept {
    const auto& impulse = strike.impulseNewtonSeconds;
    return std::hypot(impulse[0], impulse[1], impulse[2]);
}

/// The velocity with which a mode of residue 1 rings after a blow. A raised cosine
/// (I/T)(1 − cos Ωt) leaves, at its end, I (e^x − 1) 4π²/(x (x² + 4π²)), x = pT, at the pole p.
std::complex<double> ringingVelocity(const ContactTrain& train, double decay, double omega) {
    constexpr double fullTurnSquared = 4 * std::numbers::pi * std::numbers::pi;
    std::complex<double> sum = 0;
    for (const auto& contact : train) {
        const double seconds = contact.strike.durationSeconds;
        const std::complex<double> x(-decay * seconds, omega * seconds);
        const auto pulse = (std::exp(x) - 1.0) * fullTurnSquared / (x * (x * x + fullTurnSquared));
        sum += impulseOf(contact.strike) * pulse *
               std::polar(1.0, -omega * (contact.delaySeconds + seconds));
    }
    return sum;
}

/// The same, in no unit, for the force that a surface scraped at a share of its reference speed
/// exerts: the square root of its power spectrum, ω^β through the reson (SurfaceProfile.h).
double scrapedVelocity(const Surface& surface, double speedRatio, double omega) noexcept {
    const double frequency = omega / speedRatio;
    const double reson = 2 * std::numbers::pi * surface.resonFrequencyHz;
    const double damping = surface.resonDampingPerSecond;
    const double natural = reson * reson + damping * damping;
    const double answer =
        natural / std::hypot(natural - frequency * frequency, 2 * damping * frequency);
    return answer * std::pow(frequency, surface.spectrumExponent / 2);
}

/// The motion while a long contact lasts, which is all there is where the pulse has a null at the
/// lowest mode: stiff modes follow its force, in v = Σ r (I/T) Ω/(λ − Ω²) · sin Ωt.
class PressedMotion {
public:
    explicit PressedMotion(const Strike& strike)
        : seconds(strike.durationSeconds), omega(2 * std::numbers::pi / strike.durationSeconds),
          forceRate(impulseOf(strike) / seconds * omega) {}

    /// Per residue. What is less stiff rings on, and louder.
    double velocity(double stiffness) const noexcept {
        constexpr double stiffEnough = 1.7; // from 1.3/T on; by comparison with renders
        const double square = omega * omega;
        return stiffness > stiffEnough * square ? forceRate / (stiffness - square) : 0;
    }
    double energy(double amplitude) const noexcept {
        return amplitude * amplitude / 2 * seconds * kWeightingPower(1 / seconds);
    }

private:
    double seconds;
    double omega;
    double forceRate;
};

/// Residues of a mode for the strike of each note, left and right.
using NoteResidues = std::array<std::array<double, 2>, PhraseMeter::notes>;

/// A mode that rings.
struct RingingMode {
    double omega = 0;
    double decay = 0;
    std::complex<double> velocity{}; ///< K-weighted, for a residue of 1
    NoteResidues residues{};
};

/// The last few modes, with which the next one interferes: ∫ v_i v_j dt = A_i A_j a/(a² + Δ²)/2,
/// a = α_i + α_j, Δ = ω_i − ω_j, counts where they are close to one another, as the pairs of round
/// objects and all modes of soft ones are.
class NearModes {
public:
    /// The power that makes the mode's own decay carry its energy and that of its interference with
    /// those before it.
    NoteFigures add(const RingingMode& mode, std::size_t firstNote, std::size_t endNote) noexcept {
        NoteFigures powers{};
        const auto interfere = [&](const RingingMode& other, double share) {
            const double both =
                share * (mode.velocity * std::conj(other.velocity)).real() / 4; // two channels
            for (std::size_t note = firstNote; note < endNote; ++note)
                powers[note] += both * (mode.residues[note][0] * other.residues[note][0] +
                                        mode.residues[note][1] * other.residues[note][1]);
        };
        interfere(mode, 1);
        for (std::size_t back = 1; back <= std::min(count, recent.size()); ++back) {
            const auto& other = recent[(count - back) % recent.size()];
            const double width = mode.decay + other.decay;
            const double distance = mode.omega - other.omega;
            if (distance > farthest * width)
                break;
            interfere(other, 4 * mode.decay * width / (width * width + distance * distance));
        }
        recent[count++ % recent.size()] = mode;
        return powers;
    }

private:
    static constexpr double farthest = 10; // of 1 % of the energy
    std::array<RingingMode, 6> recent;
    std::size_t count = 0;
};

/// φ·n of a mode at a point, along which it is both struck and heard.
double shapeAlongNormal(const ModalObject& object, const StrikePoint& point, std::size_t mode) {
    double sum = 0;
    for (std::size_t k = 0; k < point.weights.size(); ++k)
        if (point.weights[k] != 0) {
            const auto* shape =
                &object.shapesAt(static_cast<std::size_t>(point.shapeRows[k]))[3 * mode];
            sum += point.weights[k] * (shape[0] * point.normal[0] + shape[1] * point.normal[1] +
                                       shape[2] * point.normal[2]);
        }
    return sum;
}

} // namespace

LoudnessMatch::LoudnessMatch(std::shared_ptr<const Instrument> instrument, Surface surface)
    : playedInstrument(std::move(instrument)), scrapedSurface(std::move(surface)) {
    const auto& map = playedInstrument->keyMap();
    for (std::size_t note = 0; note < keys.size(); ++note) {
        const int above = (map.highestNote - map.lowestNote) * static_cast<int>(note) /
                          static_cast<int>(keys.size() - 1);
        keys[note].key = playedInstrument->key(map.lowestNote + above);
        if (keys[note].key.slot < 0)
            continue;
        const auto& slot = playedInstrument->slots()[static_cast<std::size_t>(keys[note].key.slot)];
        keys[note].lowestModes = LowestModes(*slot.object, slot.sizeRatio);
        keys[note].weightScale = radiationScale(*slot.object);
    }
}

double LoudnessMatch::predictedLufs(const ParameterValues& parameters,
                                    double sampleRateHz) const noexcept {
    PhraseMeter meter;
    for (std::size_t first = 0, end = 0; first < keys.size(); first = end) {
        for (end = first + 1; end < keys.size() && keys[end].key.slot == keys[first].key.slot;)
            ++end;
        if (keys[first].key.slot >= 0)
            addObject(meter, first, end, parameters, sampleRateHz);
    }
    return meter.integratedLufs();
}

/// Adds the notes, one after the other, that strike one object.
void LoudnessMatch::addObject(PhraseMeter& meter,
                              std::size_t firstNote,
                              std::size_t endNote,
                              const ParameterValues& parameters,
                              double sampleRateHz) const noexcept {
    const auto& [key, lowestModes, weightScale] = keys[firstNote];
    const auto& slot = playedInstrument->slots()[static_cast<std::size_t>(key.slot)];
    const ModalObject& object = *slot.object;
    const auto settings = synthesisSettings(parameters);
    const Conditions conditions(slot, settings);
    const ModeRadiation radiated(object, conditions.radiationRatio);

    std::array<const StrikePoint*, PhraseMeter::notes> points{};
    for (std::size_t note = firstNote; note < endNote; ++note) {
        const auto place = aimedPlace(keys[note].key.along, parameters);
        points[note] = &playedInstrument->strip(keys[note].key).at(place.along, place.across);
    }
    const auto strike =
        malletStrike(*points[firstNote], phraseVelocity, key.malletScale, parameters,
                     surfaceCompliancePerPa(object.material, parameters));
    auto train = contactTrain(strike, key.malletScale, parameters[chatter],
                              static_cast<std::uint32_t>(firstNote));
    if (parameters[modalPulse] != 0)
        train = withModalPulses(
            train, lowestModes.moved(liveFrequencyRatio(object.material, settings)).span());
    // The next key holds an object that all keys share.
    const bool rings = parameters[letRing] != 0 || endNote - firstNote > 1;
    const double release = rings ? 0 : decibels60 / parameters[releaseTime];

    const bool held = static_cast<int>(parameters[contact]) != strikeContact;
    const double speedRatio = std::clamp(
        parameters[contactSpeed] / scrapedSurface.referenceSpeedMetresPerSecond, 1e-3, 1.0);
    const PressedMotion pressed(strike);
    NoteFigures pressedVelocities{};
    NearModes nearModes;
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
        const auto pole = conditions.law.pole(object.eigenvalues[mode]);
        const double hz = naturalFrequencyHz(pole);
        if (hz < lowestHz || hz >= highestShareOfSampleRate * sampleRateHz)
            continue;
        RingingMode ringing{.omega = dampedFrequency(pole),
                            .decay = std::max(pole.damping / 2, slowestDecay)};
        ringing.velocity = held ? scrapedVelocity(scrapedSurface, speedRatio, ringing.omega)
                                : ringingVelocity(train, ringing.decay, ringing.omega);
        ringing.velocity *= std::sqrt(kWeightingPower(hz));
        const double pressedVelocity = held ? 0 : pressed.velocity(pole.stiffness);
        for (std::size_t note = firstNote; note < endNote; ++note) {
            const double struck = shapeAlongNormal(object, *points[note], mode);
            const double gain = conditions.gainRatio * struck;
            auto& residue = ringing.residues[note];
            for (std::size_t channel = 0; channel < residue.size(); ++channel) {
                residue[channel] = gain * (1 - conditions.listening) * struck;
                if (conditions.listening > 0)
                    residue[channel] -=
                        weightScale * gain * conditions.listening * radiated.weight(channel, mode);
            }
            pressedVelocities[note] += pressedVelocity * (residue[0] + residue[1]) / 2;
        }
        meter.addMode(held ? PhraseMeter::Note::sustained : PhraseMeter::Note::struck,
                      nearModes.add(ringing, firstNote, endNote), ringing.decay, release);
    }
    for (double& figure : pressedVelocities)
        figure = pressed.energy(figure);
    meter.addTransients(pressedVelocities);
}

double LoudnessMatch::gainDb(const ParameterValues& own,
                             const ParameterValues& now,
                             double sampleRateHz) const noexcept {
    auto reference = now;
    for (const auto parameter :
         {material, youngsModulus, density, fluidDamping, viscoelasticDamping, mallet,
          malletHardness, malletMass, malletRadius})
        reference.set(parameter, own[parameter]);
    if (reference == now)
        return 0;
    const double gain = predictedLufs(reference, sampleRateHz) - predictedLufs(now, sampleRateHz);
    return std::isfinite(gain) ? std::clamp(gain, -largestGainDb, largestGainDb) : 0;
}

} // namespace idiophone
