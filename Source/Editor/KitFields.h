// The fields of one part of a kit: keys, velocities, level, choke group, output,
// material and mallet.
#pragma once

#include "Editor/KitText.h"
#include "Editor/Look.h"

#include <algorithm>
#include <array>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <numeric>
#include <optional>

namespace idiophone {

/// Needs at least 340 x `height` pixels.
class KitFields final : public juce::Component {
public:
    static constexpr int height = 82;

    KitFields() {
        describe(lowestKey, "From key", "Lowest key of the part", "such as C2, F#3 or 36");
        describe(highestKey, "To key", "Highest key of the part", "such as C2, F#3 or 36");
        describe(softest, "From velocity", "Lowest velocity of the part", "1 to 127");
        describe(hardest, "To velocity", "Highest velocity of the part", "1 to 127");
        describe(level, "Level", "Level of the part", "in dB, -40 to 40");
        describe(choke, "Choke group", "Choke group of the part",
                 "a strike on a key of the group damps its other keys");
        describe(
            output, "Output", "Output of the part",
            "where a host takes several, and Outputs is Kit parts; Auto takes one after the other");
        describe(material, "Material", "Material of the part",
                 "a material that the Material page does not change");
        describe(mallet, "Mallet", "Mallet of the part",
                 "a mallet that the Strike page does not change");
        // A range that would be empty shrinks to the typed end.
        follow(lowestKey, parseNoteName, [](KitView::Part& part, int note) {
            part.highestNote = std::max(part.lowestNote = note, part.highestNote);
        });
        follow(highestKey, parseNoteName, [](KitView::Part& part, int note) {
            part.lowestNote = std::min(part.highestNote = note, part.lowestNote);
        });
        follow(softest, parseVelocity, [](KitView::Part& part, int velocity) {
            part.highestVelocity = std::max(part.lowestVelocity = velocity, part.highestVelocity);
        });
        follow(hardest, parseVelocity, [](KitView::Part& part, int velocity) {
            part.lowestVelocity = std::min(part.highestVelocity = velocity, part.lowestVelocity);
        });
        follow(level, parseLevel, [](KitView::Part& part, double db) { part.levelDb = db; });
        choke.list.addItem("None", soundId);
        for (int group = 1; group <= KitView::chokeGroups; ++group)
            choke.list.addItem(juce::String(group), soundId + group);
        output.list.addItem("Auto", soundId);
        for (int number = 1; number <= KitView::outputs; ++number)
            output.list.addItem(juce::String(number), soundId + number);
        fill(material.list, ParameterId::material);
        fill(mallet.list, ParameterId::mallet);
        for (auto* field : {&choke, &output, &material, &mallet})
            field->list.onChange = [this] { followLists(); };
    }

    /// Called with the part that the user wants.
    std::function<void(const KitView::Part&)> onChange;

    void show(const KitView::Part& part) {
        const auto write = [](Typed& field, const juce::String& text) {
            if (!field.text.isBeingEdited())
                field.text.setText(text, juce::dontSendNotification);
        };
        const auto choose = [](Listed& field, const std::optional<int>& choice) {
            field.list.setSelectedId(choice ? firstChoiceId + *choice : soundId,
                                     juce::dontSendNotification);
        };
        shown = part;
        write(lowestKey, noteName(part.lowestNote));
        write(highestKey, noteName(part.highestNote));
        write(softest, juce::String(part.lowestVelocity));
        write(hardest, juce::String(part.highestVelocity));
        write(level, levelText(part.levelDb));
        choke.list.setSelectedId(soundId + part.chokeGroup, juce::dontSendNotification);
        output.list.setSelectedId(soundId + part.output, juce::dontSendNotification);
        choose(material, part.material);
        choose(mallet, part.mallet);
    }

    void resized() override {
        auto area = getLocalBounds();
        place<4>(area.removeFromTop(height / 2), {&lowestKey, &highestKey, &softest, &hardest},
                 {1, 1, 1, 1});
        place<5>(area, {&level, &choke, &output, &material, &mallet}, {3, 4, 3, 5, 5});
    }
    void lookAndFeelChanged() override {
        for (auto* field : {&lowestKey, &highestKey, &softest, &hardest, &level}) {
            field->text.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
            field->text.setColour(juce::Label::outlineColourId,
                                  colourOf(*this, LookColour::outline));
        }
        for (auto* child : getChildren())
            if (auto* name = dynamic_cast<TextLabel*>(child))
                name->setColour(juce::Label::textColourId, colourOf(*this, LookColour::dimText));
    }

private:
    // Numbers of items: the sound's own choice or no group, then choices or groups.
    static constexpr int soundId = 1, firstChoiceId = 2;

    struct Field {
        virtual ~Field() = default;
        virtual juce::Component& control() = 0;
        TextLabel name;
    };
    struct Typed final : Field {
        juce::Component& control() override { return text; }
        juce::Label text;
    };
    struct Listed final : Field {
        juce::Component& control() override { return list; }
        juce::ComboBox list;
    };

    void describe(Field& field,
                  const juce::String& name,
                  const juce::String& title,
                  const juce::String& meaning) {
        field.name.setText(name, juce::dontSendNotification);
        field.name.setFont(Look::textFont(12.5f));
        field.name.setAccessible(false);
        field.name.setInterceptsMouseClicks(false, false);
        field.control().setTitle(title);
        if (auto* client = dynamic_cast<juce::SettableTooltipClient*>(&field.control()))
            client->setTooltip(title + ": " + meaning);
        showParts(*this, field.name, field.control());
    }
    static void fill(juce::ComboBox& list, ParameterId parameter) {
        list.addItem("As the sound", soundId);
        const auto count = static_cast<int>(choiceNames(parameter).size());
        for (int choice = 0; choice < count; ++choice)
            if (parameter != ParameterId::material || choice != customMaterial)
                list.addItem(choiceText(parameter, choice), firstChoiceId + choice);
    }
    template <std::size_t Count>
    static void place(juce::Rectangle<int> row,
                      const std::array<Field*, Count>& fields,
                      const std::array<int, Count>& shares) {
        constexpr int gap = 6, nameHeight = 16, between = 3;
        row.removeFromBottom(between);
        int left = std::accumulate(shares.begin(), shares.end(), 0);
        for (std::size_t i = 0; i < fields.size(); ++i) {
            auto cell = row.removeFromLeft(row.getWidth() * shares[i] / left);
            left -= shares[i];
            if (left > 0)
                cell.removeFromRight(gap);
            fields[i]->name.setBounds(cell.removeFromTop(nameHeight));
            fields[i]->control().setBounds(cell);
        }
    }

    static std::optional<int> parseVelocity(const juce::String& typed) {
        const auto text = typed.trim();
        return text.isNotEmpty() && text.containsOnly("0123456789")
                   ? std::optional(std::clamp(text.getIntValue(), 1, 127))
                   : std::nullopt;
    }
    static std::optional<double> parseLevel(const juce::String& typed) {
        return parseUnclamped(parameterInfo(ParameterId::level), typed.toStdString());
    }
    /// Asks for the part that `set` makes of the typed text. A text that is no figure changes
    /// nothing.
    template <class Parse, class Set>
    void follow(Typed& field, Parse parse, Set set) {
        field.text.setEditable(true);
        field.text.onTextChange = [this, &field, parse, set] {
            auto wanted = shown;
            if (const auto figure = parse(field.text.getText()))
                set(wanted, *figure);
            ask(wanted);
        };
    }
    void followLists() {
        const auto chosen = [](const Listed& field) {
            const int id = field.list.getSelectedId();
            return id >= firstChoiceId ? std::optional(id - firstChoiceId) : std::nullopt;
        };
        auto wanted = shown;
        wanted.chokeGroup = choke.list.getSelectedId() - soundId;
        wanted.output = output.list.getSelectedId() - soundId;
        wanted.material = chosen(material);
        wanted.mallet = chosen(mallet);
        ask(wanted);
    }
    /// Shows the former figures until the part has the new ones.
    void ask(const KitView::Part& wanted) {
        show(shown);
        if (onChange != nullptr)
            onChange(wanted);
    }

    KitView::Part shown;
    Typed lowestKey, highestKey, softest, hardest, level;
    Listed choke, output, material, mallet;
};

} // namespace idiophone
