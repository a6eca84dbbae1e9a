// A scene as its file describes it: kinds of bodies, where they start, how they move, and who
// listens. Plain data. SceneText reads it and SceneSimulation moves it. Lengths are in metres; z
// points up.
#pragma once

#include "Object/ModalObject.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"
#include "World/HeadModel.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// The shape of a body in collisions.
enum class BodyForm {
    hull,     ///< convex hull of the mesh; a shell extends by half its thickness all around
    ring,     ///< about the mesh's z axis, open in the middle: round, or hulls of sectors
    sphere,   ///< centred in the bounding box, as wide as its mean size
    cylinder, ///< about the mesh's z axis, with closed ends
    surface,  ///< the smoothed mesh, for hollow fixed bodies
    ground,   ///< everything below the top of the mesh's bounding box, for fixed bodies
    mesh      ///< the mesh as it is, for fixed bodies: rooms, stairs
};

/// Returns whether faces collide, smoothed or not.
constexpr bool hasFaces(BodyForm form) {
    return form == BodyForm::surface || form == BodyForm::mesh;
}

/// The common properties of bodies of one kind.
struct BodyTemplate {
    std::string name;
    std::string object; ///< modal object: a factory object's name or a file's path
    /// Replaces `object` if it is not null. A body whose object has no modes is not heard.
    std::shared_ptr<const ModalObject> given = {};
    BodyForm form = BodyForm::hull;
    bool isFixed = false;
    double sizeRatio = 1; ///< scale of the object, 0.001 to 1000
    // If not set, the values of the object's material apply.
    std::optional<double> friction = {};    ///< 0 to 10
    std::optional<double> restitution = {}; ///< 0 to 1
    /// Lever arm in metres with which the normal force brakes rolling, 0 to 1.
    double rollingFrictionMetres = 0.0002;
    /// Radius of curvature at the contact, for the Hertz contact time. 0 derives it from the form.
    double contactRadiusMetres = 0;
    std::optional<Surface> surface = {};  ///< the sound of sliding and rolling on it
    std::vector<std::size_t> passes = {}; ///< kinds that it does not collide with
};

/// A quantity drawn at random for each body: the mean, and the maximum deviation on either side.
struct Scattered {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Vector3d reach = Eigen::Vector3d::Zero();
};

/// Bodies that enter the scene at even intervals.
struct Release {
    std::size_t kind = 0;
    int count = 1;
    double seconds = 0;     ///< time of the first body
    double overSeconds = 0; ///< from the first body to the last
    Scattered positionMetres;
    Scattered turnedDegrees;       ///< rotation vector, relative to the mesh's own orientation
    bool isTurnedAtRandom = false; ///< uniform over all orientations
    Scattered velocityMetresPerSecond;
    Scattered spinTurnsPerSecond;
};

/// Throws bodies that are in the scene: all bodies of a kind get new velocities where they are.
struct Kick {
    std::size_t kind = 0;
    double seconds = 0;
    Scattered velocityMetresPerSecond;
    Scattered spinTurnsPerSecond;
};

/// A fixed bar for each key of a preset of bars. They lie side by side along x from low to high,
/// lengthwise along y, and sound as the preset's objects.
struct KeyboardStage {
    std::string preset;           ///< a factory preset's name or a file's path
    double spacingMetres = 0.045; ///< from bar to bar
    Eigen::Vector3d positionMetres = Eigen::Vector3d::Zero(); ///< middle of the bars' tops
};

/// A note drops a body so that it hits at the time of the note.
struct NoteDrop {
    std::size_t kind = 0;
    double softestMetres = 0.02;             ///< height of the fall at velocity 1
    double hardestMetres = 0.8;              ///< height of the fall at velocity 127
    Eigen::Vector2d reachMetres{0, 0};       ///< maximum deviation along x and y
    double lifeSeconds = 1.5;                ///< from the first contact until the body is removed
    Eigen::Vector3d positionMetres{0, 0, 0}; ///< where the body hits if there is no keyboard
};

/// A key of the plugin restarts all bodies that do not come from `NoteDrop`. Each pair holds the
/// values of the softest and the hardest note.
struct KeyThrow {
    std::array<double, 2> raisedMetres{0, 0.3}; ///< height above the initial place
    std::array<double, 2> speedRatios{1, 1};    ///< factor of the initial speeds
};

/// A recorded hand that taps and scrapes one body with a tool. Places are in the mesh coordinates
/// of the scaled body and are moved to the nearest point of its surface.
struct Hand {
    struct Moment {
        double seconds = 0;
        Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero();
        double newtons = 0; ///< force on the tool; 0: no contact
    };
    struct Tap {
        double seconds = 0;
        Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero();
        double metresPerSecond = 0; ///< > 0
    };

    std::size_t kind = 0;     ///< kind whose first body is played
    std::size_t tool = 0;     ///< kind that gives the tool its mass, radius, material and surface
    std::vector<Moment> path; ///< ascending in time; linear in between
    std::vector<Tap> taps;    ///< ascending in time
};

inline constexpr int maximumSceneBodies = 10000; ///< of a file

struct Scene {
    std::string name;
    std::string description;
    double seconds = 10; ///< minimum duration; the scene then lasts until it is silent
    std::uint32_t seed = 1;
    double stepsPerSecond = 2000; ///< of the rigid bodies, 1000 to 20000
    double gravityMetresPerSecond2 = 9.81;
    std::vector<BodyTemplate> kinds;
    std::vector<Release> releases;
    std::vector<Kick> kicks;
    std::optional<KeyboardStage> keyboard;
    std::optional<NoteDrop> noteDrop;
    KeyThrow keyThrow;
    std::optional<Hand> hand;
    Listener listener;
    ParameterValues parameters;
};

} // namespace idiophone
