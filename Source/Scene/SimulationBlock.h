// The messages between a simulation thread and the audio thread: notes in one direction, blocks of
// simulated motion in the other.
#pragma once

#include "Instrument/Stage.h"
#include "Scene/SceneSimulation.h"
#include "Scene/TouchTracker.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

/// Starts a note in a simulation. `number` is unique, from 1 on; 0 ends the simulation.
struct SimulationNote {
    std::uint32_t simulation = 0;
    std::uint32_t number = 0;
    int midiNote = 0;
    int velocity = 0; ///< 1 to 127
    std::uint32_t seed = 0;
};

/// A few cells of one note's simulation. Times are in seconds and cells since the note began. Slots
/// are the synthesiser's.
struct SimulationBlock {
    static constexpr std::int64_t cells = 8;

    struct Touched {
        std::int64_t cell = 0; ///< the state holds at the end of this cell
        TouchState state;
    };
    struct Placed {
        std::size_t slot = 0;
        Eigen::Vector3d metres = Eigen::Vector3d::Zero(); ///< centre of mass, as heard
        BodyPose pose;
    };

    std::uint32_t simulation = 0;
    std::uint32_t number = 0; ///< number of the note
    std::int64_t firstCell = 0;
    bool isLast = false;
    SimulationBlock* next = nullptr;  ///< [audio thread] the next received block of the simulation
    std::vector<SceneImpact> impacts; ///< impacts before the block's end, in order of time
    std::vector<Touched> touches;     ///< contacts, cell by cell
    std::vector<Placed> places;       ///< moving bodies at the block's end

    std::int64_t endCell() const { return firstCell + cells; }

    /// Makes this an empty block that starts at a cell. Keeps its memory.
    void clear(std::uint32_t ofSimulation, std::uint32_t ofNote, std::int64_t fromCell) noexcept {
        simulation = ofSimulation;
        number = ofNote;
        firstCell = fromCell;
        isLast = false;
        next = nullptr;
        impacts.clear();
        touches.clear();
        places.clear();
    }
};

} // namespace idiophone
