#include "Editor/PresetForm.h"

#include "Editor/Look.h"
#include "Editor/PresetSearch.h"
#include "Editor/Utf8.h"

namespace idiophone {
namespace {

constexpr int rowHeight = 26, gap = 5, padding = 10, labelWidth = 88, buttonWidth = 96;

} // namespace

PresetForm::PresetForm() {
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
        field->setTextToShowWhenEmpty(hint, juce::Colours::grey);
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

void PresetForm::name(const juce::String& answer, const juce::String& title) {
    yes.setButtonText(answer);
    yes.setTitle(title);
}

/// Answers on Return. While the form offers to replace a preset, Return is ignored, because a held
/// key repeats.
void PresetForm::followReturn() {
    if (!offersToReplace)
        yes.triggerClick();
}

void PresetForm::save() {
    if (editor(descriptionField).isVisible())
        followReturn();
}

/// Typing removes the error and the offer to replace.
void PresetForm::followText() {
    sentence.setText({}, juce::dontSendNotification);
    if (std::exchange(offersToReplace, false))
        name("Save", "Save");
}

void PresetForm::show(std::initializer_list<Place> wanted) {
    offersToReplace = false;
    for (auto& field : fields)
        field.editor->setVisible(false);
    for (const auto place : wanted)
        editor(place).setVisible(true);
    sentence.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
    resized();
    repaint();
}

void PresetForm::askForDetails(const PresetDetails& first) {
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

void PresetForm::askForName(const juce::String& title, const std::string& first) {
    setTitle(title);
    editor(nameField).setText(fromUtf8(first), false);
    sentence.setText({}, juce::dontSendNotification);
    name("Rename", "Rename preset");
    show({nameField});
}

void PresetForm::askWhether(const juce::String& title, const juce::String& answer) {
    setTitle(title);
    name(answer, answer + " preset");
    show({});
    sentence.setText(title, juce::dontSendNotification);
}

void PresetForm::object(const juce::String& text) {
    sentence.setColour(juce::Label::textColourId, colourOf(*this, LookColour::error));
    sentence.setText(text, juce::dontSendNotification);
}

void PresetForm::objectToName(const PresetDetails& wanted) {
    object("There is already a preset '" + fromUtf8(wanted.name) + "'.");
    name("Replace", "Replace");
    offersToReplace = true;
}

PresetDetails PresetForm::details() const {
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

void PresetForm::takeFocus() {
    if (editor(nameField).isVisible())
        editor(nameField).grabKeyboardFocus();
    else
        no.grabKeyboardFocus();
}

int PresetForm::neededHeight() const {
    int rows = 1;
    for (const auto& field : fields)
        rows += field.editor->isVisible() ? 1 : 0;
    return rows * rowHeight + (rows - 1) * gap + 2 * padding;
}

bool PresetForm::keyPressed(const juce::KeyPress& key) {
    if (key != juce::KeyPress::escapeKey)
        return false;
    juce::NullCheckedInvocation::invoke(onCancel);
    return true;
}

void PresetForm::paint(juce::Graphics& g) {
    g.setColour(colourOf(*this, LookColour::background));
    g.fillRoundedRectangle(getLocalBounds().toFloat(), 6);
    g.setColour(colourOf(*this, LookColour::dimText));
    g.setFont(Look::textFont());
    for (const auto& field : fields)
        if (field.editor->isVisible())
            g.drawText(field.label, field.labelArea, juce::Justification::centredLeft, false);
}

void PresetForm::resized() {
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

} // namespace idiophone
