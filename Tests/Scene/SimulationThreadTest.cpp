// Tests the thread that simulates a stage ahead of its sound.
#include "Scene/SimulationThread.h"
#include "Instrument/ObjectLibrary.h"

#include "Scene/FactoryScenes.h"

#include <catch2/catch_test_macros.hpp>
#include <thread>

using namespace idiophone;

TEST_CASE("A sleeping worker wakes for each note, and goes on as its blocks come back") {
    const auto stage = SceneStage::make(SceneAssets::make(*findFactoryScene("Dice on a xylophone"),
                                                          ObjectLibrary::shared())
                                            .value())
                           .value();
    SimulationThread worker(*stage, 48000);
    for (std::uint32_t number = 1; number <= 3; ++number) {
        REQUIRE(worker.start({.number = number, .midiNote = 72, .velocity = 100}));
        std::int64_t cells = 0;
        for (bool isLast = false; !isLast;) { // a die needs more blocks than the worker's lead
            auto* block = worker.take();
            if (block == nullptr) {
                std::this_thread::yield();
                continue;
            }
            REQUIRE(block->number == number);
            CHECK(block->firstCell == cells);
            cells = block->endCell();
            isLast = block->isLast;
            worker.giveBack(block);
        }
        CHECK(cells > 96 * SimulationBlock::cells);
    }
}
