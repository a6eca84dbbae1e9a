// A form that asks for a preset's details, for a new name, or for a confirmation.
#pragma once

#include "Editor/PresetShelf.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

/// Return answers, Escape cancels. Needs `neededHeight` and a width of at least 440 pixels.
class PresetForm final : public juce::Component {
public:
    PresetForm();

    std::function<void(const PresetDetails&)> onAnswer;
    std::function<void()> onCancel;

    void askForDetails(const PresetDetails& first);
    void askForName(const juce::String& title, const std::string& first);
    void askWhether(const juce::String& title, const juce::String& yes);
    /// Shows an error about the answer.
    void object(const juce::String& sentence);
    /// Says that the preset exists, and offers to replace it. Only the button replaces it; typing
    /// withdraws the offer.
    void objectToName(const PresetDetails& details);
    bool isToReplace() const { return offersToReplace; }

    /// Answers as Return does, if the form asks for details.
    void save();

    int neededHeight() const;
    PresetDetails details() const;
    void takeFocus();

    void paint(juce::Graphics& g) override;
    void resized() override;
    bool keyPressed(const juce::KeyPress& key) override;

private:
    struct Field {
        juce::String label;
        std::unique_ptr<juce::TextEditor> editor;
        juce::Rectangle<int> labelArea;
    };
    enum Place { nameField, folderField, tagField, authorField, descriptionField };

    void followReturn();
    void followText();
    void name(const juce::String& answer, const juce::String& title);
    void show(std::initializer_list<Place> fields);
    juce::TextEditor& editor(Place place) const { return *fields[place].editor; }

    std::vector<Field> fields;
    bool offersToReplace = false;
    juce::Label sentence;
    juce::TextButton yes, no{"Cancel"};
};

} // namespace idiophone
