#include "Editor/CaptureButton.h"

#include "Editor/Utf8.h"
#include "Object/FileBytes.h"

namespace idiophone {
namespace {

constexpr int pixelsToDrag = 6;
constexpr const char* captureName = "Idiophone capture";
constexpr const char* dragFolderPrefix = "Idiophone-drag-";

juce::File temporaryFolder() {
    return juce::File::getSpecialLocation(juce::File::tempDirectory);
}

/// Returns this process's temporary folder, because several users may share the system's. It is
/// created again if somebody deleted it, and never removed: hosts may still read dropped files.
juce::File dragFolder() {
    static juce::File folder;
    constexpr int mostTries = 100;
    for (int tried = 0; tried < mostTries && !folder.isDirectory(); ++tried) {
        const auto next = temporaryFolder().getChildFile(
            dragFolderPrefix + juce::String::toHexString(juce::Random().nextInt64()));
        const auto path = pathOf(next);
        std::error_code fault;
        if (!std::filesystem::create_directory(path, fault) || fault)
            continue; // perhaps another process owns this name
        std::filesystem::permissions(path, std::filesystem::perms::owner_all, fault);
        folder = next;
    }
    return folder;
}

} // namespace

CaptureButton::CaptureButton(ProcessorView& processor,
                             StageView::CaptureKind whichKind,
                             const juce::String& label,
                             const juce::String& tooltip,
                             const juce::String& filePattern)
    : TextButton(label), view(processor), kind(whichKind), pattern(filePattern) {
    setTitle("Capture as " + label);
    setTooltip(tooltip);
    onClick = [this] { save(); };
}

juce::String CaptureButton::ending() const {
    return pattern.fromFirstOccurrenceOf("*", false, false);
}

juce::File CaptureButton::writeForDrag() {
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

bool CaptureButton::isForDrag(const std::filesystem::path& file) {
    const auto folder = file.parent_path();
    return folder.parent_path() == pathOf(temporaryFolder()) &&
           nameOf(folder.filename()).starts_with(dragFolderPrefix);
}

void CaptureButton::mouseDown(const juce::MouseEvent& event) {
    isDragged = false;
    TextButton::mouseDown(event);
}

void CaptureButton::mouseUp(const juce::MouseEvent& event) {
    if (isDragged)
        setState(buttonNormal); // a drag does not click
    else
        TextButton::mouseUp(event);
}

void CaptureButton::mouseDrag(const juce::MouseEvent& event) {
    if (isDragged || event.getDistanceFromDragStart() < pixelsToDrag)
        return TextButton::mouseDrag(event);
    isDragged = true;
    if (const auto file = writeForDrag(); file != juce::File())
        juce::DragAndDropContainer::performExternalDragDropOfFiles({file.getFullPathName()}, false,
                                                                   this);
}

void CaptureButton::save() {
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

void CaptureButton::save(const juce::File& chosen) {
    const auto file =
        chosen.getFileExtension().isEmpty() ? chosen.withFileExtension(ending()) : chosen;
    if (file != chosen && file.exists())
        return view.status.reportError("There is already a file " +
                                       file.getFileName().toStdString() + ".");
    view.stage.writeCapture(kind, pathOf(file));
}

} // namespace idiophone
