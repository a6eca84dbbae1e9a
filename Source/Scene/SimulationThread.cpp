#include "Scene/SimulationThread.h"

#include <algorithm>
#include <cfenv>
#include <exception>
#include <utility>

namespace idiophone {
namespace {

constexpr double faintNewtons = 1e-9;

/// Makes the pairs of all simulations distinct.
std::uint32_t pairOf(std::uint32_t number, std::uint32_t pair) {
    return std::max(number * 0x9e3779b1u + pair, 1u);
}

std::vector<SimulationBlock*> pointersTo(std::vector<SimulationBlock>& blocks) {
    std::vector<SimulationBlock*> pointers;
    for (auto& block : blocks)
        pointers.push_back(&block);
    return pointers;
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

SimulationThread::SimulationThread(const SceneStage& playedStage, double sampleRateHz)
    : stage(playedStage), cellSeconds(cellSamples / sampleRateHz),
      simulations(stage.simulationCount()), blocks(stage.simulationCount() * blocksAhead),
      freeBlocks(pointersTo(blocks)), worker([this] { return workOnce(); }) {}

SimulationThread::~SimulationThread() {
    isStopping = true;
}

bool SimulationThread::start(const SimulationNote& note) noexcept {
    const bool isSent = notes.push(note);
    worker.wake();
    return isSent;
}

void SimulationThread::giveBack(SimulationBlock* block) noexcept {
    used.push(block);
    if (++blocksReturned % blocksPerWake == 0)
        worker.wake();
}

SimulationBlock* SimulationThread::take() noexcept {
    SimulationBlock* block = nullptr;
    ready.pop(block);
    return block;
}

bool SimulationThread::help() noexcept {
    return worker.doPiece();
}

/// Fills the most urgent block. Returns false if there is nothing to do.
bool SimulationThread::workOnce() noexcept {
    const DefaultFloatingPoint sameOnEveryThread;
    takeUsed();
    takeNotes();
    Simulation* next = nullptr;
    for (Simulation& simulation : simulations)
        if ((simulation.begins || simulation.run != nullptr) &&
            simulation.blocksOut < blocksAhead &&
            (next == nullptr || simulation.blocksOut < next->blocksOut))
            next = &simulation;
    if (next == nullptr)
        return false;
    auto* block = freeBlocks.back();
    freeBlocks.pop_back();
    block->clear(next->note.simulation, next->note.number, next->cellsDone);
    try {
        if (std::exchange(next->begins, false))
            begin(*next);
        fill(*block, *next, stage.slotsOfSimulation(next->note.simulation));
    } catch (const std::exception&) {
        block->clear(next->note.simulation, next->note.number, next->cellsDone);
        block->isLast = true;
    }
    ++next->blocksOut;
    if (block->isLast)
        next->run.reset();
    ready.push(block); // always fits: the queue holds every block
    return true;
}

void SimulationThread::takeUsed() {
    used.consume_all([this](SimulationBlock* block) {
        --simulations[block->simulation].blocksOut;
        freeBlocks.push_back(block);
    });
}

void SimulationThread::takeNotes() {
    notes.consume_all([this](const SimulationNote& note) {
        auto& simulation = simulations[note.simulation];
        simulation.note = note;
        simulation.cellsDone = 0;
        simulation.run.reset();
        simulation.begins = note.number != 0;
    });
}

void SimulationThread::begin(Simulation& simulation) const {
    const auto& note = simulation.note;
    auto setup = stage.setupFor(note.midiNote, note.velocity, note.seed);
    setup.isStopped = &isStopping;
    simulation.run = std::make_unique<SceneSimulation>(stage.assets(), std::move(setup));
}

void SimulationThread::fill(SimulationBlock& block,
                            Simulation& simulation,
                            const SceneStage::SlotMap& slots) const {
    auto& run = *simulation.run;
    const auto ofStage = [&](std::size_t slot) { return slot == noSlot ? noSlot : slots[slot]; };
    for (std::int64_t cell = block.firstCell; cell < block.endCell(); ++cell) {
        const double end = static_cast<double>(cell + 1) * cellSeconds;
        run.advanceTo(end);
        while (auto impact = run.takeImpact(end)) {
            impact->slot = ofStage(impact->slot);
            block.impacts.push_back(*impact);
        }
        for (const auto& state : run.touches()) {
            if (!(state.forceNewtons > faintNewtons))
                continue;
            block.touches.push_back({.cell = cell, .state = state});
            auto& sent = block.touches.back().state;
            sent.pair = pairOf(simulation.note.number, state.pair);
            for (auto& slot : sent.slots)
                slot = ofStage(slot);
        }
    }
    simulation.cellsDone = block.endCell();
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        if (!run.isFixed(slot))
            block.places.push_back(
                {.slot = slots[slot], .metres = run.places()[slot], .pose = bodyPose(run, slot)});
    block.isLast = run.finished();
}

} // namespace idiophone
