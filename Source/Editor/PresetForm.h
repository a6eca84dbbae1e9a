// A form that asks for a preset's details, for a new name, or for a confirmation.
#pragma once

#include "Editor/Look.h"
#include "Editor/PresetSearch.h"
#include "Editor/PresetShelf.h"
#include "Editor/Utf8.h"

#include <functional>
#include <initializer_list>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace idiophone {

/// Return answers, Escape cancels. Needs `neededHeight` and a width of at least 440 pixels.
class PresetForm final : public juce::Component {
public:
    PresetForm() {
        setFocusContainerType(FocusContainerType::keyboardFocusContainer);
        for (const auto& [label, hint] : {std::pair("Name", ""),
                                          {"Folder", "none"},
                                          {"Tags", "wood, bright, short"},
                                          {"Author", ""},
                                          {"Description", "What it is, in a sentence"}}) {
            auto field = std::make_unique<juce::TextEditor>();
            field->setTitle(label);
            field->setFont(Look::textFont());
            field->setIndents(6, 0);
            field->setJustification(juce::Justification::centredLeft);
            field->setSelectAllWhenFocused(true);
            field->setInputRestrictions(500);
            field->setTextToShowWhenEmpty(hint, {});
            field->onReturnKey = [this] { followReturn(); };
            field->onEscapeKey = [this] { juce::NullCheckedInvocation::invoke(onCancel); };
            field->onTextChange = [this] { followText(); };
            addChildComponent(*field);
            fields.push_back({.label = label, .editor = std::move(field), .labelArea = {}});
        }
        editor(nameField).setInputRestrictions(100);
        sentence.setFont(Look::textFont());
        sentence.setMinimumHorizontalScale(0.8f);
        yes.onClick = [this] {
            if (onAnswer != nullptr)
                onAnswer(details());
        };
        no.onClick = [this] { juce::NullCheckedInvocation::invoke(onCancel); };
        no.setTitle("Cancel");
        sentence.setTitle("Question");
        showParts(*this, sentence, yes, no);
    }

    std::function<void(const PresetDetails&)> onAnswer;
    std::function<void()> onCancel;

    void askForDetails(const PresetDetails& first) {
        setTitle("Save the sound");
        editor(nameField).setText(fromUtf8(first.name), false);
        editor(folderField).setText(fromUtf8(first.folder), false);
        editor(tagField).setText(tagLine(first.tags), false);
        editor(authorField).setText(fromUtf8(first.author), false);
        editor(descriptionField).setText(fromUtf8(first.description), false);
        sentence.setText({}, juce::dontSendNotification);
        name("Save", "Save");
        show({nameField, folderField, tagField, authorField, descriptionField});
    }
    void askForName(const juce::String& title, const std::string& first) {
        setTitle(title);
        editor(nameField).setText(fromUtf8(first), false);
        sentence.setText({}, juce::dontSendNotification);
        name("Rename", "Rename preset");
        show({nameField});
    }
    void askWhether(const juce::String& title, const juce::String& answer) {
        setTitle(title);
        name(answer, answer + " preset");
        show({});
        sentence.setText(title, juce::dontSendNotification);
    }
    /// Shows an error about the answer.
    void object(const juce::String& text) {
        sentence.setColour(juce::Label::textColourId, colourOf(*this, LookColour::error));
        sentence.setText(text, juce::dontSendNotification);
    }
    /// Says that the preset exists, and offers to replace it. Only the button replaces it; typing
    /// withdraws the offer.
    void objectToName(const PresetDetails& wanted) {
        object("There is already a preset '" + fromUtf8(wanted.name) + "'.");
        name("Replace", "Replace");
        offersToReplace = true;
    }
    bool isToReplace() const { return offersToReplace; }

    /// Answers as Return does, if the form asks for details.
    void save() {
        if (editor(descriptionField).isVisible())
            followReturn();
    }

    int neededHeight() const {
        int rows = 1;
        for (const auto& field : fields)
            rows += field.editor->isVisible() ? 1 : 0;
        return rows * rowHeight + (rows - 1) * gap + 2 * padding;
    }
    PresetDetails details() const {
        const auto text = [&](Place place) { return editor(place).getText().trim().toStdString(); };
        PresetDetails result{.name = text(nameField),
                             .folder = text(folderField),
                             .author = text(authorField),
                             .description = text(descriptionField),
                             .tags = {}};
        for (const auto& tag : juce::StringArray::fromTokens(editor(tagField).getText(), ",;", ""))
            if (tag.trim().isNotEmpty())
                result.tags.push_back(tag.trim().toStdString());
        return result;
    }
    void takeFocus() {
        if (editor(nameField).isVisible())
            editor(nameField).grabKeyboardFocus();
        else
            no.grabKeyboardFocus();
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::background));
        g.fillRoundedRectangle(getLocalBounds().toFloat(), 6);
        g.setColour(colourOf(*this, LookColour::dimText));
        g.setFont(Look::textFont());
        for (const auto& field : fields)
            if (field.editor->isVisible())
                g.drawText(field.label, field.labelArea, juce::Justification::centredLeft, false);
    }
    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        for (auto& field : fields) {
            if (!field.editor->isVisible())
                continue;
            auto row = area.removeFromTop(rowHeight);
            field.labelArea = row.removeFromLeft(labelWidth);
            field.editor->setBounds(row);
            area.removeFromTop(gap);
        }
        auto row = area.removeFromTop(rowHeight);
        no.setBounds(row.removeFromRight(buttonWidth));
        row.removeFromRight(gap);
        yes.setBounds(row.removeFromRight(buttonWidth));
        row.removeFromRight(gap);
        sentence.setBounds(row);
    }
    bool keyPressed(const juce::KeyPress& key) override {
        if (key != juce::KeyPress::escapeKey)
            return false;
        juce::NullCheckedInvocation::invoke(onCancel);
        return true;
    }

private:
    static constexpr int rowHeight = 26, gap = 5, padding = 10, labelWidth = 88, buttonWidth = 96;

    struct Field {
        juce::String label;
        std::unique_ptr<juce::TextEditor> editor;
        juce::Rectangle<int> labelArea;
    };
    enum Place { nameField, folderField, tagField, authorField, descriptionField };

    /// Answers on Return. While the form offers to replace a preset, Return is ignored, because a
    /// held key repeats.
    void followReturn() {
        if (!offersToReplace)
            yes.triggerClick();
    }
    /// Typing removes the error and the offer to replace.
    void followText() {
        sentence.setText({}, juce::dontSendNotification);
        if (std::exchange(offersToReplace, false))
            name("Save", "Save");
    }
    void name(const juce::String& answer, const juce::String& title) {
        yes.setButtonText(answer);
        yes.setTitle(title);
    }
    void show(std::initializer_list<Place> wanted) {
        offersToReplace = false;
        for (auto& field : fields)
            field.editor->setVisible(false);
        for (const auto place : wanted)
            editor(place).setVisible(true);
        sentence.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
        resized();
        repaint();
    }
    juce::TextEditor& editor(Place place) const { return *fields[place].editor; }

    std::vector<Field> fields;
    bool offersToReplace = false;
    juce::Label sentence;
    juce::TextButton yes, no{"Cancel"};
};

} // namespace idiophone
