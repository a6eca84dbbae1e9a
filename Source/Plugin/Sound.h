// A whole sound, to be kept and played again: cheap to copy, as the objects are shared.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/Preset.h"
#include "Plugin/ObjectEmbedding.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

struct Sound {
    Preset preset; ///< as loaded: its values are what "match loudness" keeps to
    std::shared_ptr<const Instrument> instrument;
    ParameterValues parameters;                    ///< as they are now
    std::shared_ptr<const MissingObjects> missing; ///< or null
    std::string presetId; ///< of the preset on the shelf (PresetShelf.h), or empty
    /// Hash of what that preset's file held when this was read from it or written to it; 0 for the
    /// factory's and where there is no preset.
    std::uint64_t presetContent = 0;
    ParameterValues stored; ///< what that preset has, to tell whether the sound was changed

    bool operator==(const Sound&) const = default;
};

/// What is shown of a sound.
struct SoundLabel {
    std::string name;
    std::string author;
    std::string description;
    std::vector<std::string> tags;
    std::string presetId;
    bool isChanged = false; ///< a parameter beside the setup is not as stored
};

/// What has a sound and plays others: the processor. For the message thread.
class SoundHolder {
public:
    virtual ~SoundHolder() = default;

    /// What plays; its instrument is null where nothing could be loaded.
    virtual Sound loadedSound() const = 0;
    /// The same, without what costs to copy.
    virtual SoundLabel loadedLabel() const = 0;
    /// Plays the sound at once, with the setup as it is. What rings fades out where the instrument
    /// or its preset is another one, and goes on where only parameters change, unless they change
    /// the level by more than 12 dB and nothing moves on a stage. Returns whether it plays: neither
    /// does a sound without instrument, nor one that the memory does not suffice for, which is
    /// reported.
    virtual bool playSound(const Sound& sound) = 0;
    /// What plays, if it has the wanted one's instrument, gets its preset's name, author,
    /// description and tags, its place on the shelf with what its file holds, and its stored
    /// values, and keeps all else.
    virtual void relabel(const Sound& wanted) = 0;
    /// A mesh is being analysed, of which what plays is only the first impression.
    virtual bool playsPreview() const = 0;
    /// A sentence for the status line.
    virtual void reportError(const std::string& sentence) = 0;
    /// How many states and programs the host has loaded, on whatever thread; without states that
    /// were refused, and without programs that MIDI asks for.
    virtual int hostLoads() const = 0;
    /// What played before the programs that MIDI has asked for since this was called last, or since
    /// the host has loaded something; nothing where there were none.
    virtual std::optional<Sound> takeSoundBeforePrograms() = 0;

    virtual double parameterValue(ParameterId parameter) const = 0;
    /// Sets the parameters in which `wanted` differs from those of a sound, all at once, if that
    /// still plays: others stay where automation has moved them meanwhile. What rings fades out or
    /// goes on as in `playSound`.
    virtual void changeParameters(const Sound& of, const ParameterValues& wanted) = 0;
    /// As a change by hand, which the host records.
    virtual void setValue(ParameterId parameter, double value) = 0;
};

} // namespace idiophone
