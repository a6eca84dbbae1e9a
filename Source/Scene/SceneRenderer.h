// Simulates and renders a scene cell by cell, on several threads, for a file.
#pragma once

#include "Instrument/StereoSpan.h"
#include "Parameters/ParameterTable.h"
#include "Scene/SceneSimulation.h"
#include "Synth/AlignedVector.h"
#include "World/HeardBodies.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

class WorkTeam;

/// How the sound of a scene is cut into stems, which sum to it.
enum class SceneStems {
    none,
    bodies,  ///< one for each slot of the simulation
    contacts ///< three: impacts, slides, rolls, each heard from all bodies
};

/// While a cell sounds, the bodies move on by the next one. The samples do not depend on the team.
/// Not for the audio thread.
class SceneRenderer {
public:
    /// `head`: the listener's measured head at that sample rate; null selects a sphere. The
    /// simulation and the team outlive it.
    SceneRenderer(SceneSimulation& motion,
                  const SceneAssets& assets,
                  const std::shared_ptr<const HeadResponses>& head,
                  const ParameterValues& parameters,
                  double sampleRateHz,
                  WorkTeam& team,
                  SceneStems stems = SceneStems::none);

    /// Renders the next cell. It and all that follows below are valid until the next call.
    StereoSpan next();

    /// Returns the cell's stems. Quality scaling gives all of them one mode budget.
    std::span<const StereoSpan> stems() const { return stemSpans; }

    /// Returns the impacts that struck in the cell, in order of time.
    std::span<const SceneImpact> impacts() const { return cell.impacts; }
    std::int64_t impactsLeftOut() const { return leftOut; } ///< of all cells: not finite
    /// Returns the bodies at the cell's end and the impacts up to there.
    const SceneSimulation::Figures& figures() const { return cell.figures; }
    std::span<const SlotStatus> status() const { return synth.status(); }
    bool isCrowded() const { return cell.isCrowded; } ///< see SceneSimulation
    /// Returns whether nothing moves or sounds any more.
    bool finished() const { return cell.isFinished && synth.silent() && sound.silent(); }

    double motionSeconds() const { return timeOfMotion; } ///< measured
    double soundSeconds() const { return timeOfSound; }   ///< measured, partly at the same time

private:
    /// The motion of a cell, as its sound and the figures need it.
    struct MovedCell {
        std::vector<SceneImpact> impacts;
        std::array<TouchState, touchVoices> touches;
        std::vector<Eigen::Vector3d> places;
        SceneSimulation::Figures figures;
        bool isFinished = false;
        bool isCrowded = false;
    };

    double startSeconds(std::int64_t number) const {
        return static_cast<double>(number) * cellSeconds;
    }
    void move();
    void soundCell();
    void mixStems();

    WorkTeam& team;
    SceneSimulation& motion; ///< of the owner's thread, like all fields about motion
    SceneStems stemKind;
    std::size_t slotsOfBodies; ///< two more sets follow for slides and rolls that are stems
    Synthesiser synth;         ///< of the thread that runs soundCell, like all fields about sound
    HeardBodies sound;
    AlignedVector<float> samples;     ///< [slots, 64]
    std::vector<CellOutput> outputs;  ///< views into `samples`
    AlignedVector<float> stemSamples; ///< [stems, 2, 64]
    std::vector<StereoSpan> stemSpans;
    std::vector<CellOutput> earsOfSlots; ///< [slots] if there are stems
    double cellSeconds;
    MovedCell cell, nextCell;
    std::int64_t cellsMoved = 0, cellsSounded = 0;
    alignas(64) std::array<float, cellSamples> left{}, right{};
    std::int64_t leftOut = 0;
    double timeOfMotion = 0, timeOfSound = 0;
};

} // namespace idiophone
