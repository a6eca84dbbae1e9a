// The presets that there are, the factory's and the user's, and what can be done with them.
#pragma once

#include "Object/Result.h"

#include <string>
#include <vector>

namespace idiophone {

struct ShelvedPreset {
    std::string id; ///< stays the same while the preset keeps its name and folder
    std::string name;
    std::string author;
    std::string description;
    std::vector<std::string> tags;
    std::string folder; ///< of the user's presets: "Bells/Small", empty at the top
    bool isFactory = false;
    bool isFavourite = false;
    std::string fault; ///< one sentence where the file cannot be read: it is listed, never lost
};

/// What a person says of a preset that is saved.
struct PresetDetails {
    std::string name;
    std::string folder; ///< below the user's presets, made where it is new; empty: at the top
    std::string author;
    std::string description;
    std::vector<std::string> tags;
};

/// For the message thread. Errors are one sentence; where there is one, nothing has changed.
class PresetShelf {
public:
    virtual ~PresetShelf() = default;

    /// As read last: the factory's in the order of the programs, then the user's by folder and
    /// name. Valid until the next call of anything here that is not const.
    virtual const std::vector<ShelvedPreset>& presets() const = 0;
    /// Looks at the user's folder again; files that have not changed are not read again.
    virtual void readPresets() = 0;

    /// The preset that plays, changed or not; empty where what plays is none of them.
    virtual std::string chosenPreset() const = 0;
    /// What the sound is called and said to be.
    virtual PresetDetails soundDetails() const = 0;
    /// Whether a parameter beside the setup is not as its preset has it.
    virtual bool soundIsChanged() const = 0;

    /// One step of the history, as is `loadInitialSound`.
    virtual Result<void> loadPreset(const std::string& id) = 0;
    /// A plain sound to start from, with its parameters at their defaults.
    virtual Result<void> loadInitialSound() = 0;

    /// Plays presets to listen to them; then `keepAudition` makes one step of it all, or
    /// `endAudition` returns to what played before.
    virtual Result<void> auditionPreset(const std::string& id) = 0;
    virtual void keepAudition() = 0;
    virtual void endAudition() = 0;

    /// Whether saving under these details would replace a file.
    virtual bool presetExists(const PresetDetails& details) const = 0;
    /// Saves what plays, with the objects that are not the factory's beside it. What is there
    /// already is replaced only where that is said.
    virtual Result<void> savePreset(const PresetDetails& details, bool replace) = 0;
    /// The same over the file of the user's preset that is chosen, whatever the file is called, as
    /// another may be called what the preset is. An error where another window or program has
    /// written it since what plays was loaded from it or saved to it here.
    virtual Result<void> saveChosenPreset() = 0;
    virtual Result<void> renamePreset(const std::string& id, const std::string& name) = 0;
    /// Moves the file to the system's bin; the sound plays on.
    virtual Result<void> deletePreset(const std::string& id) = 0;
    virtual Result<void> setFavourite(const std::string& id, bool favourite) = 0;

    /// The path of the user's presets, made if it was not there.
    virtual Result<std::string> presetFolder() = 0;
};

} // namespace idiophone
