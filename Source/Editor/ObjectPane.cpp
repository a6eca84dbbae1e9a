#include "Editor/ObjectPane.h"

#include "Editor/Look.h"

#include <utility>
#include <vector>

namespace idiophone {

namespace {

constexpr int playVelocity = 100;

} // namespace

ObjectPane::ObjectPane(ProcessorView& processor)
    : view(processor), object(processor),
      midi(processor,
           StageView::CaptureKind::midi,
           "MIDI",
           "What the bodies struck, as notes: drag it into the host, or click to save",
           "*.mid"),
      impulses(processor,
               StageView::CaptureKind::impulses,
               "Impulses",
               "What the bodies struck, as a list for `idiophone render --impulses`: drag or click",
               "*.jsonl") {
    addAndMakeVisible(object);
    addSwitch(vibration, "Show how what sounds vibrates, slowed down and exaggerated",
              &ObjectView::setShowsVibration, true);
    addSwitch(nodes, "Show where the strongest mode of what sounds stands still",
              &ObjectView::setShowsNodes, false);
    addSwitch(path, "Show where the keys strike", &ObjectView::setShowsPath, false);
    addSwitch(draw, "Draw over an object to say where the keys strike it",
              &ObjectView::setDrawsPath, false);
    draw.onClick = [this, drawn = draw.onClick] {
        drawn();
        if (draw.getToggleState() && !path.getToggleState())
            path.setToggleState(true, juce::sendNotification);
    };
    addStageButton(play, "Set the bodies in motion, as a key in the middle does");
    play.onClick = [this] {
        const auto range = view.instrument.keyRange();
        const int note = (range.lowest + range.highest) / 2;
        view.instrument.playNote(note, playVelocity);
        view.instrument.playNote(note, 0);
    };
    addStageButton(pause, "Hold the bodies where they are");
    pause.setClickingTogglesState(true);
    pause.onClick = [this] { view.stage.pauseStage(pause.getToggleState()); };
    addStageButton(reset, "Take away what moves, and what was captured of it");
    reset.onClick = [this] { view.stage.resetStage(); };
    addChildComponent(midi);
    addChildComponent(impulses);
    showStageButtons();
}

void ObjectPane::addStageButton(juce::TextButton& button, const juce::String& tooltip) {
    button.setTitle(button.getButtonText());
    button.setTooltip(tooltip);
    addChildComponent(button);
}

void ObjectPane::refresh() {
    object.refresh();
    pause.setToggleState(view.stage.isStagePaused(), juce::dontSendNotification);
    if (object.isOnStage() != play.isVisible())
        showStageButtons();
}

/// On a stage, shows the stage's buttons instead of those of the strike path.
void ObjectPane::showStageButtons() {
    for (juce::Button* button :
         std::initializer_list<juce::Button*>{&play, &pause, &reset, &midi, &impulses})
        button->setVisible(object.isOnStage());
    for (auto* button : {&path, &draw})
        button->setVisible(!object.isOnStage());
    resized();
}

void ObjectPane::addSwitch(juce::TextButton& button,
                           const juce::String& tooltip,
                           void (ObjectView::*change)(bool),
                           bool on) {
    button.setTitle(button.getButtonText());
    button.setTooltip(tooltip);
    button.setClickingTogglesState(true);
    button.setToggleState(on, juce::dontSendNotification);
    button.onClick = [this, &button, change] { (object.*change)(button.getToggleState()); };
    addAndMakeVisible(button);
}

void ObjectPane::resized() {
    constexpr int widestPadding = 18, leastPadding = 6, gap = 4;
    auto area = getLocalBounds();
    auto strip = area.removeFromTop(stripHeight).withTrimmedBottom(gap);
    const juce::Font font = Look::textFont();
    std::vector<std::pair<juce::Button*, int>> shown; // with the width of its text in pixels
    int textWidth = 0;
    for (juce::Button* button : std::initializer_list<juce::Button*>{
             &vibration, &nodes, &path, &draw, &play, &pause, &reset, &midi, &impulses})
        if (button->isVisible()) {
            shown.emplace_back(button, juce::roundToInt(juce::GlyphArrangement::getStringWidth(
                                           font, button->getButtonText())));
            textWidth += shown.back().second + gap;
        }
    const int padding = juce::jlimit(leastPadding, widestPadding,
                                     (getWidth() - textWidth) / static_cast<int>(shown.size()));
    for (const auto& [button, width] : shown)
        button->setBounds(strip.removeFromLeft(width + padding + gap).withTrimmedRight(gap));
    object.setBounds(area);
}

} // namespace idiophone
