// The state of the sound for the window, and muting or soloing of modes. The processor implements
// it. Contains numbers, no audio.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace idiophone {

enum class ModeStanding : std::uint8_t {
    belowTau,     ///< silent, or dropped by τ
    sounding,     ///< mixed
    beyondBudget, ///< above τ, but excluded by its object's share of the budget
    outOfBand,    ///< outside the audible band
    silenced      ///< muted, or others are soloed
};

/// One mode, with the current material, size, thickness and tuning.
struct ModeNow {
    std::int32_t group = 0; ///< modes with the same number are merged
    float frequencyHz = 0;  ///< damped; natural if the mode does not oscillate
    float t60Seconds = 0;   ///< time to fall by 60 dB without a damper
    float amplitude = 0;    ///< m/s, full scale is 1; share of its group's amplitude
    ModeStanding standing = ModeStanding::belowTau;
    bool isMuted = false;
    bool isHeardAlone = false;

    bool operator==(const ModeNow&) const = default;
};

/// One key's state of an object. Keys that share a scaled object each have a slot.
struct SlotNow {
    int object = 0;                ///< index into InstrumentView::playedObjects
    int note = -1;                 ///< lowest MIDI note that plays it
    float amplitude = 0;           ///< sum over its modes, m/s
    std::int32_t modesRinging = 0; ///< modes or groups above τ, which request budget
    std::int32_t share = 0;        ///< modes or groups within the budget, at most modesRinging
    std::int32_t modesMixed = 0;
    float entitlement = 0; ///< share of the budget in modes, by the rank on the line of slope S

    bool operator==(const SlotNow&) const = default;
};

/// A body on a stage: an object and its pose. Metres; z points up.
struct BodyNow {
    int object = 0;                        ///< index into InstrumentView::playedObjects
    std::array<float, 3> originMetres{};   ///< position of the mesh's origin
    std::array<float, 4> turn{0, 0, 0, 1}; ///< rotation, unit quaternion x, y, z, w

    bool operator==(const BodyNow&) const = default;
};

struct SoundFrame {
    int instrumentNumber = 0; ///< InstrumentView::instrumentNumber
    int object = -1; ///< index into playedObjects of the object that has `modes`; −1: none
    int note = -1;   ///< MIDI note of the slot that has `modes`; −1: several keys
    std::vector<ModeNow> modes;    ///< ascending, unless own damping moves a mode
    std::int32_t modesOmitted = 0; ///< further modes of the object, too many to show
    std::vector<SlotNow> slots;    ///< sounding slots, loudest first

    std::vector<BodyNow> bodies; ///< only on a stage
    std::int32_t velocity = 0;   ///< MIDI velocity of the mallet's last strike; 0: none yet

    double tauPascals = 0;  ///< τ; modes below it are dropped
    double slope = 1;       ///< S
    double budgetModes = 0; ///< Q

    std::int32_t modesMixed = 0;   ///< sounding groups of all slots
    std::int32_t modesDropped = 0; ///< in sounding slots: groups in the band below τ
    std::int32_t modesBeyond = 0;  ///< in sounding slots: above τ, but excluded by the budget
    std::int32_t modesMerged = 0;  ///< in sounding slots: modes minus groups

    float load = 0;     ///< share of one processor core, 0 to 1
    float peakLeft = 0; ///< output peak since the last frame; full scale is 1
    float peakRight = 0;

    bool operator==(const SoundFrame&) const = default;
};

/// For the message thread. Objects are indices into InstrumentView::playedObjects; those that do
/// not exist are ignored.
class SoundView {
public:
    virtual ~SoundView() = default;

    /// The newest frame since the last call, or nullptr if there is none or no sound is rendered.
    /// Valid until the next call. Regular calls get about 30 frames a second.
    virtual const SoundFrame* takeSoundFrame() = 0;

    /// Selects the object whose modes the frames contain. Nothing: always the object played last.
    virtual void watchObject(std::optional<std::size_t> object) = 0;
    virtual std::optional<std::size_t> watchedObject() const = 0;

    /// Mutes or unmutes a mode, numbered as in the object. Muted modes are saved with the sound.
    /// Returns false if the mode does not exist or too many are muted.
    virtual bool muteMode(std::size_t object, std::int32_t mode, bool isMuted) = 0;
    /// Solos a mode. While an object has soloed modes, its other modes are silent; other objects
    /// are not affected. Not saved, and dropped with the instrument.
    virtual bool hearModeAlone(std::size_t object, std::int32_t mode, bool isAlone) = 0;
    /// Unmutes all modes of the object, or ends all its solos.
    virtual void unmuteModes(std::size_t object) = 0;
    virtual void hearAllModes(std::size_t object) = 0;
};

} // namespace idiophone
