// Assigns lasting contacts to a few voices. A voice stays with one pair of bodies as long as they
// touch.
#pragma once

#include "Scene/Contact.h"
#include "Scene/SceneAssets.h"
#include "World/TouchVoices.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// One thread at a time. Not for the audio thread.
class TouchTracker {
public:
    TouchTracker(std::shared_ptr<const SceneAssets> assets, double stepSeconds);

    /// Takes the contacts of a step. `roles` and `slots` are indexed by body.
    void follow(std::span<const Touch> touches,
                std::span<const std::size_t> roles,
                std::span<const std::size_t> slots);

    std::span<const TouchState, touchVoices> states() const { return now; }

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
    std::array<Voice, touchVoices> voices;
    std::array<TouchState, touchVoices> now;
    std::uint32_t pairCount = 0;
    std::vector<const Touch*> loudest;
};

} // namespace idiophone
