// The list of the MIDI controllers that parameters have learned, with a button to remove each.
#pragma once

#include "Editor/Look.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace idiophone {

/// For the message thread. Also ends a pending learn with the preset and with the window.
class ControllerList final : public juce::Component, private juce::ListBoxModel {
public:
    explicit ControllerList(ProcessorView& processor) : view(processor) {
        setTitle("MIDI controllers");
        list.setTitle("Learned controllers");
        list.setModel(this);
        list.setRowHeight(rowHeight);
        list.setColour(juce::ListBox::backgroundColourId, juce::Colours::transparentBlack);
        close.setTitle("Close the list of controllers");
        close.setTooltip("Back to the pages (Escape)");
        close.onClick = [this] { juce::NullCheckedInvocation::invoke(onClose); };
        hint.setTitle("Hint");
        showParts(*this, list, close, hint);
    }
    ~ControllerList() override { view.controllers.stopLearning(); }

    std::function<void()> onClose;

    /// Call it regularly, also while the list is hidden.
    void refresh() {
        endLearningWithPreset();
        if (!isVisible())
            return;
        hint.setText(hintNow(), juce::dontSendNotification);
        if (auto now = assignedNow(); now != assigned) {
            assigned = std::move(now);
            list.updateContent();
        }
    }

    /// Takes the focus, so that Escape closes the list.
    void visibilityChanged() override {
        refresh();
        if (isShowing())
            close.grabKeyboardFocus();
    }
    void lookAndFeelChanged() override {
        hint.setColour(juce::Label::textColourId, colourOf(*this, LookColour::dimText));
    }
    bool keyPressed(const juce::KeyPress& key) override {
        if (!key.isKeyCode(juce::KeyPress::escapeKey))
            return false;
        juce::NullCheckedInvocation::invoke(onClose);
        return true;
    }
    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::panel));
        g.fillRoundedRectangle(getLocalBounds().toFloat(), 6);
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::headingFont(14.5f));
        g.drawText(getTitle(), heading, juce::Justification::centredLeft, false);
    }
    void resized() override {
        auto area = getLocalBounds().reduced(12, 8);
        area.setWidth(juce::jmin(area.getWidth(), maximumWidth));
        heading = area.removeFromTop(28);
        close.setBounds(heading.removeFromRight(80).reduced(0, 2));
        hint.setBounds(area.removeFromTop(24));
        list.setBounds(area.withTrimmedTop(6));
    }

private:
    static constexpr int rowHeight = 30, maximumWidth = 560;

    struct Assigned {
        int controller;
        ParameterId parameter;

        auto operator<=>(const Assigned&) const = default;
    };

    class Row final : public juce::Component {
    public:
        explicit Row(MidiLearnView& midi) : controllers(midi) {
            // The next refresh removes the row, which must not happen within its button's click.
            remove.onClick = [this] { controllers.forgetController(shown.parameter); };
            addAndMakeVisible(remove);
        }

        void show(const Assigned& row) {
            shown = row;
            const auto name = fromUtf8(parameterInfo(row.parameter).name);
            const auto number = "Controller " + juce::String(row.controller);
            text = number + fromUtf8("  \xe2\x86\x92  ") + name; // →
            repaint();
            setTitle(number + " moves " + name);
            remove.setTitle("Remove controller " + juce::String(row.controller) + " from " + name);
            remove.setTooltip(remove.getTitle());
        }
        void paint(juce::Graphics& g) override {
            g.setColour(colourOf(*this, LookColour::text));
            g.setFont(Look::textFont());
            g.drawText(text, getLocalBounds().withRight(remove.getX() - 8),
                       juce::Justification::centredLeft);
        }
        void resized() override {
            remove.setBounds(getLocalBounds().removeFromRight(80).reduced(0, 2));
        }

    private:
        MidiLearnView& controllers;
        Assigned shown{};
        juce::String text;
        juce::TextButton remove{"Remove"};
    };

    int getNumRows() override { return static_cast<int>(assigned.size()); }
    void paintListBoxItem(int, juce::Graphics&, int, int, bool) override {}
    juce::Component* refreshComponentForRow(int row, bool, juce::Component* existing) override {
        std::unique_ptr<juce::Component> former(existing);
        if (row < 0 || row >= getNumRows())
            return nullptr;
        auto shown = former == nullptr ? std::make_unique<Row>(view.controllers)
                                       : std::unique_ptr<Row>(static_cast<Row*>(former.release()));
        shown->show(assigned[static_cast<std::size_t>(row)]);
        return shown.release();
    }
    juce::String getNameForRow(int row) override {
        return row < getNumRows()
                   ? fromUtf8(parameterInfo(assigned[static_cast<std::size_t>(row)].parameter).name)
                   : juce::String();
    }

    std::vector<Assigned> assignedNow() const {
        std::vector<Assigned> result;
        for (const auto& info : parameterTable())
            if (const auto number = view.controllers.controllerOf(info.parameter))
                result.push_back({*number, info.parameter});
        std::ranges::sort(result);
        return result;
    }
    void endLearningWithPreset() {
        if (!view.controllers.learningParameter())
            return learnsFor.reset();
        auto name = view.presets.playingPreset().details.name; // an own strike path has no id
        if (learnsFor && *learnsFor != name)
            return view.controllers.stopLearning();
        learnsFor = std::move(name);
    }
    juce::String hintNow() const {
        if (const auto pending = view.controllers.learningParameter())
            return "Move the MIDI controller to assign to " +
                   fromUtf8(parameterInfo(*pending).name);
        return "To add one, right-click a control and choose Learn a MIDI controller";
    }

    ProcessorView& view;
    std::optional<std::string> learnsFor; ///< the preset's name, while a learn is pending
    std::vector<Assigned> assigned;       ///< as shown
    juce::ListBox list;
    juce::TextButton close{"Close"};
    TextLabel hint;
    juce::Rectangle<int> heading;
};

} // namespace idiophone
