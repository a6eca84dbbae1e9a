// Rigid bodies that fall, collide, slide and roll, and what is to be heard of it. On Bullet.
#pragma once

#include "Scene/Contact.h"
#include "Scene/RigidBodyModel.h"

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

struct BodyMotion {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(); ///< from mesh coordinates to the world
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();     ///< m/s, of the centre of mass
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();         ///< rad/s
};

/// The same calls give the same bits on one machine. One thread at a time; not for the audio
/// thread.
class RigidWorld {
public:
    struct Kind {
        std::shared_ptr<const RigidBodyModel> model;
        int group = 1;         ///< one bit of 30
        int collidesWith = ~0; ///< bits of groups, of which those must collide with this one too
    };

    /// Pairs of bodies that are close enough to be looked at, and likewise of their parts (of which
    /// a ring has some), each of which takes memory: about a gigabyte in all. A heap of thousands
    /// has as many, or 300 bodies in one place; a hundred rings have 1300, and 4400 of parts.
    static constexpr int mostPairs = 50'000;

    RigidWorld(std::vector<Kind> kinds, double stepsPerSecond, double gravityMetresPerSecond2);
    ~RigidWorld();

    /// A body that is there from the next step on; bodies are numbered from 0, and a number is not
    /// given again.
    std::size_t add(std::size_t kind, const BodyMotion& motion);
    /// A number for what is no rigid body and has none ever, such as a hand.
    std::size_t addAbsent();
    void remove(std::size_t body);
    bool has(std::size_t body) const;
    BodyMotion motion(std::size_t body) const;      ///< of one that is there
    Eigen::Vector3d centre(std::size_t body) const; ///< of mass, likewise
    /// m/s and rad/s, of one that is there.
    void
    setVelocity(std::size_t body, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin);

    /// One step on. What it reports is over by then: no later step reports an impact before
    /// `seconds()` less a step.
    void step();
    double seconds() const;
    double stepSeconds() const;
    /// Whether there were more pairs of bodies, or of their parts, than `mostPairs`. Those beyond
    /// pass through each other, so that a world is not worth another step then.
    bool isCrowded() const;
    /// What all steps together took, of about a microsecond each: bodies, and pairs of them.
    double work() const;
    std::span<const Impact> impacts() const; ///< of the last step, in order of time
    std::span<const Touch> touches() const;  ///< of the last step, in order of bodies

    const RigidBodyModel& model(std::size_t kind) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
};

} // namespace idiophone
