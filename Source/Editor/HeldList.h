// A list of how an imported object can be held: its ends, the named groups of its mesh, a painted
// region.
#pragma once

#include "Editor/Utf8.h"
#include "Editor/WorkshopView.h"

#include <algorithm>
#include <iterator>
#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

class HeldList final : public juce::ComboBox {
    using Kind = HeldSettings::Kind;

public:
    /// Shows how the status's settings hold the object, and what else can.
    void show(const ImportStatus& status) {
        const auto& held = status.settings.held;
        auto next = choicesFor(status);
        if (next != choices) {
            choices = std::move(next);
            clear(juce::dontSendNotification);
            for (std::size_t i = 0; i < choices.size(); ++i)
                addItem(choices[i].text, static_cast<int>(i) + 1);
        }
        const auto found = std::ranges::find_if(choices, [&](const Choice& choice) {
            return choice.kind == held.kind &&
                   (held.kind != Kind::group || choice.group == held.group);
        });
        const auto item = found == choices.end() ? 0 : std::distance(choices.begin(), found) + 1;
        if (getSelectedId() != static_cast<int>(item))
            setSelectedId(static_cast<int>(item), juce::dontSendNotification);
    }

    /// Returns the settings with the selected choice. The painted places are kept for later.
    HeldSettings chosen(HeldSettings held) const {
        if (const auto index = static_cast<std::size_t>(getSelectedItemIndex());
            index < choices.size()) {
            held.kind = choices[index].kind;
            held.group = choices[index].group;
        }
        return held;
    }

private:
    struct Choice {
        Kind kind = Kind::free;
        std::string group = {};
        juce::String text = {};

        bool operator==(const Choice&) const = default;
    };

    /// The ends are named as they lie in the picture, where x goes to the right and z up.
    static std::vector<Choice> choicesFor(const ImportStatus& status) {
        static constexpr const char* ends[3][2] = {
            {"Left end", "Right end"}, {"Near end", "Far end"}, {"Lower end", "Upper end"}};
        const auto& sides = status.sidesMetres;
        const auto& [low, high] = ends[std::ranges::max_element(sides) - sides.begin()];
        std::vector<Choice> result{{.kind = Kind::free, .text = "Nowhere"},
                                   {.kind = Kind::lowEnd, .text = low},
                                   {.kind = Kind::highEnd, .text = high}};
        for (const auto& group : status.groups)
            result.push_back(
                {.kind = Kind::group, .group = group, .text = "Part: " + fromUtf8(group)});
        result.push_back({.kind = Kind::places, .text = "Painted region"});
        if (status.wasHeld)
            result.push_back({.kind = Kind::asBefore, .text = "As before"});
        return result;
    }

    std::vector<Choice> choices;
};

} // namespace idiophone
