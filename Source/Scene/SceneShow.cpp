#include "Scene/SceneShow.h"

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

SceneShow::SceneShow(const SceneStage& playedStage, double sampleRateHz, std::uint64_t seed)
    : stage(playedStage), rate(sampleRateHz),
      firstSeed(stage.assets()->scene().seed + static_cast<std::uint32_t>(seed - 1)),
      worker(stage, sampleRateHz), acts(stage.actCount()),
      voices(*stage.assets(), sampleRateHz, seed),
      ears(stage.assets()->scene().listener, nullptr, stage.slots().size(), sampleRateHz),
      places(stage.places()), bodyPoses(stage.firstPoses().begin(), stage.firstPoses().end()),
      ownNumber(nextNumber()) {
    recentBlows.reserve(blowCapacity);
}

void SceneShow::cue(int midiNote, int velocity, std::int64_t cell, double sampleInCell) noexcept {
    const auto index = nextAct;
    const ActCue wanted{.act = static_cast<std::uint32_t>(index),
                        .number = cuesEver + 1,
                        .midiNote = midiNote,
                        .velocity = velocity,
                        .seed = firstSeed + cueCount};
    if (!worker.cue(wanted))
        return;
    ++cuesEver;
    ++cueCount;
    nextAct = (nextAct + 1) % acts.size();
    auto& act = acts[index];
    clear(act);
    act.number = wanted.number;
    act.startCell = cell;
    act.startSample = sampleInCell;
}

void SceneShow::sound(std::int64_t cell,
                      Synthesiser& synthesiser,
                      std::span<const CellOutput> cellsOfSlots) noexcept {
    if (std::exchange(areBlowsTaken, false))
        recentBlows.clear();
    takeChunks();
    const BegunCell begun{synthesiser, cellsOfSlots, cell};
    if (!paused)
        playActs(begun);
    else {
        release(synthesiser, cellsOfSlots);
        for (auto& act : acts)
            ++act.startCell;
    }
    crowded.strikeBefore(cellSamples, begun);
}

void SceneShow::playActs(const BegunCell& cell) noexcept {
    isPressed.fill(false);
    if (mayWait)
        waitFor(cell.index);
    for (auto& act : acts)
        if (act.number != 0)
            play(act, cell);
    releaseOthers(cell.synthesiser, cell.cellsOfSlots);
}

void SceneShow::release(Synthesiser& synthesiser,
                        std::span<const CellOutput> cellsOfSlots) noexcept {
    isPressed.fill(false);
    releaseOthers(synthesiser, cellsOfSlots);
}

/// Releases the voices that are no longer pressed.
void SceneShow::releaseOthers(Synthesiser& synthesiser,
                              std::span<const CellOutput> cellsOfSlots) noexcept {
    for (std::size_t voice = 0; voice < isPressed.size(); ++voice)
        if (!isPressed[voice] && std::exchange(pairOfVoice[voice], 0u) != 0)
            voices.release(voice, synthesiser, cellsOfSlots);
}

void SceneShow::hear(std::span<const CellOutput> cellsOfSlots, const CellOutput& heard) noexcept {
    ears.hear(cellsOfSlots, places, heard);
}

/// Gives back the simulation's blocks and resets it.
void SceneShow::clear(Act& act) noexcept {
    while (act.count > 0)
        drop(act);
    act.number = 0;
    act.knownCells = 0;
    act.isAllKnown = act.isPlaced = false;
}

void SceneShow::drop(Act& act) noexcept {
    worker.giveBack(act.chunks[act.first]);
    act.first = (act.first + 1) % chunkCapacity;
    --act.count;
    act.blowsDone = 0;
}

void SceneShow::takeChunks() noexcept {
    while (auto* chunk = worker.take()) {
        auto& act = acts[chunk->act];
        if (chunk->number != act.number || act.count == chunkCapacity) {
            worker.giveBack(chunk);
            continue;
        }
        act.chunks[(act.first + act.count++) % chunkCapacity] = chunk;
        act.knownCells = chunk->endCell();
        act.isAllKnown = chunk->isLast;
    }
}

/// Waits until everything before the cell's end is known.
void SceneShow::waitFor(std::int64_t cell) noexcept {
    const auto isKnown = [&](const Act& act) {
        return act.number == 0 || act.isAllKnown || act.knownCells > cell - act.startCell;
    };
    while (!std::ranges::all_of(acts, isKnown)) {
        const bool more = worker.help();
        takeChunks();
        if (!more)
            return; // no more blocks will come
    }
}

void SceneShow::play(Act& act, const BegunCell& cell) noexcept {
    // The simulation's cells lie between those of the sound. This cell ends within its cell `now`.
    const auto now = cell.index - act.startCell;
    const double startSeconds = (static_cast<double>(now * cellSamples) - act.startSample) / rate;
    const double endSeconds = startSeconds + cellSamples / rate;
    while (act.count > 0) {
        auto& chunk = act.front();
        for (; act.blowsDone < chunk.blows.size(); ++act.blowsDone) {
            const auto& blow = chunk.blows[act.blowsDone];
            if (blow.seconds >= endSeconds)
                break;
            const double sample = (blow.seconds - startSeconds) * rate;
            if (sample < -0.5)
                ++lateCount;
            strike(blow, sample, cell);
        }
        for (const auto& touched : chunk.touches)
            if (touched.cell == now - 1)
                press(touched.state, cell);
        place(act, chunk.endCell() - now);
        if (now < chunk.endCell())
            return;
        for (const auto& placed : chunk.places)
            bodyPoses[placed.slot] = placed.pose;
        const bool isOver = chunk.isLast;
        drop(act);
        if (isOver) {
            clear(act);
            return;
        }
    }
}

std::span<const PlacedBlow> SceneShow::takeBlows() noexcept {
    if (std::exchange(areBlowsTaken, true))
        return {};
    return recentBlows;
}

void SceneShow::strike(const SceneBlow& blow, double sample, const BegunCell& cell) noexcept {
    if (blow.slot >= cell.cellsOfSlots.size() ||
        !crowded.strike(blow.slot, blow.strike, sample, cell))
        return;
    if (recentBlows.size() < blowCapacity)
        recentBlows.push_back(
            {.seconds =
                 (static_cast<double>(cell.index * cellSamples) + std::max(sample, 0.0)) / rate,
             .slot = blow.slot,
             .strike = blow.strike,
             .pointMetres = {blow.pointMetres.x(), blow.pointMetres.y(), blow.pointMetres.z()}});
}

/// Presses the pair's voice, or a free one.
void SceneShow::press(const TouchState& state, const BegunCell& cell) noexcept {
    auto voice = std::ranges::find(pairOfVoice, state.pair);
    if (voice == pairOfVoice.end())
        voice = std::ranges::find(pairOfVoice, 0u);
    if (voice == pairOfVoice.end())
        return;
    *voice = state.pair;
    const auto index = static_cast<std::size_t>(voice - pairOfVoice.begin());
    isPressed[index] = true;
    voices.press(index, state, cell.synthesiser, cell.cellsOfSlots);
}

/// Moves places evenly to those of the first block, or at once for a new simulation.
void SceneShow::place(Act& act, std::int64_t cellsLeft) noexcept {
    const double share =
        act.isPlaced ? 1.0 / static_cast<double>(std::max<std::int64_t>(cellsLeft, 1)) : 1;
    for (const auto& placed : act.front().places)
        places[placed.slot] += share * (placed.metres - places[placed.slot]);
    act.isPlaced = true;
}

void SceneShow::stop() noexcept {
    for (std::size_t index = 0; index < acts.size(); ++index) {
        if (acts[index].number != 0)
            worker.cue({.act = static_cast<std::uint32_t>(index)});
        clear(acts[index]);
    }
    std::ranges::copy(stage.firstPoses(), bodyPoses.begin());
    crowded.clear();
    recentBlows.clear();
    ownNumber = nextNumber();
}

void SceneShow::reset() noexcept {
    stop();
    nextAct = 0;
    cueCount = 0;
    lateCount = 0;
    voices.reset();
    pairOfVoice.fill(0);
    ears.reset();
    std::ranges::copy(stage.places(), places.begin());
}

bool SceneShow::silent() const noexcept {
    return ears.silent() && crowded.empty() &&
           std::ranges::all_of(acts, [](const Act& act) { return act.number == 0; }) &&
           std::ranges::all_of(pairOfVoice, [](std::uint32_t pair) { return pair == 0; });
}

} // namespace idiophone
