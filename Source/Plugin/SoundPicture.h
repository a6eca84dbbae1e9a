// Makes what the window shows of what was taken on the audio thread: figures of single modes out of
// those of groups, objects and notes out of slots.
#pragma once

#include "Editor/SoundView.h"
#include "Instrument/Instrument.h"
#include "Instrument/ModeSet.h"
#include "Instrument/SilencedModes.h"
#include "Parameters/ParameterTable.h"
#include "Plugin/SoundMonitor.h"

#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// What there is to be shown of; the instrument is not null.
struct PictureSubject {
    std::shared_ptr<const Instrument> instrument;
    int instrumentNumber = 0;
    ModeSet muted;
    ModeSet heardAlone;

    bool operator==(const PictureSubject&) const = default;
};

/// For the message thread.
class SoundPicture {
public:
    /// Changes where the instrument, or what is muted or heard alone, has changed.
    void show(PictureSubject subject);

    /// Of sound that was played on the subject's instrument; valid until the next call.
    const SoundFrame& of(const MonitoredSound& sound);

    /// What there is to see of a slot, which exists, while nothing is rendered.
    const SoundFrame& ofSilence(std::size_t slot, const ParameterValues& values, double rateHz);

private:
    void look(std::size_t slot);
    void groupModesOf(const MonitoredSound& sound);
    void addModes(const MonitoredSound& sound);
    ModeNow modeNow(const MonitoredSound& sound, std::size_t mode) const;
    void addSlots(const MonitoredSound& sound);
    void addBodies(std::span<const BodyPose> poses);

    PictureSubject subject;
    std::vector<int> objectOfSlot; ///< of ProcessorView::playedObjects
    std::vector<int> noteOfSlot;
    std::vector<bool> isOfOneKey;
    std::vector<std::int32_t> modesOfSlot;

    // Of the slot that is looked at.
    std::shared_ptr<const ModalObject> object;
    std::string key;                       ///< in mode sets
    std::vector<double> weights;           ///< [M] mean-square shapes
    std::vector<std::uint8_t> isSilenced;  ///< [M], or empty: none
    std::vector<std::int32_t> groupStarts; ///< [G+1]

    SoundFrame frame;
};

} // namespace idiophone
