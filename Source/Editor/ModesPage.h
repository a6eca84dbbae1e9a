// The page with the modes of an object: marks the sounding ones, and mutes or solos them.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/ModeSpectrum.h"
#include "Editor/ModeText.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>

namespace idiophone {

class ModesPage final : public DeckPage {
public:
    explicit ModesPage(ProcessorView& processor)
        : DeckPage("Modes"), view(processor), spectrum(processor.sound) {
        objects.setTitle("Object");
        objects.setTooltip("The object whose modes are shown");
        objects.onChange = [this] {
            const int chosen = objects.getSelectedId() - lastPlayedId;
            view.sound.watchObject(chosen > 0 ? std::optional(static_cast<std::size_t>(chosen - 1))
                                              : std::nullopt);
        };
        addButton(mute, "Mute mode", "Mute the chosen mode (M)",
                  [this] { spectrum.toggleMute(spectrum.modeChosen().value_or(0)); });
        addButton(alone, "Solo mode", "Hear the chosen mode alone (S); not saved",
                  [this] { spectrum.toggleAlone(spectrum.modeChosen().value_or(0)); });
        addButton(all, "Hear all modes", "Unmute all modes of this object and end its solos",
                  [this] {
                      const auto object =
                          static_cast<std::size_t>(std::max(spectrum.frameShown().object, 0));
                      view.sound.unmuteModes(object);
                      view.sound.hearAllModes(object);
                  });
        spectrum.onModeShown = [this] { modeShown(); };
        showParts(*this, objects, spectrum);
        listObjects();
        describe();
    }

    void refresh() override {
        if (view.instrument.instrumentNumber() != listedInstrument)
            listObjects();
        const auto watched = view.sound.watchedObject();
        const int id = watched ? lastPlayedId + 1 + static_cast<int>(*watched) : lastPlayedId;
        if (id != objects.getSelectedId())
            objects.setSelectedId(id, juce::dontSendNotification);
    }
    void showSound(const SoundFrame& frame) override {
        spectrum.show(frame);
        const bool any = std::ranges::any_of(
            frame.modes, [](const ModeNow& mode) { return mode.isMuted || mode.isHeardAlone; });
        all.setEnabled(any);
        describe();
    }

    /// Called when the shown mode (hovered or chosen, of the last frame's object) changes or
    /// disappears.
    std::function<void(std::optional<std::size_t> mode)> onModeShown;

    void paint(juce::Graphics& g) override {
        auto area = lineArea;
        g.setFont(Look::textFont(12.5f));
        for (int line = 0; line < lines.size(); ++line) {
            g.setColour(colourOf(*this, line == 0 ? LookColour::text : LookColour::dimText));
            g.drawFittedText(lines[line], area.removeFromTop(lineHeight),
                             juce::Justification::centredLeft, 1, 0.8f);
        }
    }
    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        auto bar = area.removeFromTop(barHeight);
        all.setBounds(bar.removeFromRight(44));
        bar.removeFromRight(4);
        alone.setBounds(bar.removeFromRight(50));
        bar.removeFromRight(4);
        mute.setBounds(bar.removeFromRight(50));
        bar.removeFromRight(gap);
        objects.setBounds(bar);
        lineArea = area.removeFromBottom(2 * lineHeight);
        area.removeFromTop(gap);
        area.removeFromBottom(4);
        spectrum.setBounds(area);
    }
    void visibilityChanged() override { modeShown(); }

private:
    static constexpr int barHeight = 26, lineHeight = 16, gap = 6;
    static constexpr int lastPlayedId = 1; // item number; the objects follow

    void listObjects() {
        listedInstrument = view.instrument.instrumentNumber();
        objects.clear(juce::dontSendNotification);
        objects.addItem("Played last", lastPlayedId);
        int id = lastPlayedId;
        for (const auto& played : view.instrument.playedObjects())
            objects.addItem(objectText(played), ++id);
    }
    void modeShown() {
        describe();
        const auto now = isVisible() ? spectrum.modeShown() : std::nullopt;
        if (now == lastShown)
            return;
        lastShown = now;
        if (onModeShown)
            onModeShown(now);
    }
    /// The buttons act on the chosen mode; the text describes the shown one.
    void describe() {
        const auto& frame = spectrum.frameShown();
        const auto chosen = spectrum.modeChosen();
        const bool exists = chosen && *chosen < frame.modes.size();
        mute.setEnabled(exists);
        alone.setEnabled(exists);
        mute.setToggleState(exists && frame.modes[*chosen].isMuted, juce::dontSendNotification);
        alone.setToggleState(exists && frame.modes[*chosen].isHeardAlone,
                             juce::dontSendNotification);

        juce::StringArray next;
        if (const auto mode = spectrum.modeShown(); mode && *mode < frame.modes.size()) {
            next = describeMode(frame, *mode);
        } else if (!frame.modes.empty()) {
            const auto sounding =
                std::ranges::count(frame.modes, ModeStanding::sounding, &ModeNow::standing);
            const int groups = frame.modes.back().group + 1;
            next.add((frame.note >= 0 ? noteName(frame.note) + ": " : juce::String()) +
                     juce::String(frame.modes.size()) + " modes, mixed as " + juce::String(groups) +
                     ", " + juce::String(sounding) + " sounding");
            next.add(
                frame.modesOmitted > 0
                    ? juce::String(frame.modesOmitted) + " more are too high to be shown"
                    : juce::String("Line: level now, dot: decay time, foot: modes mixed as one"));
        }
        if (next == lines)
            return;
        lines = next;
        repaint(lineArea);
    }

    ProcessorView& view;
    int listedInstrument = -1;
    juce::ComboBox objects;
    juce::TextButton mute{"Mute"}, alone{"Solo"}, all{"All"};
    ModeSpectrum spectrum;
    juce::StringArray lines; ///< text about the shown mode
    juce::Rectangle<int> lineArea;
    std::optional<std::size_t> lastShown; ///< last value passed to `onModeShown`
};

} // namespace idiophone
