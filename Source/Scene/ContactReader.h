// From what Bullet's solver did in a step to blows and lasting contacts.
#pragma once

#include "Scene/Contact.h"
#include "Scene/RigidBodyModel.h"

#include <Eigen/Geometry>
#include <btBulletDynamicsCommon.h>
#include <span>
#include <vector>

namespace idiophone {

/// A body as it was when the step began.
struct BodyInStep {
    const RigidBodyModel* model = nullptr;
    const btRigidBody* rigid = nullptr;
    Eigen::Isometry3d worldFromMesh = Eigen::Isometry3d::Identity();
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of mass, in metres
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< m/s, of it
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();     ///< rad/s

    Eigen::Vector3d velocityAt(const Eigen::Vector3d& place) const {
        return velocity + spin.cross(place - centre);
    }
};

/// For each step `begin`, `read` for every pair of bodies, `finish`; from then on `impacts` and
/// `touches` are the step's. One thread at a time; allocates.
class ContactReader {
public:
    ContactReader(double stepSeconds, double gravityMetresPerSecond2);

    void begin(double seconds); ///< at which the step began
    /// `bodies` are found by the user index of Bullet's.
    void read(const btPersistentManifold& manifold, std::span<const BodyInStep> bodies);
    void finish(); ///< puts what was read in order

    std::span<const Impact> impacts() const { return blows; }
    std::span<const Touch> touches() const { return lasting; }

private:
    struct Point;
    struct Pressing;

    static Point pointOf(const btManifoldPoint& contact,
                         std::span<const BodyInStep> bodies,
                         std::size_t firstNumber,
                         std::size_t secondNumber);
    void addImpact(const Point& point);
    void addTouch(const Pressing& pressing,
                  std::span<const BodyInStep> bodies,
                  std::size_t firstNumber,
                  std::size_t secondNumber);

    double stepSeconds;
    double restingSpeed; ///< what a step of gravity gives
    double slowestBlow;  ///< m/s
    double startSeconds = 0;
    std::vector<Impact> blows;
    std::vector<Touch> lasting;
};

} // namespace idiophone
