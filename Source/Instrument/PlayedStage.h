// Controls the stage of a player. Without a stage, no function has an effect.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/Stage.h"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws.
class PlayedStage {
public:
    /// Sets whether rendering may wait for the simulation.
    void setOffline(bool isOffline) noexcept {
        if (performance)
            performance->setOffline(isOffline);
    }
    /// See StagePlayer::waitForSimulation.
    void waitForSimulation() noexcept {
        if (performance)
            performance->waitForSimulation();
    }
    /// Stops bodies in place, or lets them go on.
    void pauseStage(bool isPaused) noexcept {
        if (performance)
            performance->setPaused(isPaused);
    }
    /// Returns bodies to their state before the first note.
    void resetStage() noexcept {
        if (performance)
            performance->stop();
    }
    /// Returns the impacts of bodies since the last call; valid until the next cell.
    std::span<const PlacedImpact> takeImpacts() noexcept {
        return performance ? performance->takeImpacts() : std::span<const PlacedImpact>();
    }
    /// Returns StagePlayer::number, or 0.
    std::uint32_t performanceNumber() const noexcept {
        return performance ? performance->number() : 0;
    }
    /// Returns where the bodies of the slots are; empty without a stage.
    std::span<const BodyPose> bodyPoses() const noexcept {
        return performance ? performance->poses() : std::span<const BodyPose>();
    }
    /// Returns the number of impacts and contacts that became known too late to act at their time.
    std::int64_t lateEvents() const noexcept { return performance ? performance->lateEvents() : 0; }

protected:
    PlayedStage(std::shared_ptr<const Instrument> instrument,
                double sampleRateHz,
                std::uint64_t seed)
        : playedInstrument(std::move(instrument)) {
        if (const auto& stage = playedInstrument->stage())
            performance = stage->makePlayer(sampleRateHz, seed);
    }

    std::shared_ptr<const Instrument> playedInstrument; ///< outlives the worker thread of the stage
    std::unique_ptr<StagePlayer> performance;           ///< null without a stage
};

} // namespace idiophone
