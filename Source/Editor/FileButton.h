// A button that opens a chooser for one file.
#pragma once

#include "Editor/Utf8.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <utility>

namespace idiophone {

class FileButton final : public juce::TextButton {
public:
    /// Semicolons separate the patterns: "*.scl;*.kbm".
    FileButton(const juce::String& label,
               const juce::String& title,
               const juce::String& tooltip,
               const juce::String& patterns,
               std::function<void(const std::filesystem::path& file)> onChosen)
        : TextButton(label, tooltip) {
        setTitle(title);
        onClick = [this, patterns, chosen = std::move(onChosen)] {
            chooser = std::make_unique<juce::FileChooser>(getTitle(), juce::File(), patterns);
            chooser->launchAsync(juce::FileBrowserComponent::openMode |
                                     juce::FileBrowserComponent::canSelectFiles,
                                 [chosen](const juce::FileChooser& done) {
                                     if (const auto file = done.getResult(); file != juce::File())
                                         chosen(pathOf(file));
                                 });
        };
    }

private:
    std::unique_ptr<juce::FileChooser> chooser;
};

} // namespace idiophone
