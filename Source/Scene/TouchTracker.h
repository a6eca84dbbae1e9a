// Assigns lasting contacts to a few voices. A voice stays with one pair of bodies as long as they
// touch.
#pragma once

#include "Scene/Contact.h"
#include "Scene/SceneAssets.h"
#include "Synth/ForceCell.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// The state of a contact voice at a time.
struct TouchState {
    std::uint32_t pair = 0;    ///< counts the pairs that the voice has had; 0 before the first
    std::size_t soundRole = 0; ///< role of the body whose surface is heard
    std::array<std::size_t, 2> slots{};
    std::array<ForcePoint, 2> points{}; ///< contact points of both bodies, for 1 N
    double forceNewtons = 0;
    double slideMetresPerSecond = 0;
    double rollMetresPerSecond = 0;
};

/// One thread at a time. Not for the audio thread.
class TouchTracker {
public:
    static constexpr std::size_t voiceCount = 24;
    static_assert(voiceCount <= forceCapacity);

    TouchTracker(std::shared_ptr<const SceneAssets> assets, double stepSeconds);

    /// Takes the contacts of a step. `roles` and `slots` are indexed by body.
    void follow(std::span<const Touch> touches,
                std::span<const std::size_t> roles,
                std::span<const std::size_t> slots);

    std::span<const TouchState, voiceCount> states() const { return now; }

private:
    struct Voice {
        std::array<std::size_t, 2> bodies{};
        std::array<Eigen::Vector3d, 2> pointMetres; ///< where `points` were computed
        double fadeSteps = 0;  ///< steps until the voice is free; > 0 since its last contact
        bool isPlaced = false; ///< whether the contact points are known
    };

    std::size_t voiceFor(const Touch& touch);
    void move(std::size_t voice, const Touch& touch, std::span<const std::size_t> roles);

    std::shared_ptr<const SceneAssets> assets;
    double share; ///< smoothing factor of a step
    double longestPauseSteps;
    std::array<Voice, voiceCount> voices;
    std::array<TouchState, voiceCount> now;
    std::uint32_t pairCount = 0;
    std::vector<const Touch*> loudest;
};

} // namespace idiophone
