// The factory's and the user's presets, and actions on them.
#pragma once

#include "Object/Result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace idiophone {

struct ShelvedPreset {
    std::string id; ///< constant while the preset keeps its name and folder
    std::string name;
    std::string author;
    std::string description;
    std::vector<std::string> tags;
    std::string folder; ///< folder of a user preset: "Bells/Small"; empty: top folder
    bool isFactory = false;
    bool isFavourite = false;
    std::string fault; ///< one sentence if the file cannot be read; it is listed anyway
};

/// The details that the user enters when saving a preset.
struct PresetDetails {
    std::string name;
    std::string folder; ///< below the user's presets, created if missing; empty: top folder
    std::string author;
    std::string description;
    std::vector<std::string> tags;
};

/// The current preset, and the sound made of it.
struct PlayingPreset {
    std::string id;        ///< constant while the sound changes; empty if there is no preset
    PresetDetails details; ///< of the sound
    /// Whether any parameter, except those of the setup, differs from the preset.
    bool isChanged = false;
};

/// For the message thread. Errors are one sentence; after an error nothing has changed.
class PresetShelf {
public:
    virtual ~PresetShelf() = default;

    /// The presets as last read: the factory's in program order, then the user's by folder and
    /// name. Valid until the next call of a non-const function.
    virtual const std::vector<ShelvedPreset>& presets() const = 0;
    /// Reads the user's folder again, but not files that have not changed.
    virtual void readPresets() = 0;

    /// Cheap enough for every poll of the window.
    virtual PlayingPreset playingPreset() const = 0;

    /// Loads a preset, as one step of the edit history.
    virtual Result<void> loadPreset(const std::string& id) = 0;
    /// Loads the preset of any file, as one step of the edit history. It does not join the shelf.
    virtual Result<void> openPresetFile(const std::filesystem::path& file) = 0;
    /// Loads a plain sound with all parameters at their defaults, as one step of the edit history.
    virtual Result<void> loadInitialSound() = 0;

    /// Plays a preset on trial. Then `keepAudition` makes one step of all trials, and `endAudition`
    /// restores the previous sound.
    virtual Result<void> auditionPreset(const std::string& id) = 0;
    virtual void keepAudition() = 0;
    virtual void endAudition() = 0;

    /// Whether a preset file with these details exists.
    virtual bool presetExists(const PresetDetails& details) const = 0;
    /// Saves the current sound, with its objects unless they are the factory's. Replaces an
    /// existing preset only if `replace` is true.
    virtual Result<void> savePreset(const PresetDetails& details, bool replace) = 0;
    /// Overwrites the file of the current user preset, whatever the file's name is. Fails if
    /// another window or program has written the file since it was loaded or saved here.
    virtual Result<void> saveChosenPreset() = 0;
    virtual Result<void> renamePreset(const std::string& id, const std::string& name) = 0;
    /// Moves the file to the system's bin; the sound continues.
    virtual Result<void> deletePreset(const std::string& id) = 0;
    virtual Result<void> setFavourite(const std::string& id, bool favourite) = 0;

    /// The path of the user's presets, created if missing.
    virtual Result<std::string> presetFolder() = 0;
};

} // namespace idiophone
