// What a worker tells an audio thread of an act: a few cells of a scene's performance for one note.
#pragma once

#include "Instrument/Stage.h"
#include "Scene/SceneRun.h"
#include "Scene/TouchTracker.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

/// Which note begins in which act; the number is its own, from 1 on, and 0 ends the act.
struct ActCue {
    std::uint32_t act = 0;
    std::uint32_t number = 0;
    int midiNote = 0;
    int velocity = 0; ///< 1 to 127
    std::uint32_t seed = 0;
};

/// Times are in seconds and cells since the note, slots are the synthesiser's.
struct ActChunk {
    static constexpr std::int64_t cells = 8;

    struct Touched {
        std::int64_t cell = 0; ///< at whose end it is so
        TouchState state;
    };
    struct Placed {
        std::size_t slot = 0;
        Eigen::Vector3d metres = Eigen::Vector3d::Zero(); ///< the centre of mass, as it is heard
        BodyPose pose;
    };

    std::uint32_t act = 0;
    std::uint32_t number = 0; ///< of the cue
    std::int64_t firstCell = 0;
    bool isLast = false;
    std::vector<SceneBlow> blows; ///< before its end, in order of time
    std::vector<Touched> touches; ///< what slides and rolls, cell by cell
    std::vector<Placed> places;   ///< of what moves, at its end

    std::int64_t endCell() const { return firstCell + cells; }

    /// Nothing of this act's yet, from a cell on. Keeps its memory.
    void clear(std::uint32_t ofAct, std::uint32_t ofCue, std::int64_t fromCell) noexcept {
        act = ofAct;
        number = ofCue;
        firstCell = fromCell;
        isLast = false;
        blows.clear();
        touches.clear();
        places.clear();
    }
};

} // namespace idiophone
