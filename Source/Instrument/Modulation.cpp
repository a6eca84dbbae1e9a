#include "Instrument/Modulation.h"

#include "Instrument/Scatter.h"
#include "Instrument/StrikeScheduler.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double roundingSeconds = 0.003; // for 63 % of a step
constexpr double smallestTuneStep = 1e-6; // share of the range; a smaller step is not heard
constexpr NoteShifts noShifts;
constexpr double middleKey = 60, farthestKeys = 60;

std::size_t indexOf(int note) {
    return static_cast<std::size_t>(note);
}

} // namespace

Modulation::Modulation(const ParameterGlide& gliding,
                       const KeyState& played,
                       double secondsPerCell,
                       std::uint64_t seed)
    : glide(gliding), keys(played), cellSeconds(secondsPerCell),
      roundingShare(-std::expm1(-secondsPerCell / roundingSeconds)),
      glideShare(ParameterGlide::fractionPerCell(secondsPerCell)),
      firstNumber(distantNumber(seed - 1)),
      noteCount(firstNumber), lfos{Lfo(secondsPerCell), Lfo(secondsPerCell)},
      hostShifts(&noShifts) {}

void Modulation::noteOn(int number, int velocity) noexcept {
    auto& note = notes[indexOf(number)];
    note.number = noteCount++;
    note.velocity = velocity / 127.0;
    for (std::size_t i = 0; i < lfos.size(); ++i)
        note.swingsAtStart[i] = lfos[i].swings();
    note.envelope.start();
    if (number != hand) {
        tuneShares[indexOf(number)] = hostShifts->share(tune, number);
        hasTuneShares = hasTuneShares || tuneShares[indexOf(number)] != 0;
    }
    lastNote = number;
    handIsDown = handIsDown || number == hand;
}

void Modulation::beginCell(double beatsPerMinute, std::optional<double> beats) noexcept {
    routes = ActiveRoutes(glide.values());
    beginLfos(beatsPerMinute, beats);
    if (hostMoves(tune))
        glideTuneShares();
    if (routes.empty())
        return;
    roundInputs();
    if (routes.uses(ModulationSource::envelope))
        advanceEnvelopes();
}

void Modulation::beginLfos(double beatsPerMinute, std::optional<double> beats) noexcept {
    const auto& values = glide.values();
    for (std::size_t i = 0; i < lfos.size(); ++i) {
        const auto& lfo = lfoParameters[i];
        lfos[i].beginCell(routes.moved(lfo.rate, values[lfo.rate], sharedInputs),
                          lfoSyncBeats(static_cast<int>(values[lfo.sync])), beatsPerMinute, beats);
    }
}

void Modulation::roundInputs() noexcept {
    const bool isAtOnce = std::exchange(isFresh, false);
    for (const auto& route : routes.all()) {
        const double goal = sourceOf(route, lastNote);
        auto& input = sharedInputs[route.number];
        input = isAtOnce ? goal : input + roundingShare * (goal - input);
    }
}

void Modulation::advanceEnvelopes() noexcept {
    const EnvelopeSteps steps(glide.values(), cellSeconds);
    const auto held = keys.heldKeys();
    for (std::size_t note = 0; note < held.size(); ++note)
        notes[note].envelope.advance(steps, held[note]);
    notes[hand].envelope.advance(steps, handIsDown);
}

/// Moves the shares as the parameter glides. A note keeps its pitch if its share makes up for a
/// step of the parameter.
void Modulation::glideTuneShares() noexcept {
    hasTuneShares = false;
    for (std::size_t note = 0; note < tuneShares.size(); ++note) {
        const double goal = hostShifts->share(tune, static_cast<int>(note));
        auto& share = tuneShares[note];
        const double step = glideShare * (goal - share);
        share = std::abs(step) > smallestTuneStep ? share + step : goal;
        hasTuneShares = hasTuneShares || share != 0;
    }
}

bool Modulation::hostMoves(ParameterId target) const noexcept {
    return hostShifts->moves(target) || (target == tune && hasTuneShares);
}

double Modulation::hostShare(ParameterId target, int note) const noexcept {
    if (note == hand)
        return 0;
    return target == tune ? tuneShares[indexOf(note)] : hostShifts->share(target, note);
}

double Modulation::lfoOf(std::size_t lfo, const Note& note) const noexcept {
    const auto& values = glide.values();
    const bool isPerNote = values[lfoParameters[lfo].perNote] != 0;
    const auto seed = firstNumber + static_cast<std::uint32_t>(lfo + 1) * 0x85ebca6bu;
    return lfoValue(static_cast<LfoShape>(values[lfoParameters[lfo].shape]),
                    lfos[lfo].swings() - (isPerNote ? note.swingsAtStart[lfo] : 0),
                    seed + (isPerNote ? note.number * 0xc2b2ae35u : 0));
}

double Modulation::sourceOf(const ActiveRoute& route, int number) const noexcept {
    const auto index = indexOf(number);
    const auto& note = notes[index];
    switch (route.source) {
    case ModulationSource::lfo1:
        return lfoOf(0, note);
    case ModulationSource::lfo2:
        return lfoOf(1, note);
    case ModulationSource::envelope:
        return note.envelope.value();
    case ModulationSource::velocity:
        return note.velocity;
    case ModulationSource::key:
        return index == hand
                   ? 0
                   : std::clamp((static_cast<double>(index) - middleKey) / farthestKeys, -1.0, 1.0);
    case ModulationSource::pressure:
        return index == hand ? 0 : static_cast<double>(keys.pressure(index));
    case ModulationSource::wheel:
        return keys.wheelForModulation();
    case ModulationSource::random:
        return scatter(note.number * static_cast<std::uint32_t>(routeCount) +
                       static_cast<std::uint32_t>(route.number));
    case ModulationSource::none:
    case ModulationSource::count:
        break;
    }
    return 0;
}

ActiveRoutes::Inputs Modulation::inputsOf(int note) const noexcept {
    ActiveRoutes::Inputs inputs{};
    for (const auto& route : routes.all())
        inputs[route.number] = sourceOf(route, note);
    return inputs;
}

const ParameterValues& Modulation::moved(const ActiveRoutes::Inputs& inputs) noexcept {
    const auto& base = glide.values();
    result = base;
    for (const auto& route : routes.all())
        if (route.target != tune)
            result.set(route.target, routes.moved(route.target, base[route.target], inputs));
    return result;
}

const ParameterValues& Modulation::values() noexcept {
    return routes.empty() ? glide.values() : moved(sharedInputs);
}

const ParameterValues& Modulation::valuesOf(int note) noexcept {
    const bool isShifted = std::ranges::any_of(
        noteTargets(), [&](ParameterId target) { return hostShare(target, note) != 0; });
    if (routes.empty() && !isShifted)
        return glide.values();
    moved(inputsOf(note));
    if (isShifted)
        for (const auto target : noteTargets())
            if (target != tune)
                result.set(target, valueOf(target, note));
    return result;
}

double Modulation::valueOf(ParameterId target, int note) const noexcept {
    const double base = glide.values()[target];
    return moves(target) ? routes.moved(target, base, inputsOf(note), hostShare(target, note))
                         : base;
}

void Modulation::reset() noexcept {
    for (auto& lfo : lfos)
        lfo.reset();
    notes = {};
    sharedInputs = {};
    tuneShares = {};
    hasTuneShares = false;
    lastNote = hand;
    isFresh = true;
    countFrom(0);
}

} // namespace idiophone
