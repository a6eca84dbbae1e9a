// Converts monitored sound into frames for the window: groups into single modes, slots into objects
// and notes.
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

/// The instrument to show, never null, and its muted modes.
struct PictureSubject {
    std::shared_ptr<const Instrument> instrument;
    int instrumentNumber = 0;
    ModeSet muted;
    ModeSet heardAlone;

    bool operator==(const PictureSubject&) const = default;
};

/// Returns the bodies that are there, for poses and objects (`objectsOfSlots`) of slots.
std::vector<BodyNow> bodiesAt(std::span<const BodyPose> poses, std::span<const int> objectOfSlot);

/// For the message thread.
class SoundPicture {
public:
    /// Chooses the subject; updates the tables if it has changed.
    void show(PictureSubject subject);

    /// Returns the frame of sound played on the subject's instrument; valid until the next call.
    const SoundFrame& of(const MonitoredSound& sound);

    /// Returns the frame of an existing slot while nothing is rendered.
    const SoundFrame& ofSilence(std::size_t slot, const ParameterValues& values, double rateHz);

private:
    void prepareSlot(std::size_t slot);
    void groupModesOf(const MonitoredSound& sound);
    void addModes(const MonitoredSound& sound);
    ModeNow modeNow(const MonitoredSound& sound, std::size_t mode) const;
    void addSlots(const MonitoredSound& sound);

    PictureSubject subject;
    std::vector<int> objectOfSlot; ///< index into InstrumentView::playedObjects
    std::vector<int> noteOfSlot;
    std::vector<bool> isOfOneKey;
    std::vector<std::int32_t> modesOfSlot;

    // State of the slot shown.
    std::shared_ptr<const ModalObject> object;
    std::string key;                       ///< its key in mode sets
    std::vector<double> weights;           ///< [M] mean-square shapes
    std::vector<std::uint8_t> isSilenced;  ///< [M], or empty: none
    std::vector<std::int32_t> groupStarts; ///< [G+1]

    SoundFrame frame;
};

} // namespace idiophone
