// What the window needs of the processor, and nothing else: the editor knows no more of the plugin.
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
        std::string sentence; ///< what is loaded, or what went wrong last
        bool isError = false;
        std::int64_t modesMixed = 0; ///< in the cell rendered last
        double delaySeconds = 0;     ///< on a stage, from a key to what is heard of it; otherwise 0
        std::int64_t lateBlows = 0;  ///< on a stage, that were known too late to be in time
        float peak = 0;              ///< of the output since this was asked last; full scale is 1
    };

    struct KeyRange {
        int lowest = 0; ///< MIDI notes
        int highest = 127;
    };

    enum class KeySound {
        silent,
        resized, ///< plays the nearest key's object, resized
        own,     ///< plays what the preset has for it
    };

    /// Something to be seen and struck: keys may share it.
    struct PlayedObject {
        std::shared_ptr<const ModalObject> object;
        double sizeRatio = 1; ///< of the object as its keys play it, to its own
        int lowestNote = 0;   ///< MIDI notes whose own it is
        int highestNote = 0;
    };

    /// In the unit of the table.
    virtual double parameterValue(ParameterId parameter) const = 0;
    /// What holds now: of a material's or mallet's figures those of the one that is chosen, or of
    /// what the objects themselves are made of.
    virtual double effectiveValue(ParameterId parameter) const = 0;
    /// Before a figure of the chosen material or mallet is changed by hand: the custom one takes
    /// all its figures and is chosen. Nothing where it is, and for other parameters.
    virtual void makeCustom(ParameterId figure) = 0;
    /// False where the parameter does nothing to what plays: its objects would have to be analysed
    /// anew for it, or its keys have no pitches to keep.
    virtual bool isLive(ParameterId parameter) const = 0;
    /// A change by hand: `begin`, any number of `change`s, `end`; the host records it.
    virtual void beginParameterChange(ParameterId parameter) = 0;
    virtual void changeParameter(ParameterId parameter, double value) = 0;
    virtual void endParameterChange(ParameterId parameter) = 0;

    /// Reads the user's materials anew and returns their names. What cannot be read is left out,
    /// and is what the status says.
    virtual std::vector<std::string> readUserMaterials() = 0;
    /// As they were read last.
    virtual std::vector<std::string> userMaterialNames() const = 0;
    /// Which of those read last has the figures that are played; −1 where none.
    virtual int userMaterialIndex() const = 0;
    /// Plays the figures of that one as the custom material's.
    virtual void chooseUserMaterial(int index) = 0;

    /// Velocity 1 to 127; 0 releases.
    virtual void playNote(int midiNote, int velocity) = 0;
    /// From the lowest to the highest key that has an object of its own.
    virtual KeyRange keyRange() const = 0;
    virtual std::array<KeySound, 128> keySounds() const = 0; ///< of every MIDI note

    /// Of the instrument that plays, in the order of their keys; empty where there is none.
    virtual std::vector<PlayedObject> playedObjects() const = 0;
    /// Whether keys set bodies in motion instead of striking by themselves.
    virtual bool hasStage() const = 0;
    /// What stands on the stage before the first note.
    virtual std::vector<BodyNow> stageBodies() const = 0;
    /// On a stage: bodies stand still in the air while it is paused, and are gone after a reset.
    virtual void pauseStage(bool isPaused) = 0;
    virtual bool isStagePaused() const = 0;
    virtual void resetStage() = 0;
    /// What its bodies have struck since it was loaded or reset last.
    enum class CaptureKind {
        midi,    ///< a Standard MIDI File at the host's tempo
        impulses ///< a list for `idiophone render --impulses`
    };
    virtual bool hasCaptured() = 0;
    /// Writes it to a file, over what is there. False, and said in the status, where it cannot.
    virtual bool writeCapture(CaptureKind kind, const std::filesystem::path& file) = 0;
    /// Where keys strike one of them, in metres of its own mesh: places on its surface along the
    /// strike path, from the lowest key's end on. Empty where there is no such object.
    virtual std::vector<std::array<double, 3>> struckPlaces(std::size_t index) const = 0;
    /// Another number with every other instrument.
    virtual int instrumentNumber() const = 0;
    /// Strikes one of `playedObjects` at the place nearest to a point in metres of its own mesh;
    /// velocity 1 to 127, or 0 to lift the hand that holds it. What has gone since is ignored.
    virtual void
    strikeObject(std::size_t index, const std::array<double, 3>& pointMetres, int velocity) = 0;

    /// Drags over one of `playedObjects`, to the place nearest to a point in metres of its own
    /// mesh: the way there from the last one sounds as fast as it is gone, and standing still is
    /// silent. Pressure 0 to 1 of the contact force; 0 lifts the hand. There is one hand: on
    /// another object it starts anew. What has gone since is ignored.
    virtual void
    scrapeObject(std::size_t index, const std::array<double, 3>& pointMetres, double pressure) = 0;

    virtual Status takeStatus() = 0;
    /// One sentence of the window about what went wrong, for the status to say.
    virtual void reportError(const std::string& sentence) = 0;

    /// For as long as this lives.
    virtual PresetShelf& presetShelf() = 0;
    virtual EditHistory& editHistory() = 0;
    virtual SoundVariants& soundVariants() = 0;
    virtual MidiLearnView& midiLearn() = 0;

    /// The window is gone: whatever changes by hand it had begun are over.
    virtual void windowClosed() = 0;
};

} // namespace idiophone
