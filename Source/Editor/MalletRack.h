// The row of mallets; a click selects one.
#pragma once

#include "Editor/ControlMenu.h"
#include "Editor/LeftClicked.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"
#include "Object/Mallet.h"

#include <algorithm>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <vector>

namespace idiophone {

class MalletRack final : public juce::Component {
public:
    explicit MalletRack(ProcessorView& processor)
        : view(processor), controlMenu(*this, parameterInfo(ParameterId::mallet), processor) {
        setTitle("Mallet");
        setFocusContainerType(FocusContainerType::focusContainer);
        const auto names = choiceNames(ParameterId::mallet);
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto name = fromUtf8(names[i]);
            auto mallet = std::make_unique<MalletButton>(name, headOf(i));
            mallet->onClick = [this, i, button = mallet.get()] {
                if (!button->getToggleState() ||
                    view.parameters.value(ParameterId::mallet) == double(i))
                    return;
                view.parameters.changeOnce(ParameterId::mallet, double(i));
                refresh();
            };
            addAndMakeVisible(*mallet);
            mallets.push_back(std::move(mallet));
        }
        refresh();
    }

    /// The menu for a right click or Shift+F10.
    juce::PopupMenu menu() const { return controlMenu.popup(); }

    void refresh() {
        showController();
        const int now = static_cast<int>(view.parameters.value(ParameterId::mallet));
        if (now == shown)
            return;
        shown = now;
        for (std::size_t i = 0; i < mallets.size(); ++i)
            mallets[i]->setToggleState(static_cast<int>(i) == now, juce::dontSendNotification);
    }

    void resized() override {
        auto area = getLocalBounds();
        const int width = area.getWidth() / static_cast<int>(mallets.size());
        for (auto& mallet : mallets)
            mallet->setBounds(area.removeFromLeft(width));
    }

private:
    struct Head {
        float diameter = 0; ///< share of the available space; 0: the custom mallet
        juce::Colour colour;
    };

    static constexpr double largestRadiusMetres = 0.025;

    static Head headOf(std::size_t choice) {
        if (choice < firstRackMallet)
            return {};
        const auto& mallet = malletRack()[choice - firstRackMallet];
        return {.diameter = static_cast<float>(
                    std::min(mallet.headRadiusMetres / largestRadiusMetres, 1.0)),
                .colour = juce::Colour(mallet.colour).withAlpha(1.0f)};
    }
    void showController() {
        const auto sentence =
            controllerSentence(parameterInfo(ParameterId::mallet), view.controllers);
        if (sentence == getDescription())
            return;
        setDescription(sentence);
        for (auto& mallet : mallets)
            mallet->setHint(sentence);
    }

    class MalletButton final : public LeftClicked<juce::Button> {
    public:
        MalletButton(const juce::String& title, Head look) : LeftClicked(title), head(look) {
            setTitle(title + " mallet");
            setHint({});
            setClickingTogglesState(true);
            setRadioGroupId(1, juce::dontSendNotification);
        }

        /// Says what a click does, and then a sentence about the mallet's controller.
        void setHint(const juce::String& sentence) {
            setTooltip((head.diameter > 0
                            ? "Take the " + getButtonText().toLowerCase() + " mallet"
                            : juce::String("Hardness, weight, size and winding as set below")) +
                       (sentence.isEmpty() ? juce::String() : "\n" + sentence));
        }

        void paintButton(juce::Graphics& g, bool highlighted, bool) override {
            const bool on = getToggleState();
            auto area = getLocalBounds().toFloat().reduced(1);
            if (on || highlighted || hasKeyboardFocus(false)) {
                g.setColour(colourOf(*this, LookColour::outline).withAlpha(on ? 1.0f : 0.5f));
                g.fillRoundedRectangle(area, 5);
            }
            if (hasKeyboardFocus(false) || on) {
                g.setColour(colourOf(*this, LookColour::accent));
                g.drawRoundedRectangle(area, 5, on ? 1.5f : 1.0f);
            }
            const auto label = area.removeFromBottom(24).toNearestInt();
            paintHead(g, area.reduced(2));
            g.setColour(colourOf(*this, LookColour::text));
            g.setFont(Look::textFont(10.5f));
            g.drawFittedText(getButtonText(), label, juce::Justification::centred, 2, 0.8f);
        }

    private:
        void paintHead(juce::Graphics& g, juce::Rectangle<float> area) const {
            if (head.diameter == 0) { // the custom mallet: an icon of three sliders
                for (int line = 0; line < 3; ++line) {
                    const float y = area.getCentreY() + 7 * static_cast<float>(line - 1);
                    const float knob = area.getCentreX() + (line == 1 ? -6.0f : 5.0f);
                    g.setColour(colourOf(*this, LookColour::dimText));
                    g.fillRect(juce::Rectangle<float>(24, 1.5f).withCentre({area.getCentreX(), y}));
                    g.setColour(colourOf(*this, LookColour::accent));
                    g.fillEllipse(juce::Rectangle<float>(6, 6).withCentre({knob, y}));
                }
                return;
            }
            const float size = juce::jmin(area.getHeight() * 0.8f, 24.0f) * head.diameter;
            const juce::Point<float> at(area.getCentreX() + 5, area.getCentreY() - 4);
            g.setColour(colourOf(*this, LookColour::dimText));
            g.drawLine({at, {area.getCentreX() - 11, area.getBottom() - 1}}, 2.2f);
            const auto ball = juce::Rectangle<float>(size, size).withCentre(at);
            const auto colour = head.colour;
            g.setGradientFill({colour.brighter(0.5f),
                               ball.getTopLeft() + juce::Point(size * 0.3f, size * 0.25f),
                               colour.darker(0.3f), ball.getBottomRight(), true});
            g.fillEllipse(ball);
        }

        Head head;
    };

    ProcessorView& view;
    ControlMenu controlMenu;
    std::vector<std::unique_ptr<MalletButton>> mallets;
    int shown = -1;
};

} // namespace idiophone
