// The window's view of the instrument: its keys and objects, and how to play them by hand.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace idiophone {

/// For the message thread. Objects are indices into `playedObjects`; those that no longer exist are
/// ignored.
class InstrumentView {
public:
    struct KeyRange {
        int lowest = 0; ///< MIDI notes
        int highest = 127;

        bool operator==(const KeyRange&) const = default;
    };

    enum class KeySound {
        silent,
        resized, ///< plays the nearest key's object, resized to its pitch
        own,     ///< plays its own object
    };

    /// An object that can be seen and struck. Several keys may share it.
    struct PlayedObject {
        std::shared_ptr<const ModalObject> object;
        double sizeRatio = 1; ///< size when played, relative to the object's own size
        int lowestNote = 0;   ///< range of MIDI notes that this object belongs to
        int highestNote = 0;
    };

    virtual ~InstrumentView() = default;

    /// Changes with each new instrument.
    virtual int instrumentNumber() const = 0;
    /// From the lowest to the highest key with its own object.
    virtual KeyRange keyRange() const = 0;
    virtual std::array<KeySound, 128> keySounds() const = 0; ///< one per MIDI note
    /// The current instrument's objects, in the order of their keys; empty without an instrument.
    virtual std::vector<PlayedObject> playedObjects() const = 0;
    /// The places where keys strike an object, in metres on its mesh, along the strike path from
    /// the lowest key's end. Empty if the object does not exist.
    virtual std::vector<std::array<double, 3>> struckPlaces(std::size_t index) const = 0;

    /// Whether notes sound now, and no song of the host plays. The window then plays phrases of its
    /// own.
    virtual bool isFreeToPlay() const = 0;
    /// Ends all sound at once, as MIDI's All Sound Off does.
    virtual void silence() = 0;
    /// Velocity 1 to 127; 0 releases.
    virtual void playNote(int midiNote, int velocity) = 0;
    /// Strikes an object at the surface point nearest to `pointMetres`, in metres of its mesh.
    /// Velocity 1 to 127; 0 releases the object.
    virtual void
    strikeObject(std::size_t index, const std::array<double, 3>& pointMetres, int velocity) = 0;
    /// Scrapes an object, from the last point to the surface point nearest to `pointMetres`, in
    /// metres of its mesh. The motion's speed sets the sound; a resting contact is silent.
    /// `pressure` is a share of the contact force, 0 to 1; 0 ends the contact. There is one
    /// contact: another object starts a new one.
    virtual void
    scrapeObject(std::size_t index, const std::array<double, 3>& pointMetres, double pressure) = 0;
};

} // namespace idiophone
