// A button for captured notes: a drag exports them as a file, and a click saves them.
#pragma once

#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"
#include "Object/FileBytes.h"

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
                  const juce::String& filePattern)
        : TextButton(label), view(processor), kind(whichKind), pattern(filePattern) {
        setTitle("Capture as " + label);
        setTooltip(tooltip);
        onClick = [this] { save(); };
    }

    void mouseDown(const juce::MouseEvent& event) override {
        isDragged = false;
        TextButton::mouseDown(event);
    }
    void mouseDrag(const juce::MouseEvent& event) override {
        if (isDragged || event.getDistanceFromDragStart() < pixelsToDrag)
            return TextButton::mouseDrag(event);
        isDragged = true;
        if (const auto file = writeForDrag(); file != juce::File())
            juce::DragAndDropContainer::performExternalDragDropOfFiles({file.getFullPathName()},
                                                                       false, this);
    }
    void mouseUp(const juce::MouseEvent& event) override {
        if (isDragged)
            setState(buttonNormal); // a drag does not click
        else
            TextButton::mouseUp(event);
    }

    /// Writes the file to drag, in the system's temporary folder. Returns an empty File on failure.
    juce::File writeForDrag() {
        if (!view.stage.hasCaptured())
            return {};
        const auto folder = dragFolder();
        if (!folder.isDirectory()) {
            view.status.reportError("There is no place to put the capture for dragging.");
            return {};
        }
        const auto file = folder.getNonexistentChildFile(captureName, ending());
        return view.stage.writeCapture(kind, pathOf(file)) ? file : juce::File();
    }
    /// Saves to the chosen path, and adds the extension if it is missing. Then an existing file is
    /// not replaced, because the chooser has not asked about it.
    void save(const juce::File& chosen) {
        const auto file =
            chosen.getFileExtension().isEmpty() ? chosen.withFileExtension(ending()) : chosen;
        if (file != chosen && file.exists())
            return view.status.reportError("There is already a file " +
                                           file.getFileName().toStdString() + ".");
        view.stage.writeCapture(kind, pathOf(file));
    }
    /// Whether any window wrote this file for a drag.
    static bool isForDrag(const std::filesystem::path& file) {
        const auto folder = file.parent_path();
        return folder.parent_path() == pathOf(temporaryFolder()) &&
               nameOf(folder.filename()).starts_with(dragFolderPrefix);
    }

private:
    static constexpr int pixelsToDrag = 6;
    static constexpr const char* captureName = "Idiophone capture";
    static constexpr const char* dragFolderPrefix = "Idiophone-drag-";

    static juce::File temporaryFolder() {
        return juce::File::getSpecialLocation(juce::File::tempDirectory);
    }

    /// Returns this process's temporary folder, because several users may share the system's. It is
    /// created again if somebody deleted it, and never removed: hosts may still read dropped files.
    static juce::File dragFolder() {
        static juce::File folder;
        if (folder.isDirectory())
            return folder;
        const auto next = temporaryFolder().getChildFile(
            dragFolderPrefix + juce::String::toHexString(juce::Random().nextInt64()));
        std::error_code fault;
        // If the folder existed before, another user may own it.
        if (std::filesystem::create_directory(pathOf(next), fault)) {
            std::filesystem::permissions(pathOf(next), std::filesystem::perms::owner_all, fault);
            folder = next;
        }
        return folder;
    }

    void save() {
        if (!view.stage.hasCaptured())
            return view.status.reportError(
                "There is nothing to save yet: no body has struck anything.");
        const auto start = juce::File::getSpecialLocation(juce::File::userDocumentsDirectory)
                               .getChildFile(juce::String(captureName) + ending());
        chooser = std::make_unique<juce::FileChooser>(getTitle(), start, pattern);
        chooser->launchAsync(juce::FileBrowserComponent::saveMode |
                                 juce::FileBrowserComponent::canSelectFiles |
                                 juce::FileBrowserComponent::warnAboutOverwriting,
                             [this](const juce::FileChooser& done) {
                                 if (const auto file = done.getResult(); file != juce::File())
                                     save(file);
                             });
    }
    juce::String ending() const { return pattern.fromFirstOccurrenceOf("*", false, false); }

    ProcessorView& view;
    StageView::CaptureKind kind;
    juce::String pattern;
    std::unique_ptr<juce::FileChooser> chooser;
    bool isDragged = false;
};

} // namespace idiophone
