// Decides which bodies enter a scene, when, where and in which slot.
#pragma once

#include "Scene/SceneAssets.h"

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace idiophone {

class WorkTeam;

struct SceneNote {
    double seconds = 0; ///< ≥ 0
    int note = 0;       ///< MIDI, 0 to 127
    int velocity = 0;   ///< 1 to 127
};

/// The settings of a simulation that are not in the scene's file.
struct SimulationSetup {
    /// In any order. Notes without a target are ignored. The bodies of the first notes may start to
    /// fall before time 0.
    std::vector<SceneNote> notes = {};
    std::optional<std::uint32_t> seed = {}; ///< replaces the scene's seed
    std::optional<double> seconds = {};     ///< replaces the scene's duration
    double raisedMetres = 0;                ///< added to the initial height of moving bodies
    double speedRatio = 1;                  ///< factor of initial speeds
    /// The work after which the simulation stops, in the units of `RigidWorld::work`.
    double maximumWork = std::numeric_limits<double>::infinity();
    /// Set by another thread to stop the simulation. May be null.
    const std::atomic<bool>* isStopped = nullptr;
    /// Shares the collisions, with the same results. May be null.
    WorkTeam* team = nullptr;
};

/// The slot of bodies without modes.
inline constexpr std::size_t noSlot = ~std::size_t{0};

struct SceneArrivals {
    struct Arrival {
        double seconds = 0;
        std::size_t role = 0;
        std::size_t slot = 0;
        BodyMotion motion; ///< at `seconds`
        double lastsUntil = 0;
    };

    std::vector<Arrival> bodies; ///< in order of time
    /// The bars of the keyboard have the first slots. Slots of removed bodies are reused.
    std::vector<std::size_t> roleOfSlot;
    double lastsUntil = 0;         ///< the end of the scene and of all notes, in seconds
    std::int64_t notesLeftOut = 0; ///< notes without a target
};

/// The same arguments give the same bits.
SceneArrivals arrivalsOf(const SceneAssets& assets, const SimulationSetup& setup);

Eigen::Vector3d radiansPerSecond(const Eigen::Vector3d& turnsPerSecond);

} // namespace idiophone
