#include "Editor/FileButton.h"

#include "Editor/Utf8.h"

#include <utility>

namespace idiophone {

FileButton::FileButton(const juce::String& label,
                       const juce::String& title,
                       const juce::String& tooltip,
                       const juce::String& filePatterns,
                       std::function<void(const std::filesystem::path& file)> onChosen)
    : TextButton(label), patterns(filePatterns), chosen(std::move(onChosen)) {
    setTitle(title);
    setTooltip(tooltip);
    onClick = [this] { choose(); };
}

void FileButton::choose() {
    chooser = std::make_unique<juce::FileChooser>(getTitle(), juce::File(), patterns);
    chooser->launchAsync(juce::FileBrowserComponent::openMode |
                             juce::FileBrowserComponent::canSelectFiles,
                         [this](const juce::FileChooser& done) {
                             if (const auto file = done.getResult(); file != juce::File())
                                 chosen(pathOf(file));
                         });
}

} // namespace idiophone
