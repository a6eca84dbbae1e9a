// Helpers for tests of the preset collection: preset details, a search by name, and a base class
// for faulty holders.
#pragma once

#include "Plugin/PresetCollection.h"
#include "Plugin/Processor.h"

#include <algorithm>
#include <string>

namespace idiophone::test {

inline PresetDetails called(const std::string& name, const std::string& folder = "") {
    return {.name = name,
            .folder = folder,
            .author = "Anna",
            .description = "A test.",
            .tags = {"test", "small"}};
}

inline const ShelvedPreset* find(const PresetShelf& shelf, const std::string& name) {
    const auto found = std::ranges::find(shelf.presets(), name, &ShelvedPreset::name);
    return found == shelf.presets().end() ? nullptr : &*found;
}

/// Forwards to a session. Tests override it to act between the session and its presets.
class ForwardingHolder : public SoundHolder {
public:
    explicit ForwardingHolder(Processor& held) : session(held.soundSession()) {}

    Sound loadedSound() const override { return session.loadedSound(); }
    PlayingPreset playingPreset() const override { return session.playingPreset(); }
    bool playSound(const Sound& sound) override { return session.playSound(sound); }
    void relabel(const Sound& sound) override { session.relabel(sound); }
    void reportError(const std::string& sentence) override { session.reportError(sentence); }
    void changeParameters(const Sound& of, const ParameterValues& wanted) override {
        session.changeParameters(of, wanted);
    }

private:
    SoundSession& session;
};

} // namespace idiophone::test
