// A button that is dragged out of the window as a file, or saves it where it is clicked.
#pragma once

#include "Editor/ProcessorView.h"

#include <filesystem>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

class CaptureButton final : public juce::TextButton {
public:
    /// Files of the pattern's ending: "*.mid".
    CaptureButton(ProcessorView& processor,
                  ProcessorView::CaptureKind whichKind,
                  const juce::String& label,
                  const juce::String& tooltip,
                  const juce::String& filePattern);

    void mouseDown(const juce::MouseEvent& event) override;
    void mouseDrag(const juce::MouseEvent& event) override;
    void mouseUp(const juce::MouseEvent& event) override;

    /// A new file of the system's temporary folder, as it is dragged; none where it was not
    /// written.
    juce::File writeForDrag();
    /// As a chooser names it: some systems' give it no ending. A file that the chooser has not
    /// asked about, as it did not know its ending, is not replaced.
    void save(const juce::File& chosen);
    /// Whether it is such a file, of any window's.
    static bool isForDrag(const std::filesystem::path& file);

private:
    void save();
    juce::String ending() const;

    ProcessorView& view;
    ProcessorView::CaptureKind kind;
    juce::String pattern;
    std::unique_ptr<juce::FileChooser> chooser;
    bool isDragged = false;
};

} // namespace idiophone
