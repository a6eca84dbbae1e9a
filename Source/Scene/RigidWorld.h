// Moves rigid bodies with Bullet and reports the impacts and contacts that sound.
#pragma once

#include "Scene/Contact.h"
#include "Scene/RigidBodyModel.h"

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

class WorkTeam;

struct BodyMotion {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(); ///< from mesh coordinates to the world
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();     ///< of the centre of mass, in m/s
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();         ///< rad/s
};

/// The same calls give the same bits on one machine. One thread at a time. Not for the audio
/// thread.
class RigidWorld {
public:
    struct Kind {
        std::shared_ptr<const RigidBodyModel> model;
        int group = 1;         ///< one of 30 bits
        int collidesWith = ~0; ///< groups; both kinds must include the other's
    };

    /// The maximum number of pairs of nearby bodies, and of nearby body parts (a flat ring has
    /// several). Each pair takes memory, about a gigabyte at the maximum. A heap of thousands of
    /// bodies has as many pairs, as do 300 bodies in one place. A hundred rings have 560 pairs of
    /// bodies and 660 of parts.
    static constexpr int maximumPairs = 50'000;

    /// `team` outlives it and shares the collisions, with the same results. It may be null.
    RigidWorld(std::vector<Kind> kinds,
               double stepsPerSecond,
               double gravityMetresPerSecond2,
               WorkTeam* team = nullptr);
    ~RigidWorld();

    /// Adds a body from the next step on and returns its number. Numbers count from 0 and are not
    /// reused.
    std::size_t add(std::size_t kind, const BodyMotion& motion);
    /// Reserves a number that never has a rigid body, for example for a hand.
    std::size_t addAbsent();
    void remove(std::size_t body);
    BodyMotion motion(std::size_t body) const;      ///< not of a removed body
    Eigen::Vector3d centre(std::size_t body) const; ///< of mass; not of a removed body
    /// In m/s and rad/s; not of a removed body.
    void
    setVelocity(std::size_t body, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin);

    /// Advances by one step. Later steps report no impact before `seconds() - stepSeconds()`.
    void step();
    double seconds() const;
    double stepSeconds() const;
    /// Returns whether the pairs of bodies, or of their parts, exceeded `maximumPairs`. The bodies
    /// of further pairs pass through each other, so that further steps are useless.
    bool isCrowded() const;
    /// Returns the work of all steps since construction, in units of about a microsecond: bodies
    /// and their pairs.
    double work() const;
    std::span<const Impact> impacts() const; ///< of the last step, in order of time
    std::span<const Touch> touches() const;  ///< of the last step, in order of bodies

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
};

} // namespace idiophone
