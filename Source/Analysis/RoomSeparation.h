// Tells the modes of an object from the room that repeats them.
#pragma once

#include "Analysis/EchoedBand.h"
#include "Object/WorkControl.h"

#include <span>
#include <vector>

namespace idiophone {

/// Least squares explain a room by more modes and by bent decays. This estimates the room first,
/// then the modes in it, band by band.
class RoomSeparation {
public:
    /// `modes` and `steady` are all sinusoids that the strikes hold. The arguments must outlive
    /// this object.
    RoomSeparation(std::span<const RecordedStrike> strikes,
                   std::span<const DampedSinusoid> modes,
                   std::span<const DampedSinusoid> steady);

    /// Returns the most likely of several rooms, judged by the loudest bands: −40 to −20 dB, with a
    /// T60 of 0.2 to 0.8 s. An energy of 0 is a dry recording.
    RoomEchoes room(const WorkControl& control) const;

    /// Returns the poles of the modes in this room. Modes that the room explains are left out. A
    /// band in which modes explain much less so stays as it is: it is no room of this kind. If the
    /// work is cancelled, the result is of no use.
    std::vector<DecayPole> polesIn(const RoomEchoes& room, const WorkControl& control) const;

private:
    struct Band {
        BandOfModes all;
        std::vector<std::size_t> own; ///< modes near the centre, which this band decides
    };

    void chooseBands();
    bool explainsEnough(const EchoedBand& separated, const Band& band) const;

    std::span<const RecordedStrike> strikes;
    std::span<const DampedSinusoid> modes;
    std::vector<DecayRecording> rests; ///< the strikes without any sinusoid
    std::vector<Band> bands;           ///< the loudest first; each mode is one band's own
};

} // namespace idiophone
