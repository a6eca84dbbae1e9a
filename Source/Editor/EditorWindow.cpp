#include "Editor/EditorWindow.h"

namespace idiophone {
namespace {

constexpr int leastParameterHeight = 390, leastObjectHeight = 120;

} // namespace

EditorWindow::EditorWindow(juce::AudioProcessor& audioProcessor, ProcessorView& processorView)
    : AudioProcessorEditor(audioProcessor), view(processorView), presets(view), object(view),
      parameters(view), keyboard(view) {
    setLookAndFeel(&look);
    for (auto* child : std::initializer_list<juce::Component*>{&presets, &object, &parameters,
                                                               &status, &keyboard})
        addAndMakeVisible(child);
    setResizable(true, true);
    setResizeLimits(1080, 560, 3840, 2160);
    setSize(1180, 860);
    startTimerHz(25);
}

EditorWindow::~EditorWindow() {
    setLookAndFeel(nullptr);
}

void EditorWindow::timerCallback() {
    presets.refresh();
    object.refresh();
    parameters.refresh();
    keyboard.refresh();
    status.show(view.takeStatus());
    // In a host the keys of the computer are the host's.
    if (!focusTaken && juce::JUCEApplicationBase::isStandaloneApp() && isShowing()) {
        focusTaken = true;
        keyboard.takeFocus();
    }
}

void EditorWindow::paint(juce::Graphics& g) {
    g.fillAll(palette::background);
}

void EditorWindow::resized() {
    auto area = getLocalBounds().reduced(12, 0);
    presets.setBounds(area.removeFromTop(44));
    area.removeFromBottom(10);
    keyboard.setBounds(area.removeFromBottom(juce::jlimit(64, 140, getHeight() / 7)));
    status.setBounds(area.removeFromBottom(34));
    const int forParameters =
        juce::jmax(leastParameterHeight, juce::roundToInt(0.4 * area.getHeight()));
    const int forObject = area.getHeight() - forParameters;
    object.setVisible(forObject >= leastObjectHeight);
    if (object.isVisible())
        object.setBounds(area.removeFromTop(forObject));
    parameters.setBounds(area);
}

} // namespace idiophone
