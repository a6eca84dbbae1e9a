// A button for captured notes or sound: a drag exports them as a file, and a click saves them.
#pragma once

#include "Editor/DragFolder.h"
#include "Editor/DragOutButton.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <filesystem>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <string>
#include <utility>

namespace idiophone {

/// The file that a CaptureButton exports.
struct Capture {
    juce::String pattern;                                    ///< gives the file extension: "*.mid"
    std::function<juce::String()> name;                      ///< of a new file, without extension
    std::function<bool()> isThere;                           ///< whether there is anything to write
    std::function<bool(const std::filesystem::path&)> write; ///< false on failure, in the status
    std::string nothing;                                     ///< a sentence if nothing is there
};

/// The impacts of a stage's bodies.
inline Capture
stageCapture(StageView& stage, StageView::CaptureKind kind, const juce::String& pattern) {
    return {.pattern = pattern,
            .name = [] { return juce::String("Idiophone capture"); },
            .isThere = [&stage] { return stage.hasCaptured(); },
            .write =
                [&stage, kind](const std::filesystem::path& file) {
                    return stage.writeCapture(kind, file);
                },
            .nothing = "There is nothing to save yet: no body has struck anything."};
}

/// The last seconds of the output.
inline Capture soundCapture(RecorderView& recorder) {
    return {.pattern = "*.wav",
            .name = [&recorder] { return fromUtf8(recorder.newName()); },
            .isThere = [&recorder] { return recorder.hasLastSound(); },
            .write =
                [&recorder](const std::filesystem::path& file) {
                    return recorder.writeLastSound(file);
                },
            .nothing = "There is nothing to save yet: no sound was heard in the last 30 seconds."};
}

/// `Kind` is the kind of button, and `parts` are what its constructor takes.
template <class Kind>
class CaptureButton final : public DragOutButton<Kind> {
public:
    template <class... Parts>
    CaptureButton(StatusView& statusView, Capture exported, Parts&&... parts)
        : DragOutButton<Kind>(std::forward<Parts>(parts)...), status(statusView),
          capture(std::move(exported)) {
        this->fileToDrag = [this] { return take(); };
        this->onClick = [this] { chooseFile(); };
    }

    /// Writes what is there now to a file in the DragFolder. Returns an empty File on failure, with
    /// the reason in the status.
    juce::File take() {
        if (!capture.isThere()) {
            status.reportError(capture.nothing);
            return {};
        }
        const auto folder = DragFolder::get();
        if (!folder.isDirectory()) {
            status.reportError("There is no place to put the capture for dragging.");
            return {};
        }
        const auto file = folder.getNonexistentChildFile(capture.name(), ending());
        return capture.write(pathOf(file)) ? file : juce::File();
    }
    /// Moves a taken file to the chosen path, and adds the extension if it is missing. Then an
    /// existing file is not replaced, because the chooser has not asked about it.
    void save(const juce::File& taken, const juce::File& chosen) {
        const auto file =
            chosen.getFileExtension().isEmpty() ? chosen.withFileExtension(ending()) : chosen;
        if (file != chosen && file.exists())
            return status.reportError("There is already a file " +
                                      file.getFileName().toStdString() + ".");
        if (!taken.replaceFileIn(file))
            status.reportError("The file " + file.getFullPathName().toStdString() +
                               " cannot be written. Choose another folder.");
    }

private:
    /// Takes the file first, because the sound goes on while the chooser is open.
    void chooseFile() {
        const auto taken = take();
        if (taken == juce::File())
            return;
        const auto start = juce::File::getSpecialLocation(juce::File::userDocumentsDirectory)
                               .getChildFile(taken.getFileName());
        chooser = std::make_unique<juce::FileChooser>(this->getTitle(), start, capture.pattern);
        chooser->launchAsync(juce::FileBrowserComponent::saveMode |
                                 juce::FileBrowserComponent::canSelectFiles |
                                 juce::FileBrowserComponent::warnAboutOverwriting,
                             [this, taken](const juce::FileChooser& done) {
                                 if (const auto file = done.getResult(); file != juce::File())
                                     save(taken, file);
                                 taken.deleteFile();
                             });
    }
    juce::String ending() const { return capture.pattern.fromFirstOccurrenceOf("*", false, false); }

    StatusView& status;
    Capture capture;
    std::unique_ptr<juce::FileChooser> chooser;
};

} // namespace idiophone
