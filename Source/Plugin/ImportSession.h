// Opens files of objects for the window, and plays the workshop's products and other key maps.
#pragma once

#include "Editor/WorkshopView.h"
#include "Plugin/FileKinds.h"
#include "Plugin/ImportedSound.h"
#include "Plugin/MaterialSession.h"
#include "Plugin/ObjectWorkshop.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundSession.h"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// For the message thread.
class ImportSession final : public WorkshopView {
public:
    ImportSession(SharedParts& sharedParts,
                  SoundSession& soundSession,
                  SoundHistory& soundHistory,
                  const MaterialSession& userMaterials)
        : shared(sharedParts), session(soundSession), history(soundHistory),
          materials(userMaterials) {}

    bool canOpen(const std::filesystem::path& file) const override {
        return matches(file, objectFiles);
    }
    std::string openPatterns() const override { return objectFiles; }
    void openFile(const std::filesystem::path& file) override { open({.path = file}); }
    void openFileOnKey(const std::filesystem::path& file, int midiNote) override;
    bool canAnalyseAgain() const override;
    void setImportSettings(const ImportSettings& settings) override;
    void analyseAgain() override;
    void cancelImport() override;
    ImportStatus importStatus() const override;
    bool playsPreview() const override;
    std::optional<KeyLayout> keyLayout() const override { return layoutOf(session.instrument()); }
    void setKeyLayout(KeyLayout layout) override;
    void setStrikePath(std::size_t index,
                       const std::vector<std::array<double, 3>>& pathMetres) override;

    /// Plays a product unless another sound was chosen meanwhile.
    void poll();

private:
    struct File {
        std::filesystem::path path;
        std::optional<int> key = {}; ///< the key that gets its object; otherwise all keys do
    };
    using Renewed = std::map<const Instrument*, std::shared_ptr<const Instrument>>;

    void begin(int originOfJob, std::optional<int> midiNote);
    void open(const File& file);
    bool followsSettings() const {
        return !keyOfJob && origin == session.origin() && workshop.hasMesh();
    }
    std::shared_ptr<const ModalObject> foreignObject() const;
    /// Returns whether the last product is part of what plays.
    bool importedPlays() const {
        const auto object = imported.lock();
        return object != nullptr && plays(session.instrument(), *object);
    }
    ImportSettings settingsInForce() const;
    void play(const ObjectWorkshop::Product& product);
    void putOnKey(const ObjectWorkshop::Product& product, int midiNote);
    void putFirst(const ObjectWorkshop::Product& product, int midiNote);
    void replacePreview(const ObjectWorkshop::Product& whole);
    void renewHistory(const std::shared_ptr<const ModalObject>& preview,
                      const ObjectWorkshop::Product& whole,
                      Renewed renewed);
    void playMapped(const SoundSession::Loaded& now, const KeyMap& map, const std::string& step);

    SharedParts& shared;
    SoundSession& session;
    SoundHistory& history;
    const MaterialSession& materials;
    ObjectWorkshop workshop;
    ImportSettings importSettings; ///< settings given for opened files
    int origin = -1; ///< SoundSession::origin that the workshop's job began from or led to
    std::optional<int> keyOfJob;   ///< as `File::key`, of the job
    std::deque<File> pendingFiles; ///< for keys, opened when the job has ended
    bool failureShown = true;
    std::weak_ptr<const ModalObject> imported; ///< the last product that played
    bool importedIsPreview = false;
    std::weak_ptr<const ModalObject>
        settingsGivenFor; ///< foreign object when the settings were given
};

} // namespace idiophone
