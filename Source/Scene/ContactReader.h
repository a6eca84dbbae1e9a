// Turns the contacts that Bullet solved in a step into impacts and lasting contacts.
#pragma once

#include "Scene/Contact.h"
#include "Scene/RigidBodyModel.h"

#include <Eigen/Geometry>
#include <btBulletDynamicsCommon.h>
#include <span>
#include <vector>

namespace idiophone {

/// The state of a body at the beginning of the step.
struct BodyInStep {
    const RigidBodyModel* model = nullptr;
    const btRigidBody* rigid = nullptr;
    Eigen::Isometry3d worldFromMesh = Eigen::Isometry3d::Identity();
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of mass, in metres
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< of the centre, in m/s
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();     ///< rad/s

    Eigen::Vector3d velocityAt(const Eigen::Vector3d& place) const {
        return velocity + spin.cross(place - centre);
    }
};

/// In each step call `begin`, `read` for every pair of bodies, then `finish`. After that, `impacts`
/// and `touches` return those of the step. One thread at a time. Allocates.
class ContactReader {
public:
    ContactReader(double stepSeconds, double gravityMetresPerSecond2);

    void begin(double seconds); ///< at the beginning of the step
    /// Bullet's user index of a body is its index in `bodies`.
    void read(const btPersistentManifold& manifold, std::span<const BodyInStep> bodies);
    void finish(); ///< sorts the results

    std::span<const Impact> impacts() const { return collected; }
    std::span<const Touch> touches() const { return lasting; }

private:
    struct Pair {
        std::size_t firstNumber, secondNumber;
        const BodyInStep &first, &second;
    };
    struct Point;
    struct Pressing;

    static Point pointOf(const btManifoldPoint& contact, const Pair& pair);
    void addImpact(const Point& point, const Pair& pair);
    void addTouch(const Pressing& pressing, const Pair& pair);

    double stepSeconds;
    double restingSpeed;  ///< speed that gravity adds in a step
    double slowestStrike; ///< m/s
    double startSeconds = 0;
    std::vector<Impact> collected;
    std::vector<Touch> lasting;
};

} // namespace idiophone
