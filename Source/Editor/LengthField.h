// A field for a length that the user measures and types, with its name above.
#pragma once

#include "Editor/ImportMeasures.h"
#include "Editor/Look.h"

namespace idiophone {

/// Needs 80 x 43 pixels.
class LengthField final : public juce::Component {
public:
    LengthField() {
        name.setAccessible(false);
        name.setInterceptsMouseClicks(false, false);
        field.setEditable(true);
        field.onTextChange = [this] {
            const auto* plainUnit = isInMillimetres() ? "mm" : "cm"; // what the field showed
            if (const auto typed = parseLengthMetres(field.getText(), plainUnit, 1e-4, 20))
                lengthMetres = *typed;
            write();
        };
        showParts(*this, name, field);
    }

    /// `title` is for the screen reader and the mouse.
    void show(const juce::String& words, const juce::String& title, double metres) {
        name.setText(words, juce::dontSendNotification);
        field.setTitle(title);
        field.setTooltip(title + ", in the unit that is shown or with another");
        lengthMetres = metres;
        write();
    }
    double metres() const { return lengthMetres; }

    void resized() override {
        auto area = getLocalBounds();
        name.setBounds(area.removeFromTop(17));
        field.setBounds(area);
    }
    void lookAndFeelChanged() override {
        name.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
        field.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
        field.setColour(juce::Label::outlineColourId, colourOf(*this, LookColour::outline));
    }

private:
    bool isInMillimetres() const { return lengthMetres < 0.01; }
    void write() {
        field.setText(isInMillimetres() ? thicknessText(lengthMetres) : sizeText(lengthMetres),
                      juce::dontSendNotification);
    }

    TextLabel name;
    juce::Label field;
    double lengthMetres = 0;
};

} // namespace idiophone
