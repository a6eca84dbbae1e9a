// The picture of the instrument, under a strip of switches for what it shows.
#pragma once

#include "Editor/CaptureButton.h"
#include "Editor/IconButton.h"
#include "Editor/Icons.h"
#include "Editor/Look.h"
#include "Editor/ObjectView.h"

#include <numeric>
#include <utility>
#include <vector>

namespace idiophone {

class ObjectPane final : public juce::Component {
public:
    explicit ObjectPane(ProcessorView& processor)
        : view(processor), object(processor),
          midi(processor.status,
               stageCapture(processor.stage, StageView::CaptureKind::midi, "*.mid"),
               "MIDI"),
          impulses(processor.status,
                   stageCapture(processor.stage, StageView::CaptureKind::impulses, "*.jsonl"),
                   "Impulses") {
        addAndMakeVisible(object);
        add(vibration, "Show the vibration of sounding objects, slowed down and exaggerated", true);
        add(nodes, "Show where the strongest sounding mode does not move", true);
        add(path, "Show where the keys strike", true);
        add(draw, "Draw on an object to set where the keys strike it", true);
        add(held,
            "Show where objects are held. If the Object page holds a painted region, drag over the "
            "object to paint it, with Shift to let it go.",
            true);
        vibration.setToggleState(true, juce::dontSendNotification);
        for (auto* button : {&vibration, &nodes, &path, &draw, &held})
            button->onClick = [this] { setLayers(); };
        draw.onClick = [this] {
            if (draw.getToggleState()) {
                path.setToggleState(true, juce::dontSendNotification);
                held.setToggleState(false, juce::dontSendNotification);
            }
            setLayers();
        };
        add(play, "Set the bodies in motion, as a key in the middle does", false);
        play.onClick = [this] {
            constexpr int velocity = 100;
            const auto range = view.instrument.keyRange();
            const int note = (range.lowest + range.highest) / 2;
            view.instrument.playNote(note, velocity);
            view.instrument.playNote(note, 0);
        };
        add(pause, "Stop the bodies where they are", true);
        pause.onClick = [this] { view.stage.pauseStage(pause.getToggleState()); };
        add(reset, "Remove the bodies and their captured impacts", false);
        reset.onClick = [this] { view.stage.resetStage(); };
        add(midi, "The impacts of the bodies as notes. Drag into the host, or click to save.",
            false);
        add(impulses,
            "The impacts of the bodies as a list for `idiophone render --impulses`. Drag or click.",
            false);
        for (auto* button : {&midi, &impulses})
            button->setTitle("Capture as " + button->getButtonText());
        framing.describe("Frame", "Show the whole instrument from the front");
        framing.onClick = [this] { object.frame(); };
        addAndMakeVisible(framing);
        showStageButtons();
    }

    ObjectView& picture() { return object; }

    void refresh() {
        object.refresh();
        followHeld();
        pause.setToggleState(view.stage.isStagePaused(), juce::dontSendNotification);
        if (object.isOnStage() != play.isVisible())
            showStageButtons();
    }

    void resized() override {
        constexpr int stripHeight = 28, maximumPadding = 18, minimumPadding = 6, gap = 4;
        auto area = getLocalBounds();
        auto row = area.removeFromTop(stripHeight).withTrimmedBottom(gap);
        framing.setBounds(row.removeFromRight(row.getHeight()));
        std::vector<std::pair<juce::Button*, int>> shown; // with the width of its text in pixels
        for (auto* button : strip)
            if (button->isVisible())
                shown.emplace_back(button, juce::roundToInt(juce::GlyphArrangement::getStringWidth(
                                               Look::textFont(), button->getButtonText())));
        const int textWidth =
            std::accumulate(shown.begin(), shown.end(), 0,
                            [](int sum, const auto& each) { return sum + each.second + gap; });
        const int padding =
            juce::jlimit(minimumPadding, maximumPadding,
                         (row.getWidth() - textWidth) / static_cast<int>(shown.size()));
        for (const auto& [button, width] : shown)
            button->setBounds(row.removeFromLeft(width + padding + gap).withTrimmedRight(gap));
        object.setBounds(area);
    }

private:
    void add(juce::TextButton& button, const juce::String& tooltip, bool isSwitch) {
        button.setTitle(button.getButtonText());
        button.setTooltip(tooltip);
        button.setClickingTogglesState(isSwitch);
        addAndMakeVisible(button);
    }
    /// The choice of a painted region takes up its brush.
    void followHeld() {
        const bool paints =
            view.workshop.canAnalyseAgain() &&
            view.workshop.importStatus().settings.held.kind == HeldSettings::Kind::places;
        if (std::exchange(paintsHeld, paints) == paints)
            return;
        if (paints) {
            held.setToggleState(true, juce::dontSendNotification);
            draw.setToggleState(false, juce::dontSendNotification);
        }
        setLayers();
    }
    void setLayers() {
        object.setLayers(
            {.vibration = vibration.getToggleState(),
             .nodes = nodes.getToggleState(),
             .path = path.getToggleState(),
             .drawsPath = draw.getToggleState(),
             .held = held.getToggleState(),
             .paintsHeld = paintsHeld && held.getToggleState() && !draw.getToggleState()});
    }
    /// On a stage, shows the stage's buttons instead of those of the strike path.
    void showStageButtons() {
        for (auto* button : strip)
            button->setVisible(button == &vibration || button == &nodes ||
                               (button == &path || button == &draw || button == &held) !=
                                   object.isOnStage());
        resized();
    }

    ProcessorView& view;
    ObjectView object;
    juce::TextButton vibration{"Vibration"}, nodes{"Nodal lines"}, path{"Strike path"},
        draw{"Draw path"}, held{"Held"};
    // These are visible on a stage only.
    juce::TextButton play{"Play"}, pause{"Pause"}, reset{"Reset"};
    CaptureButton<juce::TextButton> midi, impulses;
    IconButton framing{"Frame", icons::frame()};
    const std::vector<juce::TextButton*> strip{&vibration, &nodes, &path,  &draw, &held,
                                               &play,      &pause, &reset, &midi, &impulses};
    bool paintsHeld = false; ///< whether a painted region holds the object
};

} // namespace idiophone
