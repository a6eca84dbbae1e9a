// Makes an everyday object of a mesh in one click: size, material, and shell or solid.
#pragma once

#include "Editor/Look.h"
#include "Editor/WorkshopView.h"

#include <array>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

struct ObjectShortcut {
    const char* name;
    double longestMetres;
    const char* material;   ///< of the library
    double thicknessMetres; ///< of the shell; also of a solid whose mesh encloses no body
    bool isShell;
    const char* tooltip;
};

inline constexpr std::array objectShortcuts{
    ObjectShortcut{"Bell", 0.12, "Bell bronze", 0.003, true, "Bronze, 12 cm, walls of 3 mm"},
    ObjectShortcut{"Plate", 0.25, "Porcelain", 0.004, true, "Porcelain, 25 cm, walls of 4 mm"},
    ObjectShortcut{"Glass", 0.1, "Glass", 0.002, true, "Glass, 10 cm, walls of 2 mm"},
    ObjectShortcut{"Toy", 0.1, "Tin", 0.001, true, "Tin, 10 cm, walls of 1 mm"},
    ObjectShortcut{"Beam", 0.3, "Rosewood", 0.01, false, "Rosewood, 30 cm, solid"},
    ObjectShortcut{"Anvil", 0.3, "Steel", 0.02, false, "Steel, 30 cm, solid"}};

/// A solid is a shell if its mesh encloses no body. The unit stays as it is.
inline ImportSettings withShortcut(ImportSettings settings, const ObjectShortcut& shortcut) {
    settings.longestMetres = shortcut.longestMetres;
    settings.material = shortcut.material;
    settings.thicknessMetres = shortcut.thicknessMetres;
    settings.method = shortcut.isShell ? "two-layer" : "";
    return settings;
}

/// A row of buttons behind the words "Make it". Needs 360 x 24 pixels.
class ObjectShortcutRow final : public juce::Component {
public:
    ObjectShortcutRow() {
        words.setText("Make it", juce::dontSendNotification);
        addAndMakeVisible(words);
        for (std::size_t i = 0; i < buttons.size(); ++i) {
            const auto& shortcut = objectShortcuts[i];
            buttons[i].setButtonText(shortcut.name);
            buttons[i].setTitle("Make it: " + juce::String(shortcut.name));
            buttons[i].setTooltip(shortcut.tooltip);
            buttons[i].onClick = [this, &shortcut] { onChosen(shortcut); };
            addAndMakeVisible(buttons[i]);
        }
    }

    std::function<void(const ObjectShortcut&)> onChosen;

    /// Marks the shortcut whose settings these are.
    void show(const ImportSettings& settings, bool canMake) {
        for (std::size_t i = 0; i < buttons.size(); ++i) {
            buttons[i].setEnabled(canMake);
            buttons[i].setToggleState(settings == withShortcut(settings, objectShortcuts[i]),
                                      juce::dontSendNotification);
        }
    }

    void resized() override {
        constexpr int gap = 3, wordsWidth = 54;
        auto area = getLocalBounds();
        words.setBounds(area.removeFromLeft(wordsWidth));
        const auto count = static_cast<int>(buttons.size());
        const auto width = static_cast<float>(area.getWidth() + gap) / static_cast<float>(count);
        for (int i = 0; i < count; ++i)
            buttons[static_cast<std::size_t>(i)].setBounds(
                area.withLeft(area.getX() + juce::roundToInt(width * static_cast<float>(i)))
                    .withRight(area.getX() + juce::roundToInt(width * static_cast<float>(i + 1)) -
                               gap));
    }
    void lookAndFeelChanged() override {
        words.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
    }

private:
    TextLabel words;
    std::array<juce::TextButton, objectShortcuts.size()> buttons;
};

} // namespace idiophone
