#include "Scene/ScenePlayer.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace idiophone {
namespace {

std::uint32_t nextNumber() noexcept {
    static std::atomic<std::uint32_t> last{0};
    return ++last;
}

} // namespace

ScenePlayer::ScenePlayer(const SceneStage& playedStage, double sampleRateHz, std::uint64_t seed)
    : stage(playedStage), rate(sampleRateHz),
      firstSeed(stage.assets()->scene().seed + static_cast<std::uint32_t>(seed - 1)),
      worker(stage, sampleRateHz), simulations(stage.simulationCount()),
      bodies(stage.slots().size(),
             stage.assets()->surfaces(),
             stage.assets()->scene().listener,
             sampleRateHz,
             seed),
      places(stage.places()), poses(stage.firstPoses().begin(), stage.firstPoses().end()),
      ownNumber(nextNumber()) {
    recentImpacts.reserve(impactCapacity);
}

void ScenePlayer::startNote(int midiNote,
                            int velocity,
                            std::int64_t cell,
                            double sampleInCell) noexcept {
    const auto index = nextSimulation;
    const SimulationNote wanted{.simulation = static_cast<std::uint32_t>(index),
                                .number = notesEver + 1,
                                .midiNote = midiNote,
                                .velocity = velocity,
                                .seed = firstSeed + noteCount};
    if (!worker.start(wanted))
        return;
    ++notesEver;
    ++noteCount;
    nextSimulation = (nextSimulation + 1) % simulations.size();
    clear(simulations[index]);
    simulations[index].number = wanted.number;
    simulations[index].startCell = cell;
    simulations[index].startSample = sampleInCell;
}

void ScenePlayer::sound(std::int64_t cell,
                        Synthesiser& synthesiser,
                        std::span<const CellOutput> cellsOfSlots) noexcept {
    if (std::exchange(areImpactsTaken, false))
        recentImpacts.clear();
    takeBlocks();
    const BegunCell begun{synthesiser, cellsOfSlots, cell};
    isPressed.fill(false);
    if (mayWait && !paused)
        waitFor(cell);
    for (auto& simulation : simulations)
        if (paused)
            ++simulation.startCell;
        else if (simulation.number != 0)
            play(simulation, begun);
    releaseOthers(begun);
    bodies.crowded.strikeBefore(cellSamples, begun);
}

void ScenePlayer::release(Synthesiser& synthesiser,
                          std::span<const CellOutput> cellsOfSlots) noexcept {
    isPressed.fill(false);
    releaseOthers({synthesiser, cellsOfSlots});
}

/// Releases the voices that are no longer pressed.
void ScenePlayer::releaseOthers(const BegunCell& cell) noexcept {
    for (std::size_t voice = 0; voice < isPressed.size(); ++voice)
        if (!isPressed[voice] && std::exchange(pairOfVoice[voice], 0u) != 0)
            bodies.contacts.release(voice, cell);
}

void ScenePlayer::hear(std::span<const CellOutput> cellsOfSlots, const CellOutput& heard) noexcept {
    bodies.hear(cellsOfSlots, places, heard);
}

/// Gives back the simulation's blocks and resets it.
void ScenePlayer::clear(Simulation& simulation) noexcept {
    while (simulation.first != nullptr)
        drop(simulation);
    simulation = {};
}

void ScenePlayer::drop(Simulation& simulation) noexcept {
    auto* const done = std::exchange(simulation.first, simulation.first->next);
    worker.giveBack(done);
    simulation.impactsDone = 0;
}

void ScenePlayer::takeBlocks() noexcept {
    while (auto* block = worker.take()) {
        auto& simulation = simulations[block->simulation];
        if (block->number != simulation.number) {
            worker.giveBack(block);
            continue;
        }
        (simulation.first == nullptr ? simulation.first : simulation.last->next) = block;
        simulation.last = block;
        simulation.knownCells = block->endCell();
        simulation.isAllKnown = block->isLast;
    }
}

/// Waits until everything before the cell's end is known.
void ScenePlayer::waitFor(std::int64_t cell) noexcept {
    const auto isKnown = [&](const Simulation& simulation) {
        return simulation.number == 0 || simulation.isAllKnown ||
               simulation.knownCells > cell - simulation.startCell;
    };
    while (!std::ranges::all_of(simulations, isKnown)) {
        const bool more = worker.help();
        takeBlocks();
        if (!more)
            return; // no more blocks will come
    }
}

bool ScenePlayer::simulateAhead() noexcept {
    takeBlocks(); // gives back blocks of former notes, so that the worker may go on
    bool isBusy = false;
    for (const auto& simulation : simulations)
        if (simulation.number != 0 && !simulation.isAllKnown)
            isBusy = worker.help() || isBusy;
    return isBusy;
}

void ScenePlayer::play(Simulation& simulation, const BegunCell& cell) noexcept {
    // The simulation's cells and those of the sound begin at different times. This cell ends within
    // the simulation's cell `now`.
    const auto now = cell.index - simulation.startCell;
    const double startSeconds =
        (static_cast<double>(now * cellSamples) - simulation.startSample) / rate;
    const double endSeconds = startSeconds + cellSamples / rate;
    while (simulation.first != nullptr) {
        auto& block = *simulation.first;
        for (; simulation.impactsDone < block.impacts.size(); ++simulation.impactsDone) {
            const auto& impact = block.impacts[simulation.impactsDone];
            if (impact.seconds >= endSeconds)
                break;
            const double sample = (impact.seconds - startSeconds) * rate;
            if (sample < -0.5)
                ++lateCount;
            strike(impact, sample, cell);
        }
        // A contact that was late in several cells of the block counts once, in the last of them.
        const auto lastLate = std::min(now - 1, block.endCell()) - 1;
        for (const auto& touched : block.touches)
            if (touched.cell == now - 1)
                press(touched.state, cell);
            else if (touched.cell == lastLate && lastLate >= simulation.contactCells)
                ++lateCount;
        simulation.contactCells = std::max(simulation.contactCells, std::min(now, block.endCell()));
        place(simulation, block.endCell() - now);
        if (now < block.endCell())
            return;
        for (const auto& placed : block.places)
            poses[placed.slot] = placed.pose;
        const bool isOver = block.isLast;
        drop(simulation);
        if (isOver) {
            clear(simulation);
            return;
        }
    }
}

std::span<const PlacedImpact> ScenePlayer::takeImpacts() noexcept {
    if (std::exchange(areImpactsTaken, true))
        return {};
    return recentImpacts;
}

void ScenePlayer::strike(const SceneImpact& impact, double sample, const BegunCell& cell) noexcept {
    if (!bodies.strike(impact.slot, impact.strike, sample, cell) ||
        recentImpacts.size() == impactCapacity)
        return;
    recentImpacts.push_back(
        {.seconds = (static_cast<double>(cell.index * cellSamples) + std::max(sample, 0.0)) / rate,
         .slot = impact.slot,
         .strike = impact.strike,
         .pointMetres = {impact.pointMetres.x(), impact.pointMetres.y(), impact.pointMetres.z()}});
}

/// Presses the pair's voice, or a free one.
void ScenePlayer::press(const TouchState& state, const BegunCell& cell) noexcept {
    auto voice = std::ranges::find(pairOfVoice, state.pair);
    if (voice == pairOfVoice.end())
        voice = std::ranges::find(pairOfVoice, 0u);
    if (voice == pairOfVoice.end())
        return;
    *voice = state.pair;
    const auto index = static_cast<std::size_t>(voice - pairOfVoice.begin());
    isPressed[index] = true;
    bodies.contacts.press(index, state, cell);
}

/// Moves places evenly to those of the first block, or at once for a new simulation.
void ScenePlayer::place(Simulation& simulation, std::int64_t cellsLeft) noexcept {
    const double share =
        simulation.isPlaced ? 1.0 / static_cast<double>(std::max<std::int64_t>(cellsLeft, 1)) : 1;
    for (const auto& placed : simulation.first->places)
        places[placed.slot] += share * (placed.metres - places[placed.slot]);
    simulation.isPlaced = true;
}

void ScenePlayer::clear() noexcept {
    for (std::size_t index = 0; index < simulations.size(); ++index) {
        if (simulations[index].number != 0)
            worker.start({.simulation = static_cast<std::uint32_t>(index)});
        clear(simulations[index]);
    }
    std::ranges::copy(stage.firstPoses(), poses.begin());
    bodies.crowded.clear();
    recentImpacts.clear();
    ownNumber = nextNumber();
}

void ScenePlayer::reset() noexcept {
    clear();
    nextSimulation = 0;
    noteCount = 0;
    lateCount = 0;
    bodies.reset();
    pairOfVoice.fill(0);
    std::ranges::copy(stage.places(), places.begin());
}

bool ScenePlayer::silent() const noexcept {
    return bodies.silent() &&
           std::ranges::all_of(
               simulations, [](const Simulation& simulation) { return simulation.number == 0; }) &&
           std::ranges::all_of(pairOfVoice, [](std::uint32_t pair) { return pair == 0; });
}

} // namespace idiophone
