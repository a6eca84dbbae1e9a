// The top of the window: the product's name, the preset with its neighbours, and actions on the
// whole sound: favourite, save, compare, mutate, undo, redo.
#pragma once

#include "Editor/CompareSwitch.h"
#include "Editor/IconButton.h"
#include "Editor/Icons.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Needs at least 640 x 40 pixels.
class PresetBar final : public juce::Component {
public:
    explicit PresetBar(ProcessorView& processor)
        : view(processor), previous("Previous preset", icons::previous()),
          next("Next preset", icons::next()), favourite("Favourite", icons::star()),
          saving("Save", icons::save()), mutation("Mutate", icons::dice()),
          copying("Copy A to B", icons::copy()), undo("Undo", icons::undo()),
          redo("Redo", icons::redo()) {
        view.presets.readPresets();
        name.onClick = [this] { juce::NullCheckedInvocation::invoke(onBrowse); };
        previous.onClick = [this] { step(-1); };
        next.onClick = [this] { step(1); };
        favourite.setPictureOff(icons::starOutline());
        favourite.onClick = [this] { toggleFavourite(); };
        saving.onClick = [this] { save(); };
        saving.describe("Save", "Save the sound as a preset (" + commandKey("S") + ")");
        mutation.onClick = [this] { mutate(clearly); };
        mutation.onMenu = [this] { showMutationMenu(); };
        mutation.describe("Mutate",
                          "Play a random variation of this sound. Right-click for its strength.");
        compare.onClick = [this] { view.variants.compare(); };
        copying.onClick = [this] { view.variants.copyToOther(); };
        undo.onClick = [this] { view.history.undo(); };
        redo.onClick = [this] { view.history.redo(); };
        showParts(*this, previous, name, next, favourite, saving, compare, copying, mutation, undo,
                  redo);
        refresh();
    }

    /// Called to open the list of presets, and to ask for the name of a new preset.
    std::function<void()> onBrowse;
    std::function<void()> onSaveAs;
    /// Called when a neighbour of the preset was loaded.
    std::function<void()> onStep;

    void refresh() {
        refreshPreset();
        refreshHistory();
    }
    /// Overwrites the user's current preset. For a factory preset or none, asks for a name.
    void save() {
        const auto* preset = chosen();
        if (preset == nullptr || preset->isFactory)
            return juce::NullCheckedInvocation::invoke(onSaveAs);
        report(view.presets.saveChosenPreset());
    }
    /// Handles the usual keys for undo, redo and save, from anywhere in the window.
    bool handleKey(const juce::KeyPress& key) {
        using juce::KeyPress;
        constexpr int command = juce::ModifierKeys::commandModifier;
        if (key == KeyPress('z', command, 0))
            view.history.undo();
        else if (key == KeyPress('z', command | juce::ModifierKeys::shiftModifier, 0) ||
                 key == KeyPress('y', command, 0))
            view.history.redo();
        else if (key == KeyPress('s', command, 0))
            save();
        else
            return false;
        refresh();
        return true;
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::accent));
        g.setFont(Look::headingFont(21));
        g.drawText("Idiophone", logo, juce::Justification::centredLeft, false);
    }
    void resized() override {
        auto area =
            getLocalBounds().withSizeKeepingCentre(getWidth(), juce::jmin(getHeight(), button));
        logo = area.removeFromLeft(logoWidth);
        redo.setBounds(area.removeFromRight(button));
        undo.setBounds(area.removeFromRight(button));
        area.removeFromRight(gap);
        mutation.setBounds(area.removeFromRight(button));
        area.removeFromRight(gap);
        copying.setBounds(area.removeFromRight(button));
        compare.setBounds(area.removeFromRight(compareWidth));
        area.removeFromRight(gap);
        const int width = juce::jmin(area.getWidth(), maximumNameWidth + 4 * button);
        area = area.withSizeKeepingCentre(width, area.getHeight());
        previous.setBounds(area.removeFromLeft(button));
        saving.setBounds(area.removeFromRight(button));
        favourite.setBounds(area.removeFromRight(button));
        next.setBounds(area.removeFromRight(button));
        name.setBounds(area);
    }

private:
    static constexpr int gap = 6, button = 28, compareWidth = 52, logoWidth = 112;
    static constexpr int maximumNameWidth = 420;
    static constexpr double slightly = 0.1, clearly = 0.3, boldly = 1;

    /// A shortcut in the notation of this system.
    static juce::String commandKey(const char* letter, bool shift = false) {
#if JUCE_MAC
        return fromUtf8(shift ? "\xe2\x87\xa7\xe2\x8c\x98" : "\xe2\x8c\x98") + letter; // ⇧⌘
#else
        return juce::String(shift ? "Ctrl+Shift+" : "Ctrl+") + letter;
#endif
    }

    /// Shows the preset's name. A dot behind it means that the sound has changed.
    class NameButton final : public juce::Button {
    public:
        NameButton() : Button("Preset") { setTitle("Preset"); }

        void show(const juce::String& preset, bool edited, const juce::String& description) {
            if (preset == getButtonText() && edited == isEdited && description == getTooltip())
                return;
            isEdited = edited;
            setButtonText(preset);
            setTooltip(description);
            setDescription(edited ? "Changed; opens the list of presets"
                                  : "Opens the list of presets");
            repaint();
        }

        void paintButton(juce::Graphics& g, bool highlighted, bool) override {
            const auto area = getLocalBounds().toFloat().reduced(0.75f);
            g.setColour(colourOf(*this, LookColour::background));
            g.fillRoundedRectangle(area, 5);
            g.setColour(colourOf(*this, hasKeyboardFocus(false) || highlighted
                                            ? LookColour::accent
                                            : LookColour::outline));
            g.drawRoundedRectangle(area, 5, 1.5f);
            auto line = getLocalBounds().reduced(12, 0);
            if (isEdited) {
                g.setColour(colourOf(*this, LookColour::accent));
                g.fillEllipse(line.removeFromRight(8).toFloat().withSizeKeepingCentre(7, 7));
                line.removeFromRight(4);
            }
            g.setColour(colourOf(*this, LookColour::text));
            g.setFont(Look::headingFont(15));
            g.drawFittedText(getButtonText(), line, juce::Justification::centred, 1, 0.75f);
        }

    private:
        bool isEdited = false;
    };

    /// Loads the next playable preset, and wraps at the ends.
    void step(int by) {
        auto& shelf = view.presets;
        const auto count = static_cast<int>(shelf.presets().size());
        const auto* now = chosen();
        int place =
            now == nullptr ? (by > 0 ? -1 : count) : static_cast<int>(now - shelf.presets().data());
        for (int tried = 0; tried < count; ++tried) {
            place = (place + by + count) % count;
            const auto preset = shelf.presets()[static_cast<std::size_t>(place)];
            if (!preset.fault.empty())
                continue;
            const auto loaded = shelf.loadPreset(preset.id);
            report(loaded);
            if (loaded)
                juce::NullCheckedInvocation::invoke(onStep);
            return;
        }
    }
    void toggleFavourite() {
        if (const auto* preset = chosen()) {
            const auto id = preset->id;
            report(view.presets.setFavourite(id, !preset->isFavourite));
        }
    }
    void mutate(double strength) {
        view.variants.mutate(strength,
                             static_cast<std::uint32_t>(juce::Random::getSystemRandom().nextInt()));
        refresh();
    }
    void showMutationMenu() {
        juce::PopupMenu menu;
        const juce::Component::SafePointer<PresetBar> bar(this);
        for (const auto& [text, strength] : {std::pair("Mutate slightly", slightly),
                                             {"Mutate clearly", clearly},
                                             {"Mutate boldly", boldly}})
            menu.addItem(text, [bar, strength] {
                if (bar != nullptr)
                    bar->mutate(strength);
            });
        menu.setLookAndFeel(&getLookAndFeel());
        menu.showMenuAsync(
            juce::PopupMenu::Options().withTargetComponent(mutation).withDeletionCheck(*this));
    }
    void refreshPreset() {
        const auto playing = view.presets.playingPreset();
        name.show(fromUtf8(playing.details.name), playing.isChanged,
                  fromUtf8(playing.details.description));
        const auto* preset = presetOf(playing.id);
        favourite.setEnabled(preset != nullptr);
        favourite.setToggleState(preset != nullptr && preset->isFavourite,
                                 juce::dontSendNotification);
        favourite.describe(favourite.getToggleState() ? "Remove favourite" : "Favourite",
                           favourite.getToggleState() ? "Remove the preset from the favourites"
                                                      : "Add the preset to the favourites");
    }
    void refreshHistory() {
        auto& history = view.history;
        undo.setEnabled(history.canUndo());
        redo.setEnabled(history.canRedo());
        undo.describe("Undo",
                      "Undo " + fromUtf8(history.undoName()) + " (" + commandKey("Z") + ")");
        redo.describe("Redo",
                      "Redo " + fromUtf8(history.redoName()) + " (" + commandKey("Z", true) + ")");
        const bool isB = view.variants.playsB();
        compare.setToggleState(isB, juce::dontSendNotification);
        copying.describe(isB ? "Copy B to A" : "Copy A to B",
                         isB ? "Copy the current sound B to A" : "Copy the current sound A to B");
    }
    const ShelvedPreset* chosen() const {
        return presetOf(view.presets.playingPreset().id);
    }
    const ShelvedPreset* presetOf(const std::string& id) const {
        const auto& presets = view.presets.presets();
        const auto found = std::ranges::find(presets, id, &ShelvedPreset::id);
        return found == presets.end() ? nullptr : &*found;
    }
    void report(const Result<void>& outcome) {
        if (!outcome)
            view.status.reportError(outcome.error().message);
        refresh();
    }

    ProcessorView& view;
    NameButton name;
    IconButton previous, next, favourite, saving, mutation, copying, undo, redo;
    CompareSwitch compare;
    juce::Rectangle<int> logo;
};

} // namespace idiophone
