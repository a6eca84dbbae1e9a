// SPDX-License-Identifier: Apache-2.0
// Bodies that a game or another program moves, strikes and presses, and what a listener hears of
// them. It computes no motion.
#pragma once

#include "Object/Result.h"
#include "Synth/Surface.h"
#include "Synth/SynthesiserSlot.h"
#include "World/HeadModel.h"
#include "World/HeadResponses.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

class ObjectSurface;
class WorldMixer;

struct WorldSettings {
    double sampleRateHz = 48000; ///< 8000 to 384000
    /// Surfaces for touches, which name them by their indices. Not empty.
    std::vector<Surface> surfaces = {Surface{}};
    /// Nothing: everything is heard at the struck place or at 1 m, wherever the bodies are, as
    /// `idiophone render --impulses` does.
    std::optional<Listener> listener = Listener{};
    /// A measured head at the sample rate; null: a sphere.
    std::shared_ptr<const HeadResponses> head = {};
    std::size_t eventCapacity = 4096; ///< calls that may wait for the next cell, 16 to 1048576
    std::uint64_t seed = 1;           ///< of the noise of touches
    /// At first, until `setSynthesis`.
    SynthesisSettings synthesis = {.tau = 0.1, .radiation = 1};
};

/// The place of a body: the origin and the axes (columns) of its object's coordinates.
struct WorldPose {
    Eigen::Vector3d originMetres = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< a rotation
};

struct WorldImpact {
    std::size_t body = 0;
    double seconds = 0; ///< by the world's clock, ±1e9; a time that has passed means at once
    /// A vertex with shapes of the object's mesh; without one the place nearest to `pointMetres` is
    /// struck.
    std::optional<std::int64_t> vertex = {};
    Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero();
    Eigen::Vector3d impulseNewtonSeconds = Eigen::Vector3d::Zero(); ///< acts on the body
    double contactSeconds = 0;                                      ///< 0 to 1; 0: an ideal impulse
};

/// A body that slides or rolls on another.
struct WorldTouch {
    std::size_t body = 0;
    std::optional<std::size_t> other = {}; ///< sounds too, if it is a body of the world
    Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero();
    double forceNewtons = 0; ///< presses the bodies together
    /// The velocity of the other surface past the body's.
    Eigen::Vector3d slideMetresPerSecond = Eigen::Vector3d::Zero();
    double rollMetresPerSecond = 0;
    std::size_t surface = 0; ///< index into WorldSettings::surfaces
};

/// Whether a world did what it was told. If not, nothing changed.
enum class WorldAnswer {
    done,
    invalid, ///< a number is out of range, or a body, vertex, surface or touch does not exist
    busy     ///< `eventCapacity` calls wait for `render`, or all touches are in use
};

/// One thread calls `render`; one other may call all other members at the same time. None of them
/// waits for the other, and `render` neither allocates, locks nor throws. What the other thread
/// says takes effect in the next cell of 64 samples, and impacts at their time within it. Positions
/// are in metres in the world's coordinates.
class World {
public:
    /// Fails with one sentence if there is no body or a setting is out of range. Bodies may share
    /// objects; they stand at the origin. A body's object and size stay.
    static Result<std::unique_ptr<World>> make(std::vector<SynthesiserSlot> bodies,
                                               const WorldSettings& settings = {});
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    std::size_t bodyCount() const { return bodies.size(); }
    double sampleRateHz() const { return rateHz; }
    /// [any thread] Returns the world's clock: what has been rendered, to a cell.
    double seconds() const noexcept;
    /// [any thread] Returns how many impacts were left out because a mode of so light an object
    /// would have moved faster than 1e17 m/s.
    std::int64_t impactsLeftOut() const noexcept;

    WorldAnswer place(std::size_t body, const WorldPose& pose);
    WorldAnswer placeListener(const Listener& listener); ///< invalid without a listener
    WorldAnswer strike(const WorldImpact& impact);

    /// Returns a touch that is not in use, or nothing if all 24 are. A touch sounds from
    /// the first `touch` until `endTouch`.
    std::optional<std::size_t> beginTouch();
    WorldAnswer touch(std::size_t number, const WorldTouch& touch);
    WorldAnswer endTouch(std::size_t number);

    /// Sets truncation, budget, quality, pitch and radiation of all bodies.
    WorldAnswer setSynthesis(const SynthesisSettings& settings);
    const SynthesisSettings& synthesis() const { return settingsNow; }
    /// Replaces the material of a body, or restores its object's.
    WorldAnswer setMaterial(std::size_t body, const std::optional<LiveMaterial>& material);
    /// Damps a body further, by e^{−dt}; 0: no more.
    WorldAnswer setDamping(std::size_t body, double dampingPerSecond);
    WorldAnswer setGain(double gain); ///< of everything; 1 at first: full scale is 1 Pa or 1 m/s

    /// Writes the next samples: the left and right ear, of the same length.
    void render(std::span<float> left, std::span<float> right) noexcept;
    /// [render's thread] Returns whether nothing sounds or waits.
    bool silent() const noexcept;
    /// [render's thread] Returns the modes mixed in the current cell.
    std::int64_t modesMixed() const noexcept;

private:
    using Answer = WorldAnswer;
    struct Body {
        std::shared_ptr<const ModalObject> object;
        std::shared_ptr<const ObjectSurface> surface; ///< not scaled
        double sizeRatio = 1;
        WorldPose pose;

        Eigen::Vector3d own(const Eigen::Vector3d& placeMetres) const;
        Eigen::Vector3d middleMetres() const;
    };
    struct Touch {
        bool isInUse = false;
        std::uint32_t pair = 0; ///< counts the uses of all touches; 0 before the first `touch`
    };

    World(std::vector<SynthesiserSlot> bodies, const WorldSettings& settings);

    template <class Event>
    Answer say(const Event& event);
    std::int32_t directionTowardsListener(const Body& body) const;

    double rateHz;
    std::vector<Body> bodies;
    std::optional<Listener> listener;
    std::size_t surfaceCount;
    std::vector<Touch> touches;
    SynthesisSettings settingsNow; ///< those set last
    std::size_t nextTouch = 0;     ///< the one that ended longest ago, if it is free
    std::uint32_t pairs = 0;
    std::unique_ptr<WorldMixer> mixer; ///< the audio thread's half, and the queue to it
};

} // namespace idiophone
