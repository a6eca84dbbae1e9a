#include "Editor/Look.h"

#include "Editor/IconButton.h"
#include "Editor/Icons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace idiophone {

namespace {

using Palette = std::array<juce::uint32,
                           static_cast<std::size_t>(LookColour::count) -
                               static_cast<std::size_t>(LookColour::background)>;

// In the order of LookColour.
constexpr Palette darkPalette{0xff15171b, 0xff1d2026, 0xff2e333c, 0xffe3e6eb, 0xff9aa3b2,
                              0xffdca65f, 0xff15171b, 0xffff8a75, 0xff6fc3e0};
constexpr Palette lightPalette{0xffe9e6df, 0xfff8f6f2, 0xffc9c4b9, 0xff23262b, 0xff565c66,
                               0xff8a5210, 0xffffffff, 0xffb02a1c, 0xff17617f};

const juce::Identifier modulatedFrom("modulatedFrom"), modulatedTo("modulatedTo");

std::optional<juce::Range<double>> modulatedPlaces(juce::Slider& slider) {
    const auto& properties = slider.getProperties();
    if (!properties.contains(modulatedFrom))
        return std::nullopt;
    return juce::Range<double>(properties[modulatedFrom], properties[modulatedTo]);
}

} // namespace

juce::Colour colourOf(LookScheme scheme, LookColour colour) {
    const auto index =
        static_cast<std::size_t>(colour) - static_cast<std::size_t>(LookColour::background);
    return juce::Colour((scheme == LookScheme::dark ? darkPalette : lightPalette)[index]);
}

juce::Colour colourOf(const juce::Component& component, LookColour colour) {
    return component.findColour(static_cast<int>(colour));
}

Look::Look(LookScheme scheme) : current(scheme) {
    setScheme(scheme);
}

void Look::setScheme(LookScheme scheme) {
    current = scheme;
    const auto of = [&](LookColour colour) { return colourOf(scheme, colour); };
    using enum LookColour;
    setColourScheme({of(background), of(panel), of(panel), of(outline), of(text), of(outline),
                     of(onAccent), of(accent), of(text)});
    for (auto id = static_cast<int>(background); id < static_cast<int>(count); ++id)
        setColour(id, of(static_cast<LookColour>(id)));
    setColour(juce::Label::textColourId, of(text));
    setColour(juce::Label::textWhenEditingColourId, of(text));
    setColour(juce::TextEditor::focusedOutlineColourId, of(accent));
    setColour(juce::TextEditor::highlightColourId, of(accent).withAlpha(0.35f));
    setColour(juce::TextEditor::highlightedTextColourId, of(text));
    setColour(juce::ComboBox::backgroundColourId, of(background));
    setColour(juce::ComboBox::arrowColourId, of(dimText));
    setColour(juce::TextButton::buttonColourId, of(background));
    setColour(juce::TextButton::buttonOnColourId, of(accent));
    setColour(juce::TextButton::textColourOnId, of(onAccent));
    setColour(juce::CaretComponent::caretColourId, of(text));
}

juce::Font Look::textFont(float height) {
    return juce::Font(juce::FontOptions(height));
}

juce::Font Look::headingFont(float height) {
    return juce::Font(juce::FontOptions(height, juce::Font::bold));
}

void Look::showModulation(juce::Slider& slider, std::optional<juce::Range<double>> places) {
    if (modulatedPlaces(slider) == places)
        return;
    auto& properties = slider.getProperties();
    if (places) {
        properties.set(modulatedFrom, places->getStart());
        properties.set(modulatedTo, places->getEnd());
    } else
        properties.remove(modulatedFrom);
    slider.repaint();
}

void Look::drawLinearSlider(juce::Graphics& g,
                            int x,
                            int y,
                            int width,
                            int height,
                            float thumb,
                            float,
                            float,
                            juce::Slider::SliderStyle,
                            juce::Slider& slider) {
    constexpr float thickness = 4, knob = 6;
    const float middle = static_cast<float>(y) + static_cast<float>(height) / 2;
    const juce::Rectangle<float> track(static_cast<float>(x), middle - thickness / 2,
                                       static_cast<float>(width), thickness);
    const bool lively = slider.isMouseOverOrDragging() || slider.hasKeyboardFocus(true);
    g.setColour(colourOf(slider, LookColour::outline));
    g.fillRoundedRectangle(track, thickness / 2);
    g.setColour(colourOf(slider, LookColour::accent).withMultipliedAlpha(lively ? 1.0f : 0.75f));
    g.fillRoundedRectangle(track.withRight(thumb), thickness / 2);
    g.fillEllipse(juce::Rectangle<float>(2 * knob, 2 * knob).withCentre({thumb, middle}));
    if (const auto moved = modulatedPlaces(slider)) {
        const auto xAt = [&](double place) {
            return track.getX() + track.getWidth() * static_cast<float>(place);
        };
        g.setColour(colourOf(slider, LookColour::text));
        g.fillRect(
            juce::Rectangle<float>(track.getX(),
                                   std::min(middle + knob + 1, static_cast<float>(y + height) - 2),
                                   track.getWidth(), 2)
                .withLeft(xAt(moved->getStart()))
                .withRight(xAt(moved->getEnd())));
    }
}

/// The arc runs from the value that a reset gives to the current one.
void Look::drawRotarySlider(juce::Graphics& g,
                            int x,
                            int y,
                            int width,
                            int height,
                            float place,
                            float startAngle,
                            float endAngle,
                            juce::Slider& slider) {
    constexpr float thickness = 5;
    const auto area = juce::Rectangle<int>(x, y, width, height).toFloat();
    const float size = std::min({area.getWidth(), area.getHeight(), 92.0f});
    const float radius = size / 2 - thickness, middleX = area.getCentreX();
    const float middleY = area.getCentreY();
    const auto angleAt = [&](double share) {
        return startAngle + static_cast<float>(share) * (endAngle - startAngle);
    };
    const auto arcAt = [&](float distance, float stroke, float from, float to,
                           juce::Colour colour) {
        juce::Path path;
        path.addCentredArc(middleX, middleY, distance, distance, 0, from, to, true);
        g.setColour(colour);
        g.strokePath(path, {stroke, juce::PathStrokeType::curved, juce::PathStrokeType::rounded});
    };
    const auto arc = [&](float from, float to, juce::Colour colour) {
        arcAt(radius, thickness, from, to, colour);
    };
    const bool lively = slider.isMouseOverOrDragging() || slider.hasKeyboardFocus(true);
    const auto accent = colourOf(slider, LookColour::accent);
    const float angle = angleAt(place);
    const float origin =
        angleAt(slider.valueToProportionOfLength(slider.getDoubleClickReturnValue()));
    arc(startAngle, endAngle, colourOf(slider, LookColour::outline));
    if (std::abs(angle - origin) > 1e-3f)
        arc(std::min(angle, origin), std::max(angle, origin), accent);
    if (const auto moved = modulatedPlaces(slider))
        arcAt(size / 2 - 1, 2, angleAt(moved->getStart()), angleAt(moved->getEnd()),
              colourOf(slider, LookColour::text));

    const auto face =
        juce::Rectangle<float>(2 * (radius - thickness - 1), 2 * (radius - thickness - 1))
            .withCentre({middleX, middleY});
    const auto back = colourOf(slider, LookColour::background);
    g.setGradientFill({back.brighter(0.25f), face.getX(), face.getY(), back.darker(0.15f),
                       face.getX(), face.getBottom(), false});
    g.fillEllipse(face);
    g.setColour(lively ? accent : colourOf(slider, LookColour::outline));
    g.drawEllipse(face, 1.2f);
    const auto at = [&](float distance) {
        return juce::Point<float>(middleX, middleY).getPointOnCircumference(distance, angle);
    };
    g.setColour(lively ? accent : colourOf(slider, LookColour::text));
    g.drawLine({at(face.getWidth() * 0.22f), at(face.getWidth() / 2 - 3)}, 2.5f);
}

void Look::drawToggleButton(juce::Graphics& g, juce::ToggleButton& button, bool highlighted, bool) {
    constexpr float height = 16;
    const auto area = button.getLocalBounds().toFloat();
    const auto track = juce::Rectangle<float>(2 * height - 2, height)
                           .withCentre({area.getRight() - height, area.getCentreY()});
    const bool on = button.getToggleState();
    const auto colour =
        on ? colourOf(button, LookColour::accent) : colourOf(button, LookColour::outline);
    g.setColour(highlighted ? colour.brighter(0.15f) : colour);
    g.fillRoundedRectangle(track, height / 2);
    g.setColour(on ? colourOf(button, LookColour::onAccent)
                   : colourOf(button, LookColour::dimText));
    const auto side = on ? track.withLeft(track.getRight() - height) : track.withWidth(height);
    g.fillEllipse(side.reduced(3));
    g.setColour(colourOf(button, LookColour::text));
    g.setFont(textFont());
    g.drawText(button.getButtonText(), area.withRight(track.getX() - 6),
               juce::Justification::centredRight, true);
}

/// JUCE's own large sign stands behind the text. A bar marks the box instead.
void Look::drawAlertBox(juce::Graphics& g,
                        juce::AlertWindow& alert,
                        const juce::Rectangle<int>&,
                        juce::TextLayout& text) {
    auto area = alert.getLocalBounds();
    g.fillAll(colourOf(current, LookColour::panel));
    g.setColour(colourOf(current, LookColour::outline));
    g.drawRect(area);
    const bool warns = alert.getAlertType() == juce::MessageBoxIconType::WarningIcon;
    g.setColour(colourOf(current, warns ? LookColour::error : LookColour::accent));
    g.fillRect(area.removeFromLeft(4));
    text.draw(g, area.withTrimmedTop(30)
                     .withTrimmedBottom(getAlertWindowButtonHeight() + 20)
                     .reduced(24, 0)
                     .toFloat());
}

juce::Button* Look::createDocumentWindowButton(int type) {
    if (type == juce::DocumentWindow::closeButton)
        return new IconButton("Close", icons::close());
    if (type == juce::DocumentWindow::minimiseButton)
        return new IconButton("Minimise", icons::minimise());
    return LookAndFeel_V4::createDocumentWindowButton(type);
}

void Look::drawResizableWindowBorder(juce::Graphics& g,
                                     int width,
                                     int height,
                                     const juce::BorderSize<int>&,
                                     juce::ResizableWindow&) {
    g.setColour(colourOf(current, LookColour::outline));
    g.drawRect(0, 0, width, height);
}

void Look::drawFileBrowserRow(juce::Graphics& g,
                              int width,
                              int height,
                              const juce::File&,
                              const juce::String& name,
                              juce::Image*,
                              const juce::String& size,
                              const juce::String& time,
                              bool isFolder,
                              bool isSelected,
                              int,
                              juce::DirectoryContentsDisplayComponent&) {
    using enum LookColour;
    const auto colour = [&](LookColour usual) {
        return colourOf(current, isSelected ? onAccent : usual);
    };
    auto area = juce::Rectangle<int>(width, height);
    if (isSelected) {
        g.setColour(colourOf(current, accent));
        g.fillRect(area);
    }
    const auto square = area.removeFromLeft(32).toFloat().withSizeKeepingCentre(16, 16);
    g.setColour(colour(isFolder ? accent : dimText));
    g.fillPath(
        isFolder ? icons::folder() : icons::sheet(),
        juce::AffineTransform::scale(square.getWidth()).translated(square.getX(), square.getY()));
    g.setFont(textFont());
    constexpr int widthForDetails = 450, detail = 130;
    if (!isFolder && width > widthForDetails) {
        g.setColour(colour(dimText));
        g.drawText(time, area.removeFromRight(detail).withTrimmedRight(8),
                   juce::Justification::centredRight);
        g.drawText(size, area.removeFromRight(detail / 2), juce::Justification::centredRight);
    }
    g.setColour(colour(text));
    g.drawFittedText(name, area, juce::Justification::centredLeft, 1, 0.8f);
}

void drawSelectedRow(juce::Graphics& g, juce::Rectangle<int> row, const juce::ListBox& list) {
    g.setColour(colourOf(list, LookColour::outline).withMultipliedAlpha(0.7f));
    g.fillRoundedRectangle(row.toFloat(), 4);
    if (list.hasKeyboardFocus(true)) {
        g.setColour(colourOf(list, LookColour::accent));
        g.drawRoundedRectangle(row.toFloat().reduced(0.75f), 4, 1.5f);
    }
}

void recolourTexts(juce::Component& part) {
    if (auto* editor = dynamic_cast<juce::TextEditor*>(&part)) {
        editor->applyColourToAllText(editor->findColour(juce::TextEditor::textColourId), false);
        editor->setTextToShowWhenEmpty(editor->getTextToShowWhenEmpty(),
                                       colourOf(*editor, LookColour::dimText));
    }
    for (auto* child : part.getChildren())
        recolourTexts(*child);
}

} // namespace idiophone
