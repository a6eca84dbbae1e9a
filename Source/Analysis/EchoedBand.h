// A few modes of one frequency band in a room. RoomSeparation chooses the bands.
#pragma once

#include "Analysis/RecordedStrikes.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace idiophone {

/// A room as dense weak echoes. Each of them strikes all modes again.
struct RoomEchoes {
    double energy = 0;         ///< of all echoes, relative to the direct sound
    double decayPerSecond = 1; ///< of their amplitudes
};

struct BandOfModes {
    double centreHz = 0, widthHz = 0;
    std::vector<std::size_t> modes; ///< indices, at least one
};

/// In a band, an echo adds a part of its amplitude to each mode. So the amplitudes walk at random,
/// ever less, and a Kalman filter whitens the walk and the noise together. Weighted so, a slow mode
/// is measured after the room has died away, a fast one before the room has built up.
class EchoedBand {
public:
    /// `rests` are the recordings without any sinusoid. The band's modes are added to them.
    EchoedBand(std::span<const RecordedStrike> strikes,
               std::span<const DecayRecording> rests,
               std::span<const DampedSinusoid> sinusoids,
               const BandOfModes& band);

    /// Returns false if the recordings are too short for the band's filter, or if the band reaches
    /// down to the negative frequencies of its modes. Then do not fit.
    bool isUsable() const;

    /// Moves the poles to the most likely ones in this room, and removes modes that the echoes and
    /// the noise explain as well. Returns the logarithm of how likely the room is, but for a
    /// constant.
    double fit(const RoomEchoes& room);

    const std::vector<std::size_t>& modes() const { return kept; } ///< those left
    DecayPole pole(std::size_t number) const;                      ///< of `modes()[number]`

private:
    /// One recording in the band.
    struct Strip {
        Eigen::VectorXcd samples;
        double noise = 0; ///< energy of a sample
        Eigen::VectorXcd amplitudes;
    };
    struct Evaluation {
        double likelihood = 0;   ///< logarithm, of the room
        Eigen::VectorXcd change; ///< of the poles, to the best ones
    };

    double move(const RoomEchoes& room);
    Evaluation evaluate(const RoomEchoes& room);
    double whiten(Eigen::MatrixXcd& columns, const Strip& strip, const RoomEchoes& room) const;
    Eigen::Index faintestMode(const RoomEchoes& room) const;
    void remove(Eigen::Index mode);
    Eigen::VectorXcd times() const;
    Eigen::MatrixXcd exponentials() const;

    double centreHz, widthHz;
    Eigen::Index count = 0;
    double step = 0, first = 0;
    std::vector<std::size_t> kept;
    Eigen::VectorXcd poles; ///< relative to the centre, per second
    std::vector<Strip> strips;
};

} // namespace idiophone
