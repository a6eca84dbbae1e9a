#include "Editor/CaptureButton.h"

#include "Editor/Utf8.h"

namespace idiophone {
namespace {

constexpr int pixelsToDrag = 6;

juce::File dragFolder() {
    return juce::File::getSpecialLocation(juce::File::tempDirectory).getChildFile("Idiophone");
}

} // namespace

CaptureButton::CaptureButton(ProcessorView& processor,
                             ProcessorView::CaptureKind whichKind,
                             const juce::String& label,
                             const juce::String& tooltip,
                             const juce::String& filePattern)
    : TextButton(label), view(processor), kind(whichKind), pattern(filePattern) {
    setTitle("Capture as " + label);
    setTooltip(tooltip);
    onClick = [this] { save(); };
}

juce::String CaptureButton::fileName() const {
    return "Idiophone capture" + pattern.fromFirstOccurrenceOf("*", false, false);
}

juce::File CaptureButton::writeForDrag() {
    if (!view.hasCaptured())
        return {};
    const auto file = dragFolder().getChildFile(fileName());
    file.getParentDirectory().createDirectory();
    return view.writeCapture(kind, pathOf(file)) ? file : juce::File();
}

bool CaptureButton::isForDrag(const std::filesystem::path& file) {
    return file.parent_path() == pathOf(dragFolder());
}

void CaptureButton::mouseDown(const juce::MouseEvent& event) {
    isDragged = false;
    TextButton::mouseDown(event);
}

void CaptureButton::mouseUp(const juce::MouseEvent& event) {
    if (isDragged)
        setState(buttonNormal); // a drag is no click
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
    if (!view.hasCaptured())
        return view.reportError("There is nothing to save yet: no body has struck anything.");
    const auto start =
        juce::File::getSpecialLocation(juce::File::userDocumentsDirectory).getChildFile(fileName());
    chooser = std::make_unique<juce::FileChooser>(getTitle(), start, pattern);
    chooser->launchAsync(juce::FileBrowserComponent::saveMode |
                             juce::FileBrowserComponent::canSelectFiles |
                             juce::FileBrowserComponent::warnAboutOverwriting,
                         [this](const juce::FileChooser& done) {
                             if (const auto file = done.getResult(); file != juce::File())
                                 view.writeCapture(kind, pathOf(file));
                         });
}

} // namespace idiophone
