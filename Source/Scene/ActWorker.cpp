#include "Scene/ActWorker.h"

#include <algorithm>
#include <cfenv>
#include <chrono>
#include <exception>
#include <new>
#include <utility>

namespace idiophone {
namespace {

constexpr std::chrono::milliseconds betweenLooks{4};
constexpr double faintNewtons = 1e-9;

/// Makes the pairs of all simulations distinct.
std::uint32_t pairOf(std::uint32_t number, std::uint32_t pair) {
    return std::max(number * 0x9e3779b1u + pair, 1u);
}

/// Sets the default floating-point mode: a thread started by the audio thread inherits its flushing
/// of denormals.
class DefaultFloatingPoint {
public:
    DefaultFloatingPoint() {
        std::fegetenv(&before);
        std::fesetenv(FE_DFL_ENV);
    }
    ~DefaultFloatingPoint() { std::fesetenv(&before); }
    DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
    DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

private:
    std::fenv_t before{};
};

} // namespace

ActWorker::ActWorker(const SceneStage& playedStage, double sampleRateHz)
    : stage(playedStage), cellSeconds(cellSamples / sampleRateHz), acts(stage.actCount()),
      thread([this] { runThread(); }) {}

ActWorker::~ActWorker() {
    isStopping = true;
    stopped.notify_all(); // if the thread is not waiting yet, it notices after one polling interval
    thread.join();
}

ActChunk* ActWorker::take() noexcept {
    ActChunk* chunk = nullptr;
    ready.pop(chunk);
    return chunk;
}

bool ActWorker::help() noexcept {
    const std::lock_guard lock(working);
    return workOnce();
}

void ActWorker::runThread() noexcept {
    while (!isStopping) {
        std::unique_lock lock(working);
        if (!workOnce())
            stopped.wait_for(lock, betweenLooks, [this] { return isStopping.load(); });
    }
}

/// Fills the most urgent block. Returns false if there is nothing to do or no free block.
bool ActWorker::workOnce() noexcept {
    const DefaultFloatingPoint sameOnEveryThread;
    takeUsed();
    takeCues();
    Act* next = nullptr;
    for (Act& act : acts)
        if ((act.begins || act.run != nullptr) && act.chunksOut < chunksAhead &&
            (next == nullptr || act.chunksOut < next->chunksOut))
            next = &act;
    if (next == nullptr || !hasFreeChunk())
        return false;
    auto* chunk = freeChunks.back();
    freeChunks.pop_back();
    chunk->clear(next->cue.act, next->cue.number, next->cellsDone);
    try {
        if (std::exchange(next->begins, false))
            begin(*next);
        fill(*chunk, *next, stage.slotsOfAct(next->cue.act));
    } catch (const std::exception&) {
        chunk->clear(next->cue.act, next->cue.number, next->cellsDone);
        chunk->isLast = true;
    }
    ++next->chunksOut;
    if (chunk->isLast)
        next->run.reset();
    ready.push(chunk); // always fits: the queue holds every block
    return true;
}

/// Allocates a block if none is free. On failure the simulation waits for used ones.
bool ActWorker::hasFreeChunk() noexcept {
    if (!freeChunks.empty())
        return true;
    try {
        freeChunks.reserve(allChunks.size() + 1); // so that taking blocks back never allocates
        allChunks.push_back(std::make_unique<ActChunk>());
    } catch (const std::bad_alloc&) {
        return false;
    }
    freeChunks.push_back(allChunks.back().get());
    return true;
}

void ActWorker::takeUsed() {
    used.consume_all([this](ActChunk* chunk) {
        --acts[chunk->act].chunksOut;
        freeChunks.push_back(chunk);
    });
}

void ActWorker::takeCues() {
    cues.consume_all([this](const ActCue& cue) {
        auto& act = acts[cue.act];
        act.cue = cue;
        act.cellsDone = 0;
        act.run.reset();
        act.begins = cue.number != 0;
    });
}

void ActWorker::begin(Act& act) const {
    const auto& cue = act.cue;
    auto call = stage.callFor(cue.midiNote, cue.velocity, cue.seed);
    call.isStopped = &isStopping;
    act.run = std::make_unique<SceneRun>(stage.assets(), std::move(call));
}

void ActWorker::fill(ActChunk& chunk, Act& act, const SceneStage::SlotMap& slots) const {
    auto& run = *act.run;
    const auto ofStage = [&](std::size_t slot) { return slot == noSlot ? noSlot : slots[slot]; };
    for (std::int64_t cell = chunk.firstCell; cell < chunk.endCell(); ++cell) {
        const double end = static_cast<double>(cell + 1) * cellSeconds;
        run.advanceTo(end);
        while (auto blow = run.takeBlow(end)) {
            blow->slot = ofStage(blow->slot);
            chunk.blows.push_back(*blow);
        }
        for (const auto& state : run.touches()) {
            if (!(state.forceNewtons > faintNewtons))
                continue;
            chunk.touches.push_back({.cell = cell, .state = state});
            auto& told = chunk.touches.back().state;
            told.pair = pairOf(act.cue.number, state.pair);
            for (auto& slot : told.slots)
                slot = ofStage(slot);
        }
    }
    act.cellsDone = chunk.endCell();
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        if (!run.isFixed(slot))
            chunk.places.push_back(
                {.slot = slots[slot], .metres = run.places()[slot], .pose = bodyPose(run, slot)});
    chunk.isLast = run.finished();
}

} // namespace idiophone
