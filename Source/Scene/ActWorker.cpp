#include "Scene/ActWorker.h"

#include <algorithm>
#include <cfenv>
#include <chrono>

namespace idiophone {
namespace {

constexpr std::chrono::milliseconds betweenLooks{4};
constexpr double faintNewtons = 1e-9;

/// Pairs of all acts apart.
std::uint32_t pairOf(std::uint32_t number, std::uint32_t pair) {
    return std::max(number * 0x9e3779b1u + pair, 1u);
}

/// An audio thread flushes denormals, and threads that it starts do.
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
    stopped.notify_all(); // missed at worst for as long as it looks away
    thread.join();
}

ActChunk* ActWorker::take() noexcept {
    ActChunk* chunk = nullptr;
    ready.pop(chunk);
    return chunk;
}

bool ActWorker::help() {
    const std::lock_guard lock(working);
    return workOnce();
}

void ActWorker::runThread() {
    while (!isStopping) {
        std::unique_lock lock(working);
        if (!workOnce())
            stopped.wait_for(lock, betweenLooks, [this] { return isStopping.load(); });
    }
}

/// Makes the chunk that will be needed first. False where there was nothing to do.
bool ActWorker::workOnce() {
    const DefaultFloatingPoint sameOnEveryThread;
    takeUsed();
    takeCues();
    Act* next = nullptr;
    for (Act& act : acts)
        if (act.run != nullptr && act.chunksOut < chunksAhead &&
            (next == nullptr || act.chunksOut < next->chunksOut))
            next = &act;
    if (next == nullptr)
        return false;
    if (freeChunks.empty()) {
        allChunks.push_back(std::make_unique<ActChunk>());
        freeChunks.push_back(allChunks.back().get());
    }
    auto* chunk = freeChunks.back();
    freeChunks.pop_back();
    fill(*chunk, *next, stage.slotsOfAct(next->cue.act));
    ++next->chunksOut;
    if (chunk->isLast)
        next->run.reset();
    ready.push(chunk); // there is room for all that may be out
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
        if (cue.number != 0)
            act.run = std::make_unique<SceneRun>(
                stage.cast(), stage.callFor(cue.midiNote, cue.velocity, cue.seed));
    });
}

void ActWorker::fill(ActChunk& chunk, Act& act, const SceneStage::SlotMap& slots) const {
    chunk.act = act.cue.act;
    chunk.number = act.cue.number;
    chunk.firstCell = act.cellsDone;
    chunk.blows.clear();
    chunk.touches.clear();
    chunk.places.clear();
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
