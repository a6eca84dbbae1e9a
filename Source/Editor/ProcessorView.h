// What the window needs of the processor, and nothing else: the editor knows no more of the plugin.
#pragma once

#include "Editor/EditHistory.h"
#include "Editor/MidiLearnView.h"
#include "Editor/PresetShelf.h"
#include "Editor/SoundVariants.h"
#include "Object/ModalObject.h"
#include "Parameters/ParameterTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace idiophone {

/// For the message thread.
class ProcessorView {
public:
    struct Status {
        std::string sentence; ///< what is loaded, or what went wrong last
        bool isError = false;
        std::int64_t modesMixed = 0; ///< in the cell rendered last
        float peak = 0;              ///< of the output since this was asked last; full scale is 1
    };

    struct KeyRange {
        int lowest = 0; ///< MIDI notes
        int highest = 127;
    };

    /// Something to be seen and struck: keys may share it.
    struct PlayedObject {
        std::shared_ptr<const ModalObject> object;
        double sizeRatio = 1; ///< of the object as its keys play it, to its own
        int lowestNote = 0;   ///< MIDI notes that play it
        int highestNote = 0;
    };

    virtual ~ProcessorView() = default;

    virtual std::vector<std::string> presetNames() const = 0;
    /// −1 where what plays is none of them.
    virtual int presetIndex() const = 0;
    virtual void choosePreset(int index) = 0;

    /// In the unit of the table.
    virtual double parameterValue(ParameterId parameter) const = 0;
    /// False where no object that plays can follow the parameter: it would have to be analysed
    /// anew.
    virtual bool isLive(ParameterId parameter) const = 0;
    /// A change by hand: `begin`, any number of `change`s, `end`; the host records it.
    virtual void beginParameterChange(ParameterId parameter) = 0;
    virtual void changeParameter(ParameterId parameter, double value) = 0;
    virtual void endParameterChange(ParameterId parameter) = 0;

    /// Reads the user's materials anew and returns their names. What cannot be read is left out,
    /// and is what the status says.
    virtual std::vector<std::string> readUserMaterials() = 0;
    /// Which of those read last has the figures that are played; −1 where none.
    virtual int userMaterialIndex() const = 0;
    /// Plays the figures of that one as the custom material's.
    virtual void chooseUserMaterial(int index) = 0;

    /// Velocity 1 to 127; 0 releases.
    virtual void playNote(int midiNote, int velocity) = 0;
    virtual KeyRange keyRange() const = 0; ///< the notes that sound

    /// Of the instrument that plays, in the order of their keys; empty where there is none.
    virtual std::vector<PlayedObject> playedObjects() const = 0;
    /// Another number with every other instrument.
    virtual int instrumentNumber() const = 0;
    /// Strikes one of `playedObjects` at the place nearest to a point in metres of its own mesh;
    /// velocity 1 to 127, or 0 to lift the hand that holds it. What has gone since is ignored.
    virtual void
    strikeObject(std::size_t index, const std::array<double, 3>& pointMetres, int velocity) = 0;

    virtual Status takeStatus() = 0;

    /// For as long as this lives.
    virtual PresetShelf& presetShelf() = 0;
    virtual EditHistory& editHistory() = 0;
    virtual SoundVariants& soundVariants() = 0;
    virtual MidiLearnView& midiLearn() = 0;
};

} // namespace idiophone
