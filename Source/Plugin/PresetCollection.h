// Keeps the shelf of presets: the factory's and the user's. Loads and saves the sound that plays.
#pragma once

#include "Editor/PresetShelf.h"
#include "Editor/WorkshopView.h"
#include "Plugin/Favourites.h"
#include "Plugin/PresetFolder.h"
#include "Plugin/SoundHistory.h"

#include <cstdint>
#include <functional>

namespace idiophone {

/// For the message thread.
class PresetCollection final : public PresetShelf {
public:
    /// Presets are in `Presets` of the settings folder, favourites in a file there. An empty folder
    /// means a machine without settings. Reads nothing yet.
    PresetCollection(SoundHolder& holder,
                     SoundHistory& history,
                     const WorkshopView& workshop,
                     const juce::File& settings);

    const std::vector<ShelvedPreset>& presets() const override { return shelf; }
    void readPresets() override;
    PlayingPreset playingPreset() const override;
    Result<void> loadPreset(const std::string& id) override;
    Result<void> openPresetFile(const std::filesystem::path& file) override;
    Result<void> loadInitialSound() override;
    Result<void> auditionPreset(const std::string& id) override;
    void keepAudition() override { history.keepAudition(); }
    void endAudition() override { history.endAudition(); }
    bool presetExists(const PresetDetails& details) const override;
    Result<void> savePreset(const PresetDetails& details, bool replace) override;
    Result<void> saveChosenPreset() override;
    Result<void> renamePreset(const std::string& id, const std::string& name) override;
    Result<void> deletePreset(const std::string& id) override;
    Result<void> setFavourite(const std::string& id, bool favourite) override;
    Result<std::string> presetFolder() override;

private:
    struct FoundSound {
        Sound sound;
        std::string notice; ///< a sentence for the user, or empty
    };
    Result<FoundSound> soundOf(const std::string& id);
    static Result<FoundSound> soundOfFile(Preset preset,
                                          const juce::File& file,
                                          const std::string& id,
                                          std::uint64_t content);
    Result<void> load(const Result<FoundSound>& found);
    void play(const FoundSound& found);
    /// Writes the playing sound to that file by `write`, which returns its id.
    Result<void> save(Sound sound,
                      const PresetDetails& details,
                      const juce::File& file,
                      const std::function<Result<std::string>(const Preset&)>& write);

    SoundHolder& holder;
    SoundHistory& history;
    const WorkshopView& workshop;
    PresetFolder folder;
    Favourites favourites;
    std::vector<ShelvedPreset> shelf;
};

} // namespace idiophone
