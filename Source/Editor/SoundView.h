// What the window shows of the sound as it is now, and by which modes are muted or heard alone. The
// processor implements it; figures only, no audio.
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
    beyondBudget, ///< above τ, and left out by its object's share of the budget
    outOfBand,    ///< too low or too high to sound
    silenced      ///< muted, or others are heard alone
};

/// One mode of an object with the material, size, thickness and tuning of now.
struct ModeNow {
    std::int32_t group = 0; ///< modes of one number sound as one
    float frequencyHz = 0;  ///< damped; of one that does not oscillate the natural one
    float t60Seconds = 0;   ///< in which it falls by 60 dB, no damper touching it
    float amplitude = 0;    ///< m/s, full scale is 1; its share of its group's
    ModeStanding standing = ModeStanding::belowTau;
    bool isMuted = false;
    bool isHeardAlone = false;

    bool operator==(const ModeNow&) const = default;
};

/// One key's state of an object: keys that share a scaled object each have their own.
struct SlotNow {
    int object = 0;                ///< of ProcessorView::playedObjects
    int note = -1;                 ///< the lowest MIDI note that plays it
    float amplitude = 0;           ///< summed over its modes, m/s
    std::int32_t modesRinging = 0; ///< above τ: what it asks of the budget, in modes or groups
    std::int32_t share = 0;        ///< of the budget, no more than ring
    std::int32_t modesMixed = 0;
    float entitlement = 0; ///< modes, by its rank on the line of slope S

    bool operator==(const SlotNow&) const = default;
};

/// A body on a stage: an object in its size, where it is. Metres, z points up.
struct BodyNow {
    int object = 0;                        ///< of ProcessorView::playedObjects
    std::array<float, 3> originMetres{};   ///< of the object's own mesh
    std::array<float, 4> turn{0, 0, 0, 1}; ///< a unit quaternion x, y, z, w

    bool operator==(const BodyNow&) const = default;
};

struct SoundFrame {
    int instrumentNumber = 0;      ///< ProcessorView::instrumentNumber
    int object = -1;               ///< of playedObjects: whose modes these are; −1: none
    int note = -1;                 ///< MIDI: the one key of their slot; −1: it has several
    std::vector<ModeNow> modes;    ///< ascending in frequency but for what own dampings do
    std::int32_t modesOmitted = 0; ///< of the object beyond those, which are too many to show
    std::vector<SlotNow> slots;    ///< those that sound, loudest first

    std::vector<BodyNow> bodies; ///< of an instrument on a stage

    double tauPascals = 0;  ///< modes below are dropped
    double slope = 1;       ///< S
    double budgetModes = 0; ///< Q

    std::int32_t modesMixed = 0;   ///< groups that sound, of all slots
    std::int32_t modesDropped = 0; ///< of the slots that sound: groups in the band below τ
    std::int32_t modesBeyond = 0;  ///< of them: above τ, and left out by the budget
    std::int32_t modesMerged = 0;  ///< of them: modes less groups

    float load = 0;     ///< of one processor, 0 to 1
    float peakLeft = 0; ///< of the output since the last frame; full scale is 1
    float peakRight = 0;

    bool operator==(const SoundFrame&) const = default;
};

/// For the message thread. Objects are indices into ProcessorView::playedObjects; what does not
/// exist is ignored.
class SoundView {
public:
    virtual ~SoundView() = default;

    /// The newest frame since this was asked last, or nullptr where there is none, as when no sound
    /// is rendered. Valid until the next call. While it is asked for there are about 30 a second.
    virtual const SoundFrame* takeSoundFrame() = 0;

    /// Whose modes the frames show; nothing: always the object that was played last.
    virtual void watchObject(std::optional<std::size_t> object) = 0;
    virtual std::optional<std::size_t> watchedObject() const = 0;

    /// Modes are numbered as in the object. Muted ones are saved with the sound. False where the
    /// mode does not exist or too many are muted.
    virtual bool muteMode(std::size_t object, std::int32_t mode, bool isMuted) = 0;
    /// While any mode of an object is heard alone, no others of it are heard, muted or not; those
    /// of other objects are. Only for listening: neither saved nor kept for another instrument.
    virtual bool hearModeAlone(std::size_t object, std::int32_t mode, bool isAlone) = 0;
    /// Nothing of the object is muted, or heard alone, any more.
    virtual void unmuteModes(std::size_t object) = 0;
    virtual void hearAllModes(std::size_t object) = 0;
};

} // namespace idiophone
