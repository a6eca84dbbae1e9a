// Contacts that last, step by step as physics tells them, as a few voices that each stay with one
// pair of bodies for as long as it touches.
#pragma once

#include "Scene/Contact.h"
#include "Scene/SceneCast.h"
#include "Synth/ForceCell.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// What a voice does at a moment.
struct TouchState {
    std::uint32_t pair = 0;    ///< counts the pairs that a voice has had; 0 before the first
    std::size_t soundRole = 0; ///< of the two, whose surface is heard
    std::array<std::size_t, 2> slots{};
    std::array<ForcePoint, 2> points{}; ///< where each is pressed, for a newton
    double forceNewtons = 0;
    double slideMetresPerSecond = 0;
    double rollMetresPerSecond = 0;
};

/// One thread at a time; not for the audio thread.
class TouchTracker {
public:
    static constexpr std::size_t voiceCount = 24;
    static_assert(voiceCount <= forceCapacity);

    TouchTracker(std::shared_ptr<const SceneCast> cast, double stepSeconds);

    /// A step's touches. `roles` and `slots` are those of each body.
    void follow(std::span<const Touch> touches,
                std::span<const std::size_t> roles,
                std::span<const std::size_t> slots);

    std::span<const TouchState, voiceCount> states() const { return now; }

private:
    struct Voice {
        std::array<std::size_t, 2> bodies{};
        std::array<Eigen::Vector3d, 2> pointMetres; ///< where `points` are
        double fadeSteps = 0;                       ///< until it is free: it touched lately
        bool isPlaced = false;                      ///< whether its points are known
    };

    std::size_t voiceFor(const Touch& touch);
    void move(std::size_t voice, const Touch& touch, std::span<const std::size_t> roles);

    std::shared_ptr<const SceneCast> cast;
    double share; ///< by which the figures follow in a step
    double longestPauseSteps;
    std::array<Voice, voiceCount> voices;
    std::array<TouchState, voiceCount> now;
    std::uint32_t pairCount = 0;
    std::vector<const Touch*> loudest;
};

} // namespace idiophone
