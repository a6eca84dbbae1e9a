// The editor's only interface to the processor. Plugin implements it.
#pragma once

#include "Editor/EditHistory.h"
#include "Editor/MidiLearnView.h"
#include "Editor/PresetShelf.h"
#include "Editor/SoundVariants.h"
#include "Editor/SoundView.h"
#include "Editor/TuningView.h"
#include "Editor/WorkshopView.h"
#include "Object/ModalObject.h"
#include "Parameters/ParameterTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace idiophone {

/// For the message thread.
class ProcessorView : public SoundView, public WorkshopView, public TuningView {
public:
    struct Status {
        std::string sentence; ///< the loaded sound, or the last error
        bool isError = false;
        std::int64_t modesMixed = 0;  ///< in the last rendered cell
        double delaySeconds = 0;      ///< on a stage: from a key to its sound; otherwise 0
        std::int64_t lateEvents = 0; ///< on a stage: impacts and contacts known too late
        float peak = 0;               ///< output peak since the last call; full scale is 1
    };

    struct KeyRange {
        int lowest = 0; ///< MIDI notes
        int highest = 127;
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

    /// The value in the parameter table's unit.
    virtual double parameterValue(ParameterId parameter) const = 0;
    /// The value in effect. For a figure of a material or mallet, that of the selected one, or of
    /// the objects' own material.
    virtual double effectiveValue(ParameterId parameter) const = 0;
    /// Call before changing a figure of a material or mallet by hand: copies all its figures to the
    /// custom one and selects that. Does nothing if the custom one is selected, or for other
    /// parameters.
    virtual void makeCustom(ParameterId figure) = 0;
    /// False if the parameter has no effect on the current sound: its objects would need a new
    /// analysis, or no key has a pitch to keep.
    virtual bool isLive(ParameterId parameter) const = 0;
    /// A gesture by hand: `begin`, any number of `change`s, `end`. The host records it.
    virtual void beginParameterChange(ParameterId parameter) = 0;
    virtual void changeParameter(ParameterId parameter, double value) = 0;
    virtual void endParameterChange(ParameterId parameter) = 0;

    /// Reads the user's materials again and returns their names. Unreadable ones are left out and
    /// reported in the status.
    virtual std::vector<std::string> readUserMaterials() = 0;
    /// The names as last read.
    virtual std::vector<std::string> userMaterialNames() const = 0;
    /// Index of the user material whose figures are in effect; −1: none.
    virtual int userMaterialIndex() const = 0;
    /// Copies a user material's figures to the custom material and selects it.
    virtual void chooseUserMaterial(int index) = 0;

    /// Velocity 1 to 127; 0 releases.
    virtual void playNote(int midiNote, int velocity) = 0;
    /// From the lowest to the highest key with its own object.
    virtual KeyRange keyRange() const = 0;
    virtual std::array<KeySound, 128> keySounds() const = 0; ///< one per MIDI note

    /// The current instrument's objects, in the order of their keys; empty without an instrument.
    virtual std::vector<PlayedObject> playedObjects() const = 0;
    /// Whether keys set simulated bodies in motion instead of striking objects. The instrument is
    /// then on a stage.
    virtual bool hasStage() const = 0;
    /// The bodies before the first note.
    virtual std::vector<BodyNow> stageBodies() const = 0;
    /// On a stage: a pause stops bodies where they are, a reset removes them.
    virtual void pauseStage(bool isPaused) = 0;
    virtual bool isStagePaused() const = 0;
    virtual void resetStage() = 0;
    /// File formats of a capture: the impacts on the stage since it was loaded or last reset.
    enum class CaptureKind {
        midi,    ///< a Standard MIDI File at the host's tempo
        impulses ///< a list for `idiophone render --impulses`
    };
    virtual bool hasCaptured() = 0;
    /// Writes the captured impacts to a file, and replaces it. Returns false and reports the error
    /// in the status on failure.
    virtual bool writeCapture(CaptureKind kind, const std::filesystem::path& file) = 0;
    /// The places where keys strike an object, in metres on its mesh, along the strike path from
    /// the lowest key's end. Empty if the object does not exist.
    virtual std::vector<std::array<double, 3>> struckPlaces(std::size_t index) const = 0;
    /// Changes with each new instrument.
    virtual int instrumentNumber() const = 0;
    /// Strikes an object at the surface point nearest to `pointMetres`, in metres of its mesh.
    /// Velocity 1 to 127; 0 releases the object. Ignores objects that no longer exist.
    virtual void
    strikeObject(std::size_t index, const std::array<double, 3>& pointMetres, int velocity) = 0;

    /// Scrapes an object, from the last point to the surface point nearest to `pointMetres`, in
    /// metres of its mesh. The motion's speed sets the sound; a resting contact is silent.
    /// `pressure` is a share of the contact force, 0 to 1; 0 ends the contact. There is one
    /// contact: another object starts a new one. Ignores objects that no longer exist.
    virtual void
    scrapeObject(std::size_t index, const std::array<double, 3>& pointMetres, double pressure) = 0;

    virtual Status takeStatus() = 0;
    /// Reports an error of the window in one sentence; the status shows it.
    virtual void reportError(const std::string& sentence) = 0;

    /// These live as long as the view.
    virtual PresetShelf& presetShelf() = 0;
    virtual EditHistory& editHistory() = 0;
    virtual SoundVariants& soundVariants() = 0;
    virtual MidiLearnView& midiLearn() = 0;

    /// Call when the window has closed; ends all gestures that it had begun.
    virtual void windowClosed() = 0;
};

} // namespace idiophone
