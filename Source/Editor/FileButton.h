// A button that opens a chooser for one file.
#pragma once

#include <filesystem>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

class FileButton final : public juce::TextButton {
public:
    /// Semicolons separate the patterns: "*.scl;*.kbm".
    FileButton(const juce::String& label,
               const juce::String& title,
               const juce::String& tooltip,
               const juce::String& filePatterns,
               std::function<void(const std::filesystem::path& file)> onChosen);

private:
    void choose();

    juce::String patterns;
    std::function<void(const std::filesystem::path& file)> chosen;
    std::unique_ptr<juce::FileChooser> chooser;
};

} // namespace idiophone
