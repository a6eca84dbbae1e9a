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
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< of mass
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();

    Eigen::Vector3d velocityAt(const Eigen::Vector3d& place) const {
        return velocity + spin.cross(place - centre);
    }
};

class ContactReader {
public:
    ContactReader(double stepSeconds, double gravityMetresPerSecond2);

    /// `bodies` by the user index of Bullet's; the step began at `seconds`.
    void begin(double seconds);
    void read(const btPersistentManifold& manifold, std::span<const BodyInStep> bodies);
    void finish(); ///< puts what was read in order

    std::span<const Impact> impacts() const { return blows; }
    std::span<const Touch> touches() const { return lasting; }

private:
    struct Point;

    void addImpact(const Point& point);

    double stepSeconds;
    double restingSpeed; ///< what a step of gravity gives
    double slowestBlow;  ///< m/s
    double startSeconds = 0;
    std::vector<Impact> blows;
    std::vector<Touch> lasting;
};

} // namespace idiophone
