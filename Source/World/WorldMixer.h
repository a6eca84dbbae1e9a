// SPDX-License-Identifier: Apache-2.0
// The audio thread's half of a world: takes what the other thread says and renders the cells.
#pragma once

#include "Synth/AlignedVector.h"
#include "Synth/CellStrikes.h"
#include "World/HeardBodies.h"
#include "World/World.h"

#include <array>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace idiophone {

/// Except the constructor, `say` and `clockSamples`, all members are for the audio thread and
/// neither allocate, lock nor throw.
class WorldMixer {
public:
    struct PlacedBody {
        std::size_t body = 0;
        Eigen::Vector3d middleMetres;
    };
    struct TimedStrike {
        std::size_t body = 0;
        double seconds = 0;
        Strike strike;
    };
    struct MovedTouch {
        std::size_t number = 0;
        TouchState state;
    };
    struct EndedTouch {
        std::size_t number = 0;
    };
    struct BodyMaterial {
        std::size_t body = 0;
        std::optional<LiveMaterial> material;
    };
    struct BodyDamping {
        std::size_t body = 0;
        double perSecond = 0;
    };
    struct Gain {
        float factor = 1;
    };
    using Event = std::variant<PlacedBody,
                               Listener,
                               TimedStrike,
                               MovedTouch,
                               EndedTouch,
                               SynthesisSettings,
                               BodyMaterial,
                               BodyDamping,
                               Gain>;

    /// `middlesMetres`: of all bodies.
    WorldMixer(std::vector<SynthesiserSlot> slots,
               const std::vector<Eigen::Vector3d>& middlesMetres,
               const WorldSettings& settings);

    /// [the other thread] Hands an event to the next cell. Returns false if too many wait.
    bool say(const Event& event) { return events.push(event); }
    /// [any thread] Returns the samples of all cells that have begun.
    std::int64_t clockSamples() const noexcept { return clock.load(std::memory_order_relaxed); }

    /// [any thread] Returns how many strikes were too hard for their objects.
    std::int64_t strikesLeftOut() const noexcept { return leftOut.load(std::memory_order_relaxed); }

    void render(std::span<float> left, std::span<float> right) noexcept;
    std::int64_t modesMixed() const noexcept { return synth.modesMixed(); }
    bool silent() const noexcept;

private:
    /// A value that follows its goal within some cells, because games say where things are once a
    /// frame.
    struct Gliding {
        Eigen::Vector3d now, goal;
        void advance(double part) { now += part * (goal - now); }
    };
    struct Pressed {
        TouchState state, goal;
        bool isPressed = false;
    };

    void beginCell() noexcept;
    void takeEvents() noexcept;
    void take(const PlacedBody& placed) noexcept;
    void take(const Listener& moved) noexcept;
    void take(const TimedStrike& timed) noexcept;
    void take(const MovedTouch& moved) noexcept;
    void take(const EndedTouch& ended) noexcept;
    void take(const SynthesisSettings& settings) noexcept { synth.setSettings(settings); }
    void take(const BodyMaterial& changed) noexcept {
        synth.setMaterial(changed.body, changed.material);
    }
    void take(const BodyDamping& damped) noexcept {
        synth.setDamping(damped.body, damped.perSecond);
    }
    void take(const Gain& gain) noexcept { gainGoal = gain.factor; }
    void press(const BegunCell& cell) noexcept;
    void hear() noexcept;

    boost::lockfree::spsc_queue<Event> events;
    std::atomic<std::int64_t> clock{0}, leftOut{0};

    Synthesiser synth;
    bool hasListener;
    HeardBodies bodies;
    CellStrikes strikes;
    std::array<Pressed, touchVoices> touches;
    std::vector<Gliding> middles;        ///< of the bodies
    std::vector<Eigen::Vector3d> places; ///< of the bodies at the cell's end
    Gliding position, towards;           ///< of the listener
    Eigen::Vector3d up;
    double share; ///< of the way that a gliding value goes in a cell
    float gainNow = 1, gainGoal = 1;

    AlignedVector<float> samples;  ///< [bodies, 64] with a listener
    std::vector<CellOutput> cells; ///< of the bodies; without a listener all are `left`, `right`
    std::int64_t cellsBegun = 0;
    alignas(64) std::array<float, cellSamples> left{}, right{};
    std::size_t used = cellSamples; ///< of the cell
};

} // namespace idiophone
