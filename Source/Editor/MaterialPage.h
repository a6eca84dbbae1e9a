// The page of the objects' material: pad, named materials, figures, a swap with the previous
// material, and a form that makes one from a recording.
#pragma once

#include "Editor/ChoiceList.h"
#include "Editor/ControlMenu.h"
#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/MaterialForm.h"
#include "Editor/MaterialPad.h"
#include "Editor/NamedEdit.h"
#include "Editor/ParameterColumns.h"
#include "Editor/ParameterControl.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace idiophone {

class MaterialPage final : public DeckPage {
public:
    explicit MaterialPage(ProcessorView& processor)
        : DeckPage("Material"), view(processor), pad(processor),
          list(parameterInfo(ParameterId::material), processor),
          listMenu(list, parameterInfo(ParameterId::material), processor),
          match(parameterInfo(ParameterId::matchLoudness), processor),
          keep(parameterInfo(ParameterId::keepPitch), processor), form(processor.materialFits) {
        for (const std::string_view group : {"Material figures", "Extent"})
            for (const auto& info : parameterTable())
                if (info.group == group)
                    figures.push_back(std::make_unique<ParameterControl>(info, processor));
        addButton(former, "Material before", "Swap with the material before the last change",
                  [this] { swapMaterials(); });
        addButton(recorded, "Material from a recording",
                  "Make a material from the recording of a strike", [this] { showForm(true); });
        form.onClose = [this] {
            showForm(false);
            recorded.grabKeyboardFocus();
        };
        showParts(*this, list, pad, match, keep);
        for (auto& figure : figures)
            addAndMakeVisible(*figure);
        addChildComponent(form);
        now = before = figuresNow();
    }

    void refresh() override {
        watch();
        pad.refresh();
        list.refresh();
        match.refresh();
        keep.refresh();
        for (auto& figure : figures)
            figure->refresh();
        if (form.isVisible())
            form.refresh();
    }
    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        form.setBounds(area);
        const int half = (area.getWidth() - gap) / 2;
        auto top = area.removeFromTop(lineHeight);
        keep.setBounds(top.removeFromRight(half));
        top.removeFromRight(gap);
        former.setBounds(top.removeFromRight(46).reduced(0, 1));
        list.setBounds(top.withTrimmedRight(6));
        auto left = area.removeFromLeft(half);
        area.removeFromLeft(gap);
        match.setBounds(left.removeFromBottom(lineHeight));
        left.removeFromTop(4);
        recorded.setBounds(left.removeFromTop(lineHeight - 2));
        left.removeFromTop(6);
        pad.setBounds(left.withTrimmedBottom(4));
        const int row =
            std::clamp(area.getHeight() / static_cast<int>(figures.size()), lowestRow, highestRow);
        for (auto& figure : figures)
            figure->setBounds(area.removeFromTop(row));
    }

    /// The menu of the list for a right click or Shift+F10.
    juce::PopupMenu materialMenu() const { return listMenu.popup(); }

    /// Shows the form of a material from a recording instead of the page's parts, or these again.
    void showForm(bool shows) {
        for (auto* part : getChildren())
            part->setVisible((part == &form) == shows);
        if (shows)
            form.refresh();
    }

    /// Swaps the current material with the one before the last change.
    void swapMaterials() {
        watch();
        const auto wanted = before;
        before = now;
        now = wanted;
        const NamedEdit step(view.history, parameterInfo(ParameterId::material).name);
        for (const auto parameter : parameters)
            view.parameters.beginChange(parameter);
        // The choice is last in `parameters`, after the figures that it shows.
        for (std::size_t i = 0; i < parameters.size(); ++i)
            view.parameters.change(parameters[i], wanted[i]);
        for (const auto parameter : parameters)
            view.parameters.endChange(parameter);
        ticksUnchanged = settledTicks;
        refresh();
    }

private:
    /// Changes less than this many timer ticks apart count as one change.
    static constexpr int settledTicks = 12;
    static constexpr int gap = 16, lowestRow = 34, highestRow = 50, lineHeight = 26;

    static constexpr auto& parameters = customMaterialParameters;
    using Figures = std::array<double, parameters.size()>;

    Figures figuresNow() const {
        Figures result{};
        std::ranges::transform(parameters, result.begin(),
                               [&](ParameterId id) { return view.parameters.value(id); });
        return result;
    }
    void watch() {
        const auto fresh = figuresNow();
        if (view.instrument.instrumentNumber() != instrument) {
            instrument = view.instrument.instrumentNumber();
            now = before = fresh;
        } else if (fresh != now) {
            if (ticksUnchanged >= settledTicks)
                before = now;
            now = fresh;
            ticksUnchanged = 0;
        } else {
            ticksUnchanged = std::min(ticksUnchanged + 1, settledTicks);
        }
        former.setEnabled(before != now);
    }

    ProcessorView& view;
    MaterialPad pad;
    ChoiceList list;
    ControlMenu listMenu;
    ParameterControl match, keep;
    juce::TextButton former{"A/B"}, recorded{"From a recording..."};
    MaterialForm form;
    std::vector<std::unique_ptr<ParameterControl>> figures;
    Figures now, before;
    int instrument = -1;
    int ticksUnchanged = 0;
};

} // namespace idiophone
