// A button that lets one file be chosen.
#pragma once

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <string>

namespace idiophone {

class FileButton final : public juce::TextButton {
public:
    /// The patterns are separated by semicolons: "*.scl;*.kbm". `onChosen` is told the path.
    FileButton(const juce::String& label,
               const juce::String& title,
               const juce::String& tooltip,
               const juce::String& filePatterns,
               std::function<void(const std::string& path)> onChosen);

private:
    void choose();

    juce::String patterns;
    std::function<void(const std::string& path)> chosen;
    std::unique_ptr<juce::FileChooser> chooser;
};

} // namespace idiophone
