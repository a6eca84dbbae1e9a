// A scene as people write it: what things there are, where they begin, what is done to them, and
// who listens. Plain data; SceneText reads it and SceneRun moves it. Metres, z points up.
#pragma once

#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// What a body is to the others that meet it.
enum class BodyForm {
    hull,     ///< the convex hull of its mesh; of a shell with half the thickness all around
    ring,     ///< round about the mesh's z axis, open in the middle: capsules or hulls of sectors
    sphere,   ///< as wide as the bounding box is on average, about its centre
    cylinder, ///< round about the mesh's z axis, closed at its ends
    surface,  ///< the mesh, smoothed; for fixed bodies that are hollow
    ground    ///< everything below the top of the mesh's bounding box; for fixed bodies
};

/// A solid ball too small to be heard itself: its lowest mode is beyond hearing.
struct SilentBall {
    double radiusMetres = 0.01;
    std::string material; ///< one of the library's
};

/// What several bodies have in common.
struct BodyTemplate {
    std::string name;
    std::string object; ///< the modal object: a factory object's name or a file's path
    std::optional<SilentBall> ball = {}; ///< instead of an object
    BodyForm form = BodyForm::hull;
    bool isFixed = false;
    double sizeRatio = 1; ///< the object scaled, 0.001 to 1000
    // Where nothing is said, those of the object's material.
    std::optional<double> friction = {};    ///< 0 to 10
    std::optional<double> restitution = {}; ///< 0 to 1
    /// The arm in metres with which the normal force brakes what rolls, 0 to 1.
    double rollingFrictionMetres = 0.0002;
    /// Of the curvature where it is touched, which Hertz's contact time asks for: 0 finds it from
    /// the form.
    double contactRadiusMetres = 0;
    std::optional<Surface> surface = {};  ///< what sliding and rolling on it sound like
    std::vector<std::size_t> passes = {}; ///< kinds that it does not collide with
};

/// Of a quantity that is drawn for each body: the mean, and how far it may stray on either side.
struct Scattered {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Vector3d reach = Eigen::Vector3d::Zero();
};

/// Bodies that come into the scene, evenly over a time.
struct Release {
    std::size_t kind = 0;
    int count = 1;
    double seconds = 0;     ///< of the first one
    double overSeconds = 0; ///< from the first to the last
    Scattered positionMetres;
    Scattered turnedDegrees; ///< about the direction of the vector, from the mesh's own position
    bool isTurnedAtRandom = false; ///< every direction is as likely
    Scattered velocityMetresPerSecond;
    Scattered spinTurnsPerSecond;
};

/// A throw of bodies that are there: all of a kind get new velocities where they are.
struct Kick {
    std::size_t kind = 0;
    double seconds = 0;
    Scattered velocityMetresPerSecond;
    Scattered spinTurnsPerSecond;
};

/// A bar for each key of a preset of bars, side by side along x from low to high, their lengths
/// along y; fixed, and as its objects sound.
struct KeyboardStage {
    std::string preset;           ///< a factory preset's name or a file's path
    double spacingMetres = 0.045; ///< from bar to bar
    Eigen::Vector3d positionMetres = Eigen::Vector3d::Zero(); ///< the middle of the bars' tops
};

/// A note drops a body so that it hits at the time of the note.
struct NoteDrop {
    std::size_t kind = 0;
    double softestMetres = 0.02;             ///< the height of a fall at velocity 1
    double hardestMetres = 0.8;              ///< at velocity 127
    Eigen::Vector2d reachMetres{0, 0};       ///< how far it may stray along x and y
    double lifeSeconds = 1.5;                ///< from its first contact until it is taken away
    Eigen::Vector3d positionMetres{0, 0, 0}; ///< where it hits, where there is no keyboard
};

/// What a key of the plugin does with bodies that do not come from `NoteDrop`: all of them begin
/// anew, from softest to hardest.
struct KeyThrow {
    std::array<double, 2> raisedMetres{0, 0.3}; ///< how much higher than they are placed
    std::array<double, 2> speedRatios{1, 1};    ///< times the speeds they are given
};

/// What a hand does to one body, as it was recorded: it taps and scrapes with a tool. Places are in
/// the coordinates of the body's mesh, in its size; the nearest ones on the surface count.
struct Hand {
    struct Moment {
        double seconds = 0;
        Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero();
        double newtons = 0; ///< with which the tool is pressed on; 0: it does not touch
    };
    struct Tap {
        double seconds = 0;
        Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero();
        double metresPerSecond = 0; ///< > 0
    };

    std::size_t kind = 0;     ///< of which the first body is played
    std::size_t tool = 0;     ///< whose mass, radius, material and surface the tool has
    std::vector<Moment> path; ///< ascending in time; straight and even in between
    std::vector<Tap> taps;    ///< likewise
};

struct Listener {
    Eigen::Vector3d positionMetres{0, -1.5, 1.5};
    Eigen::Vector3d towardsMetres{0, 0, 0.5};
};

struct Scene {
    std::string name;
    std::string description;
    double seconds = 10; ///< it lasts at least; then until it is silent
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
