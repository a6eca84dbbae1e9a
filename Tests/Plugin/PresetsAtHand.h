// Helpers for tests of the preset collection: preset details, a search by name, and a base class
// for faulty holders.
#pragma once

#include "Plugin/PresetCollection.h"
#include "Plugin/Processor.h"

#include <algorithm>
#include <optional>
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

/// Forwards to a processor. Tests override it to act between the processor and its presets.
class ForwardingHolder : public SoundHolder {
public:
    explicit ForwardingHolder(Processor& held) : processor(held) {}

    Sound loadedSound() const override { return processor.loadedSound(); }
    SoundLabel loadedLabel() const override { return processor.loadedLabel(); }
    bool playSound(const Sound& sound) override { return processor.playSound(sound); }
    void relabel(const Sound& sound) override { processor.relabel(sound); }
    bool playsPreview() const override { return processor.playsPreview(); }
    void reportError(const std::string& sentence) override { processor.reportError(sentence); }
    int hostLoads() const override { return processor.hostLoads(); }
    std::optional<Sound> takeSoundBeforePrograms() override {
        return processor.takeSoundBeforePrograms();
    }
    double parameterValue(ParameterId id) const override { return processor.parameterValue(id); }
    void changeParameters(const Sound& of, const ParameterValues& wanted) override {
        processor.changeParameters(of, wanted);
    }
    void setValue(ParameterId id, double value) override { processor.setValue(id, value); }

private:
    Processor& processor;
};

} // namespace idiophone::test
