// A button for captured notes: a drag exports them as a file, a click saves them.
#pragma once

#include "Editor/ProcessorView.h"

#include <filesystem>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

class CaptureButton final : public juce::TextButton {
public:
    /// The pattern gives the file extension: "*.mid".
    CaptureButton(ProcessorView& processor,
                  StageView::CaptureKind whichKind,
                  const juce::String& label,
                  const juce::String& tooltip,
                  const juce::String& filePattern);

    void mouseDown(const juce::MouseEvent& event) override;
    void mouseDrag(const juce::MouseEvent& event) override;
    void mouseUp(const juce::MouseEvent& event) override;

    /// Writes the file to drag, in the system's temporary folder. Returns an empty File on failure.
    juce::File writeForDrag();
    /// Saves to the chosen path, and adds the extension if it is missing. Then an existing file is
    /// not replaced, because the chooser has not asked about it.
    void save(const juce::File& chosen);
    /// Whether any window wrote this file for a drag.
    static bool isForDrag(const std::filesystem::path& file);

private:
    void save();
    juce::String ending() const;

    ProcessorView& view;
    StageView::CaptureKind kind;
    juce::String pattern;
    std::unique_ptr<juce::FileChooser> chooser;
    bool isDragged = false;
};

} // namespace idiophone
